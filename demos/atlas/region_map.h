#pragma once

#include <string>
#include <vector>

#include "delassus/types.h"
#include "demos/atlas/canvas.h"

namespace demos::atlas {

/// One of the paper's regions in the plane of forced reactions: the angle from `from`
/// counter-clockwise to `to`.
struct Sector {
  Eigen::Vector2d from, to;
  Color color;
  std::string name;

  /// The direction halfway.
  Eigen::Vector2d middle() const { return (from.normalized() + to.normalized()).normalized(); }
};

/// The four regions of two contacts (paper §7-§8): the angles between the half-lines e1, e2, −W⁻¹e1
/// and −W⁻¹e2, each named and coloured by what `analyseRelease` answers inside it.
std::vector<Sector> regionsOf(const Eigen::Matrix2d& W);

/// Colour and name in the paper's terms of "these are kept".
Color colorOf(const std::vector<bool>& persisting);
std::string nameOf(const std::vector<bool>& persisting);

/// A square window on the plane of forced reactions.
class RegionMap {
 public:
  /// `origin` and `halfSide` in pixels; `scale` in pixels a unit of the plane.
  RegionMap(Canvas& canvas, const Point& origin, double halfSide, double scale)
      : canvas_(canvas), origin_(origin), halfSide_(halfSide), scale_(scale) {}

  Point at(const Eigen::Vector2d& f) const { return origin_ + scale_ * Point(f.x(), -f.y()); }
  Path frame() const;
  void fill(const Sector& sector);
  /// The half-line from the origin.
  void ray(const Eigen::Vector2d& direction, const Stroke& stroke);
  /// Counter-clockwise from one direction to the other.
  Path arc(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double radius) const;
  void axes(const std::string& right, const std::string& up);

 private:
  Canvas& canvas_;
  Point origin_;
  double halfSide_, scale_;
};

}  // namespace demos::atlas
