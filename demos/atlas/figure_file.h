#pragma once

#include <functional>
#include <string>

#include "demos/atlas/canvas.h"

namespace demos::atlas {

/// A figure: what it is called, how large it is in pixels, and how it is drawn.
struct Figure {
  std::string name;
  Point size;
  std::function<void(Canvas&)> draw;
  /// One line: what was simulated for it, and how that agrees with the theory.
  std::string measured;
};

/// Writes FOLDER/NAME.png and FOLDER/NAME.svg, both by the same drawing. Nothing is left
/// half-written. Throws std::runtime_error that names the file.
void writeFigure(const std::string& folder, const Figure& figure);

}  // namespace demos::atlas
