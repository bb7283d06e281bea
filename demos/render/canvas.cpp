#include "demos/render/canvas.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace demos::render {

namespace {

double distanceToSegment(const Point& p, const Point& a, const Point& b) {
  const Point along = b - a;
  const double length2 = along.squaredNorm();
  const double share = length2 > 0 ? std::clamp((p - a).dot(along) / length2, 0.0, 1.0) : 0;
  return (p - a - share * along).norm();
}

}  // namespace

void Canvas::blend(int x, int y, Paint paint) {
  if (x < 0 || y < 0 || x >= image_.size.width || y >= image_.size.height) return;
  std::uint8_t* pixel = image_.pixel(x, y);
  const std::uint8_t wanted[] = {paint.colour.r, paint.colour.g, paint.colour.b};
  for (int k = 0; k < 3; ++k)
    pixel[k] = std::uint8_t(std::lround(pixel[k] + paint.alpha * (wanted[k] - pixel[k])));
}

void Canvas::fill(Point low, Point high, const std::function<double(Point)>& distance,
                  Paint paint) {
  // There is nothing to fill far outside, where coordinates may not fit an int.
  low = low.cwiseMax(-1).cwiseMin(Point(image_.size.width, image_.size.height));
  high = high.cwiseMax(-1).cwiseMin(Point(image_.size.width, image_.size.height));
  for (int y = int(low.y()) - 1; y <= int(high.y()) + 1; ++y)
    for (int x = int(low.x()) - 1; x <= int(high.x()) + 1; ++x) {
      const double covered = std::clamp(0.5 - distance(Point(x + 0.5, y + 0.5)), 0.0, 1.0);
      if (covered > 0) blend(x, y, {paint.colour, covered * paint.alpha});
    }
}

void Canvas::disc(Point centre, double radius, Paint paint) {
  const Point reach = Point::Constant(radius);
  fill(
      centre - reach, centre + reach, [&](const Point& p) { return (p - centre).norm() - radius; },
      paint);
}

void Canvas::ring(Point centre, double radius, double width, Paint paint) {
  const Point reach = Point::Constant(radius + width);
  fill(
      centre - reach, centre + reach,
      [&](const Point& p) { return std::abs((p - centre).norm() - radius) - width / 2; }, paint);
}

void Canvas::square(Point centre, double half, bool diamond, Paint paint) {
  const double reach = diamond ? half * M_SQRT2 : half;
  fill(
      centre - Point::Constant(reach), centre + Point::Constant(reach),
      [&](const Point& p) {
        const Point away = (p - centre).cwiseAbs();
        return diamond ? away.sum() / M_SQRT2 - half : away.maxCoeff() - half;
      },
      paint);
}

void Canvas::line(Point from, Point to, double width, Paint paint) {
  const Point reach = Point::Constant(width);
  fill(
      from.cwiseMin(to) - reach, from.cwiseMax(to) + reach,
      [&](const Point& p) { return distanceToSegment(p, from, to) - width / 2; }, paint);
}

void Canvas::triangle(Point a, Point b, Point c, Paint paint) {
  const auto cross = [](const Point& u, const Point& v) { return u.x() * v.y() - u.y() * v.x(); };
  if (cross(b - a, c - a) < 0) std::swap(b, c);
  const Point corners[] = {a, b, c};
  fill(
      a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c),
      [&](const Point& p) {
        double outside = -1e9;
        for (int k = 0; k < 3; ++k) {
          const Point side = corners[(k + 1) % 3] - corners[k];
          const double length = side.norm();
          if (length > 0) outside = std::max(outside, -cross(side, p - corners[k]) / length);
        }
        return outside;
      },
      paint);
}

void Canvas::arrow(Point from, Point to, double width, double head, Paint paint) {
  const double length = (to - from).norm();
  if (length < 0.5) return;
  const Point along = (to - from) / length, across(-along.y(), along.x());
  const double tip = std::min(head, length);
  const Point neck = to - tip * along;
  if (length > tip) line(from, neck + 0.3 * tip * along, width, paint);
  triangle(to, neck + 0.38 * tip * across, neck - 0.38 * tip * across, paint);
}

void Canvas::rectangle(Point low, Point high, double rounding, Paint paint) {
  const Point centre = (low + high) / 2, half = (high - low) / 2 - Point::Constant(rounding);
  fill(
      low, high,
      [&](const Point& p) {
        const Point beyond = (p - centre).cwiseAbs() - half;
        return beyond.cwiseMax(0).norm() + std::min(beyond.maxCoeff(), 0.0) - rounding;
      },
      paint);
}

}  // namespace demos::render
