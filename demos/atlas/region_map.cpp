#include "demos/atlas/region_map.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>

#include "delassus/release.h"

namespace demos::atlas {

using Eigen::Vector2d;

namespace {

const std::array<const char*, 3> constraintNames = {"Λ₁", "Λ₂", "Λ₃"};

}  // namespace

Color colorOf(const std::vector<bool>& persisting) {
  const auto kept = std::count(persisting.begin(), persisting.end(), true);
  if (kept == long(persisting.size())) return keptAll;
  if (kept == 0) return keptNone;
  // For two contacts: by which one persists; for three: by how many.
  if (persisting.size() == 2) return persisting[0] ? keptFirst : keptSecond;
  return kept == 1 ? keptFirst : keptSecond;
}

std::string nameOf(const std::vector<bool>& persisting) {
  std::string kept;
  for (std::size_t i = 0; i < persisting.size(); ++i)
    if (persisting[i]) kept += constraintNames.at(i);
  return "M_{" + (kept.empty() ? "l" : kept) + "}";
}

std::vector<Sector> regionsOf(const Eigen::Matrix2d& W) {
  const Eigen::Matrix2d edges = -W.inverse();
  std::array<Vector2d, 4> rays = {Vector2d(1, 0), Vector2d(0, 1), edges.col(0), edges.col(1)};
  const auto angle = [](const Vector2d& ray) {
    const double turn = std::atan2(ray.y(), ray.x());
    return turn < 0 ? turn + 2 * M_PI : turn;
  };
  std::sort(rays.begin(), rays.end(),
            [&](const Vector2d& a, const Vector2d& b) { return angle(a) < angle(b); });

  std::vector<Sector> sectors;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    Sector sector{rays[i], rays[(i + 1) % rays.size()], {}, ""};
    const auto inside = delassus::analyseRelease(W, -W * sector.middle());
    sector.color = colorOf(inside.persisting);
    sector.name = nameOf(inside.persisting);
    sectors.push_back(sector);
  }
  return sectors;
}

Path RegionMap::frame() const {
  return rectangle(origin_ - Point(halfSide_, halfSide_), Point(2 * halfSide_, 2 * halfSide_));
}

void RegionMap::fill(const Sector& sector) {
  const double far = 8 * halfSide_ / scale_;  // outside the window even at the middle of 170°
  canvas_.clipped(frame(), [&] {
    canvas_.fill({origin_, at(far * sector.from.normalized()), at(4 * far * sector.middle()),
                  at(far * sector.to.normalized())},
                 tint(sector.color, regionTint));
  });
}

void RegionMap::ray(const Vector2d& direction, const Stroke& stroke) {
  canvas_.clipped(frame(), [&] {
    canvas_.stroke({origin_, at(2 * halfSide_ / scale_ * direction.normalized())}, stroke);
  });
}

Path RegionMap::arc(const Vector2d& from, const Vector2d& to, double radius) const {
  constexpr int pieces = 24;
  const double begin = std::atan2(from.y(), from.x());
  double turn = std::atan2(to.y(), to.x()) - begin;
  if (turn < 0) turn += 2 * M_PI;
  Path path;
  for (int i = 0; i <= pieces; ++i) {
    const double angle = begin + turn * i / pieces;
    path.push_back(at(radius * Vector2d(std::cos(angle), std::sin(angle))));
  }
  return path;
}

void RegionMap::axes(const std::string& right, const std::string& up) {
  const double reach = halfSide_ + 16;
  canvas_.arrow(origin_ - Point(halfSide_, 0), origin_ + Point(reach, 0), {ink, 1.6});
  canvas_.arrow(origin_ + Point(0, halfSide_), origin_ - Point(0, reach), {ink, 1.6});
  canvas_.text(origin_ + Point(reach + 6, 8), right, {22, ink, Align::Left, true});
  canvas_.text(origin_ - Point(0, reach + 10), up, {22, ink, Align::Centre, true});
}

}  // namespace demos::atlas
