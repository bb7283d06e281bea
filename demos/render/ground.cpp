#include "demos/render/ground.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace demos::render {

using Eigen::Vector3d;

namespace {

/// Points with n·x ≥ c.
struct HalfSpace {
  Vector3d normal;
  double offset;
};

/// Sutherland and Hodgman: the part of a convex polygon within a half space.
std::vector<Vector3d> clip(const std::vector<Vector3d>& polygon, const HalfSpace& space) {
  std::vector<Vector3d> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector3d &here = polygon[i], &next = polygon[(i + 1) % polygon.size()];
    const double a = space.normal.dot(here) - space.offset,
                 b = space.normal.dot(next) - space.offset;
    if (a >= 0) kept.push_back(here);
    if ((a >= 0) != (b >= 0)) kept.push_back(here + a / (a - b) * (next - here));
  }
  return kept;
}

/// The plane of a thing in the world.
HalfSpace inWorld(const Plane& plane, const Eigen::Matrix4f& pose) {
  const Eigen::Matrix4d matrix = pose.cast<double>();
  const Vector3d normal = matrix.topLeftCorner<3, 3>() * plane.normal;
  return {normal, plane.offset + normal.dot(matrix.topRightCorner<3, 1>())};
}

/// Turns e_y to a unit vector. (For one that looks straight down Eigen's FromTwoVectors uses a
/// singular value decomposition, which takes long to compile.)
Eigen::Quaterniond turnUpTo(const Vector3d& n) {
  const double s = std::sqrt(2 * std::max(0.0, 1 + n.y()));
  if (s < 1e-6) return {0, 1, 0, 0};
  const Vector3d axis = Vector3d::UnitY().cross(n) / s;
  return {s / 2, axis.x(), axis.y(), axis.z()};
}

/// The prism of `thickness` below a polygon that faces up, both in a frame whose e_y is the normal.
Mesh slab(const std::vector<Eigen::Vector3f>& top, float thickness) {
  Mesh mesh;
  mesh.addPolygon(top);
  const Eigen::Vector3f down(0, -thickness, 0);
  for (std::size_t i = 0; i < top.size(); ++i) {
    const Eigen::Vector3f &a = top[i], &b = top[(i + 1) % top.size()];
    mesh.addPolygon({a, a + down, b + down, b});
  }
  return mesh;
}

std::vector<HalfSpace> wallsOf(const Box& box) {
  std::vector<HalfSpace> walls;
  for (int k = 0; k < 3; ++k) {
    walls.push_back({Vector3d::Unit(k), box.low[k]});
    walls.push_back({-Vector3d::Unit(k), -box.high[k]});
  }
  return walls;
}

}  // namespace

void layPlanes(Film& film, const Box& stage) {
  const double extent = (stage.high - stage.low).maxCoeff();
  // A slab extends beyond the things on it: a little, and at least by about the size of a small
  // one.
  const Vector3d pad = Vector3d::Constant(std::max(0.15 * extent, std::min(0.6, 0.6 * extent)));
  const std::vector<HalfSpace> room = wallsOf({stage.low - pad, stage.high + pad});

  std::vector<std::pair<int, HalfSpace>> planes;
  for (const Frame::Pose& pose : film.frames.front().poses)
    if (const auto& plane = film.things[std::size_t(pose.thing)].plane)
      planes.emplace_back(pose.thing, inWorld(*plane, pose.matrix));

  for (const auto& [thing, space] : planes) {
    // A frame of the plane: e_y along its normal, its origin under the stage's centre.
    const Vector3d origin =
        stage.centre() - (space.normal.dot(stage.centre()) - space.offset) * space.normal;
    const Eigen::Quaterniond turn = turnUpTo(space.normal.normalized());
    const bool endless = planes.size() == 1 && space.normal.dot(film.up) > 0.99;
    const double reach = (endless ? 60 : 4) * std::max(extent, 1.0);
    std::vector<Vector3d> polygon;
    for (const auto& [x, z] : {std::pair(-1, -1), {-1, 1}, {1, 1}, {1, -1}})
      polygon.push_back(origin + turn * Vector3d(x * reach, 0, z * reach));
    if (!endless)
      for (const HalfSpace& wall : room) polygon = clip(polygon, wall);
    for (const auto& [other, otherSpace] : planes)
      if (other != thing) polygon = clip(polygon, otherSpace);

    // Coordinates count from the world's origin, so that grids of level ground agree with the
    // world's.
    std::vector<Eigen::Vector3f> top;
    for (const Vector3d& corner : polygon) top.push_back((turn.inverse() * corner).cast<float>());
    Eigen::Matrix4f place = Eigen::Matrix4f::Identity();
    place.topLeftCorner<3, 3>() = turn.toRotationMatrix().cast<float>();
    film.things[std::size_t(thing)].parts = {{int(film.meshes.size()), place}};
    film.meshes.push_back(slab(top, float(0.03 * std::max(extent, 0.1))));
  }
}

}  // namespace demos::render
