#pragma once

#include <functional>
#include <string>

#include "demos/atlas/canvas.h"

namespace demos::atlas {

/// A figure: its name, its size in pixels, and how it is drawn.
struct Figure {
  std::string name;
  Point size;
  std::function<void(Canvas&)> draw;
  /// One line: what was simulated for it, and how the result agrees with the theory.
  std::string measured;
};

/// Writes FOLDER/NAME.png and FOLDER/NAME.svg from the same drawing. No file is left half-written.
/// Throws std::runtime_error that names the file.
void writeFigure(const std::string& folder, const Figure& figure);

}  // namespace demos::atlas
