#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

#include "demos/scenes/benchmarks.h"
#include "demos/scenes/builders.h"

namespace demos {

namespace {

using Eigen::Vector3d;

/// The points x with normal·x ≤ offset.
struct HalfSpace {
  Vector3d normal;
  double offset;
};

/// A convex body by its faces, each a ring of corners seen anticlockwise from outside.
class Polyhedron {
 public:
  /// A cube of this half size about the origin.
  explicit Polyhedron(double half) {
    for (int axis = 0; axis < 3; ++axis)
      for (const double side : {-half, half}) {
        std::vector<Vector3d> face;
        for (const auto& [u, v] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
          Vector3d corner;
          corner[axis] = side;
          corner[(axis + 1) % 3] = u * half;
          corner[(axis + 2) % 3] = v * half;
          face.push_back(corner);
        }
        if (side < 0) std::reverse(face.begin(), face.end());
        faces_.push_back(face);
      }
  }

  /// Cuts off everything outside `kept`.
  void clip(const HalfSpace& kept) {
    std::vector<std::vector<Vector3d>> faces;
    std::vector<Vector3d> rim;
    for (const auto& face : faces_) {
      std::vector<Vector3d> rest;
      for (std::size_t i = 0; i < face.size(); ++i) {
        const Vector3d &a = face[i], &b = face[(i + 1) % face.size()];
        const double outA = kept.normal.dot(a) - kept.offset,
                     outB = kept.normal.dot(b) - kept.offset;
        if (outA <= 0) rest.push_back(a);
        if ((outA < 0 && outB > 0) || (outA > 0 && outB < 0)) {
          rest.push_back(a + (b - a) * (outA / (outA - outB)));
          rim.push_back(rest.back());
        }
      }
      if (rest.size() > 2) faces.push_back(rest);
    }
    faces_ = std::move(faces);
    if (!rim.empty()) faces_.push_back(lid(rim, kept.normal));
  }

  std::vector<Vector3d> corners() const {
    constexpr double same = 1e-9;  // m
    std::vector<Vector3d> all;
    for (const auto& face : faces_)
      for (const Vector3d& corner : face)
        if (std::none_of(all.begin(), all.end(),
                         [&](const Vector3d& known) { return (known - corner).norm() < same; }))
          all.push_back(corner);
    return all;
  }

  struct Bulk {
    double volume = 0;
    Vector3d centre = Vector3d::Zero();
  };
  /// Computed from the tetrahedra between the faces and the origin.
  Bulk bulk() const {
    Bulk sum;
    for (const auto& face : faces_)
      for (std::size_t i = 2; i < face.size(); ++i) {
        const double volume = face[0].dot(face[i - 1].cross(face[i])) / 6;
        sum.volume += volume;
        sum.centre += volume * (face[0] + face[i - 1] + face[i]) / 4;
      }
    sum.centre /= sum.volume;
    return sum;
  }

 private:
  /// The face that closes a cut: its corners in order around `normal`.
  static std::vector<Vector3d> lid(std::vector<Vector3d> rim, const Vector3d& normal) {
    Vector3d middle = Vector3d::Zero();
    for (const Vector3d& corner : rim) middle += corner / double(rim.size());
    const Vector3d across = normal.unitOrthogonal(), up = normal.cross(across);
    const auto angle = [&](const Vector3d& corner) {
      return std::atan2((corner - middle).dot(up), (corner - middle).dot(across));
    };
    std::sort(rim.begin(), rim.end(),
              [&](const Vector3d& a, const Vector3d& b) { return angle(a) < angle(b); });
    return rim;
  }

  std::vector<std::vector<Vector3d>> faces_;
};

/// Halton's sequence in one dimension: the digits of `index` behind the point.
double halton(int index, int base) {
  double value = 0, digit = 1;
  for (; index > 0; index /= base) {
    digit /= base;
    value += digit * (index % base);
  }
  return value;
}

/// The points nearer to `sites[cell]` than to any other, shrunk by `margin` on all sides.
Polyhedron voronoiCell(const std::vector<Vector3d>& sites, std::size_t cell, double half,
                       double margin) {
  Polyhedron piece(half - margin);
  for (std::size_t other = 0; other < sites.size(); ++other) {
    if (other == cell) continue;
    const Vector3d normal = (sites[other] - sites[cell]).normalized();
    piece.clip({normal, normal.dot(sites[other] + sites[cell]) / 2 - margin});
  }
  return piece;
}

}  // namespace

std::unique_ptr<World> buildVoronoiCells(int count, double height) {
  constexpr double half = 3;       // m
  constexpr double density = 100;  // kg/m³
  auto world = std::make_unique<World>();
  addGround(*world);

  std::vector<Vector3d> sites;
  for (int i = 1; i <= count; ++i)
    sites.push_back(half *
                    (2 * Vector3d(halton(i, 2), halton(i, 3), halton(i, 5)) - Vector3d::Ones()));
  for (std::size_t i = 0; i < sites.size(); ++i) {
    auto hull = std::make_unique<btConvexHullShape>();
    // Bullet wraps a hull in its margin: with it the pieces touch.
    const Polyhedron piece = voronoiCell(sites, i, half, hull->getMargin());
    const Polyhedron::Bulk bulk = piece.bulk();
    for (const Vector3d& corner : piece.corners()) {
      const Vector3d arm = corner - bulk.centre;
      hull->addPoint(vec3(arm.x(), arm.y(), arm.z()), false);
    }
    hull->recalcLocalAabb();
    const Vector3d& centre = bulk.centre;
    world->add(btScalar(density * bulk.volume), world->own(std::move(hull)),
               at(centre.x(), half + height + centre.y(), centre.z()),
               {surfaceFriction(usualFriction), 0});
  }
  return world;
}

}  // namespace demos
