#pragma once

namespace demos::atlas {

struct Color {
  double red, green, blue;
};

/// `share` of the colour, the rest white.
constexpr Color tint(Color color, double share) {
  return {1 - share * (1 - color.red), 1 - share * (1 - color.green), 1 - share * (1 - color.blue)};
}

constexpr Color white{1, 1, 1};
constexpr Color ink{0.13, 0.15, 0.18};
constexpr Color pale{0.45, 0.47, 0.50};  ///< axes, captions, construction lines

/// One colour for each outcome, the same in all figures. They differ in lightness as well as in
/// hue, so that they can be told apart in greyscale and by colour-blind readers (after Paul Tol's
/// bright scheme).
constexpr Color keptAll{0.16, 0.36, 0.62};     ///< all contacts kept; stuck
constexpr Color keptFirst{0.87, 0.62, 0.05};   ///< contact 1 only; slides one way
constexpr Color keptSecond{0.69, 0.31, 0.55};  ///< contact 2 only; slides the other way
constexpr Color keptNone{0.56, 0.57, 0.59};    ///< released

/// The share of a region's colour that fills its area: dots in the full colour stand out on it.
constexpr double regionTint = 0.34;

}  // namespace demos::atlas
