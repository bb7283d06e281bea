#include "demos/atlas/sketches.h"

#include <Eigen/LU>
#include <array>
#include <cmath>

namespace demos::atlas {

namespace {

constexpr Color beadColor{0.80, 0.82, 0.85};
constexpr double numberSize = 17;

}  // namespace

Point AngleSketch::apex() const {
  Eigen::Matrix2d rows;
  rows << normals[0].transpose(), normals[1].transpose();
  return bead + up(rows.inverse() * Eigen::Vector2d(-radius, -radius));
}

std::array<Eigen::Vector2d, 2> uprightAngle(double opening) {
  const double half = opening / 2;
  return {Eigen::Vector2d(-std::cos(half), std::sin(half)),
          Eigen::Vector2d(std::cos(half), std::sin(half))};
}

void drawPlanes(Canvas& canvas, const AngleSketch& sketch) {
  const Point apex = sketch.apex();
  const double depth = 0.3 * sketch.radius;  // of the solid that is shown behind each plane
  std::array<Point, 2> ends, behind;
  for (const int i : {0, 1}) {
    const Point contact = sketch.contact(i);
    ends[std::size_t(i)] = contact + sketch.wall * (contact - apex).normalized();
    behind[std::size_t(i)] =
        ends[std::size_t(i)] - depth * AngleSketch::up(sketch.normals[std::size_t(i)]);
  }
  const Point mitre = apex + depth / sketch.radius * (apex - sketch.bead);
  canvas.fill({ends[0], apex, ends[1], behind[1], mitre, behind[0]}, tint(wallColor, 0.35));
  canvas.stroke({ends[0], apex, ends[1]}, {wallColor, 2.5});
}

void drawBead(Canvas& canvas, const Point& centre, double radius) {
  canvas.disc(centre, radius - 1, beadColor);
  canvas.circle(centre, radius - 1, {ink, 2});
}

void drawGhostBead(Canvas& canvas, const Point& centre, double radius, Color color) {
  canvas.circle(centre, radius - 1, {color, 2, true});
}

void drawNumber(Canvas& canvas, const Point& centre, const std::string& number, Color color) {
  canvas.disc(centre, 0.68 * numberSize, color);
  canvas.text(centre + Point(0, 0.36 * numberSize), number,
              {numberSize, white, Align::Centre, true});
}

Path rodOutline(const Point& centre, double angle, double halfLength, double thickness) {
  const Point along = halfLength * Point(std::cos(angle), -std::sin(angle));
  const Point across = thickness / 2 * Point(std::sin(angle), std::cos(angle));
  return {centre - along - across, centre + along - across, centre + along + across,
          centre - along + across};
}

void drawRod(Canvas& canvas, const Point& centre, double angle, double halfLength,
             double thickness) {
  const Path outline = rodOutline(centre, angle, halfLength, thickness);
  canvas.fill(outline, beadColor);
  canvas.stroke(outline, {ink, 2}, true);
}

void drawGround(Canvas& canvas, const Point& from, const Point& to, double depth) {
  canvas.fill(rectangle(from, {to.x() - from.x(), depth}), tint(wallColor, 0.35));
  canvas.stroke({from, to}, {wallColor, 2.5});
}

void drawSupport(Canvas& canvas, const Point& top) {
  constexpr double radius = 15;
  canvas.disc(top + Point(0, radius), radius, tint(wallColor, 0.45));
  canvas.circle(top + Point(0, radius), radius, {wallColor, 2.5});
}

}  // namespace demos::atlas
