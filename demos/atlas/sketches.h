#pragma once

#include <array>

#include "demos/atlas/canvas.h"

/// Small drawings of the bodies that the figures are about.
namespace demos::atlas {

constexpr Color wallColor{0.36, 0.38, 0.41};

/// Two planes with unit normals in a plane figure (x right, y up) and a bead that touches both.
struct AngleSketch {
  std::array<Eigen::Vector2d, 2> normals;
  Point bead;     ///< its centre when it touches both planes
  double radius;  ///< of the bead, pixels
  double wall;    ///< length of each plane beyond its contact, pixels

  Point contact(int i) const { return bead - radius * up(normals[std::size_t(i)]); }
  Point apex() const;
  /// From y up to y down.
  static Point up(const Eigen::Vector2d& v) { return {v.x(), -v.y()}; }
};

/// The normals of planes that open upwards by `opening` radians; contact 1 is the right one.
std::array<Eigen::Vector2d, 2> uprightAngle(double opening);

void drawPlanes(Canvas& canvas, const AngleSketch& sketch);
void drawBead(Canvas& canvas, const Point& centre, double radius);
/// Draws where the bead would be in a motion that does not happen.
void drawGhostBead(Canvas& canvas, const Point& centre, double radius, Color color);

/// `angle` from the horizontal, counter-clockwise.
Path rodOutline(const Point& centre, double angle, double halfLength, double thickness);
void drawRod(Canvas& canvas, const Point& centre, double angle, double halfLength,
             double thickness);
void drawGround(Canvas& canvas, const Point& from, const Point& to, double depth);
/// A round support that carries at `top`.
void drawSupport(Canvas& canvas, const Point& top);

/// Round marks "1" and "2" and the like.
void drawNumber(Canvas& canvas, const Point& centre, const std::string& number, Color color);

}  // namespace demos::atlas
