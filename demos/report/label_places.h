#pragma once

#include <string>
#include <vector>

namespace demos::report {

/// A name for the point (x, y) of a panel, in shares of its width and height, and where the name
/// begins (left, middle).
struct Label {
  std::string text, colour;
  double x, y;
  double textX = 0, textY = 0;
};

/// Something drawn that names should not cover.
struct Dot {
  double x, y;
};

/// Puts every name beside its point: to the right if possible, and higher or lower if that place is
/// taken. `letter` and `line` are the width of a letter and the height of a line.
std::vector<Label> placeLabels(std::vector<Label> labels, const std::vector<Dot>& dots,
                               double letter, double line);

}  // namespace demos::report
