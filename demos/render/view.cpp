#include "demos/render/view.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

namespace demos::render {

using Eigen::Matrix4d;
using Eigen::Vector3d;
using Eigen::Vector4d;

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

Box nothing() { return {Vector3d::Constant(infinite), Vector3d::Constant(-infinite)}; }
bool isEmpty(const Box& box) { return box.low.x() > box.high.x(); }

void extend(Box& box, const Vector3d& low, const Vector3d& high) {
  box.low = box.low.cwiseMin(low);
  box.high = box.high.cwiseMax(high);
}

double extent(const Vector3d& low, const Vector3d& high) { return (high - low).maxCoeff(); }

bool isWithin(const Vector3d& point, const Vector3d& low, const Vector3d& high) {
  return (point.array() >= low.array()).all() && (point.array() <= high.array()).all();
}

/// Visits the poses of all things that move.
template <class Visit>
void forEachMoving(const Film& film, const Visit& visit) {
  for (const Frame& frame : film.frames)
    for (const Frame::Pose& pose : frame.poses)
      if (film.things[std::size_t(pose.thing)].mass > 0) visit(pose);
}

/// The middle half of `values`, widened on either side by three times its width. Values outside
/// count as out of the scene.
std::pair<double, double> usualRange(std::vector<double> values, double least) {
  std::sort(values.begin(), values.end());
  const double low = values[values.size() / 4], high = values[3 * values.size() / 4];
  const double margin = 3 * std::max(high - low, least);
  return {low - margin, high + margin};
}

/// The box of everything that moves in `film`, except the few things far from all others.
Box movingBox(const Film& film) {
  std::vector<double> places[3];
  double largest = 0;
  forEachMoving(film, [&](const Frame::Pose& pose) {
    for (int k = 0; k < 3; ++k) places[k].push_back((pose.low[k] + pose.high[k]) / 2);
    largest = std::max(largest, extent(pose.low, pose.high));
  });
  Box box = nothing();
  if (places[0].empty()) return box;
  Vector3d low, high;
  for (int k = 0; k < 3; ++k) std::tie(low[k], high[k]) = usualRange(places[k], 2 * largest);
  forEachMoving(film, [&](const Frame::Pose& pose) {
    const Vector3d centre = (pose.low + pose.high) / 2;
    if (isWithin(centre, low, high)) extend(box, pose.low, pose.high);
  });
  return box;
}

/// Visits the boxes that a camera should see.
template <class Visit>
void forEachOnStage(const std::vector<Film>& films, const Box& box, const Visit& visit) {
  for (const Film& film : films)
    for (const Frame& frame : film.frames)
      for (const Frame::Pose& pose : frame.poses) {
        const Thing& thing = film.things[std::size_t(pose.thing)];
        const Vector3d low = pose.low.cwiseMax(box.low), high = pose.high.cwiseMin(box.high);
        const bool inside = (low.array() <= high.array()).all();
        if (inside && !isTerrain(thing, pose, box)) visit(low, high);
      }
  for (const Film& film : films)
    for (const Frame& frame : film.frames)
      for (const Rope& rope : frame.ropes)
        if (isWithin(rope.end, box.low, box.high)) visit(rope.end, rope.end);
}

}  // namespace

Matrix4d View::toEye() const {
  const Vector3d back = (eye - target).normalized();
  Vector3d right = up.cross(back);
  // Looking straight down, any direction is as good as another.
  if (right.norm() < 1e-6) right = back.unitOrthogonal();
  right.normalize();
  Matrix4d matrix = Matrix4d::Identity();
  matrix.block<1, 3>(0, 0) = right.transpose();
  matrix.block<1, 3>(1, 0) = back.cross(right).transpose();
  matrix.block<1, 3>(2, 0) = back.transpose();
  matrix.block<3, 1>(0, 3) = -matrix.topLeftCorner<3, 3>() * eye;
  return matrix;
}

Matrix4d View::projection(double aspect) const {
  const double scale = 1 / std::tan(fov * M_PI / 360);
  Matrix4d matrix = Matrix4d::Zero();
  matrix(0, 0) = scale / aspect;
  matrix(1, 1) = scale;
  matrix(2, 2) = -(far + near) / (far - near);
  matrix(2, 3) = -2 * far * near / (far - near);
  matrix(3, 2) = -1;
  return matrix;
}

std::optional<Vector3d> View::project(const Vector3d& point, Size size) const {
  const Vector4d clip =
      projection(double(size.width) / size.height) * toEye() * point.homogeneous();
  if (clip.w() < near) return std::nullopt;
  const Vector3d ndc = clip.hnormalized();
  return Vector3d((ndc.x() + 1) / 2 * size.width, (1 - ndc.y()) / 2 * size.height,
                  (ndc.z() + 1) / 2);
}

double View::pixelsPerMetre(Size size) const {
  return size.height / (2 * std::tan(fov * M_PI / 360) * (eye - target).norm());
}

Box stage(const std::vector<Film>& films) {
  std::vector<Box> moving;
  for (const Film& film : films)
    if (const Box box = movingBox(film); !isEmpty(box)) moving.push_back(box);
  const auto sizeOf = [](const Box& box) { return extent(box.low, box.high); };
  double smallest = infinite;
  for (const Box& box : moving) smallest = std::min(smallest, sizeOf(box));
  // The first film's, unless its bodies have flown apart beside those of another one.
  constexpr double farApart = 4;
  const auto base = std::find_if(moving.begin(), moving.end(), [&](const Box& box) {
    return sizeOf(box) <= farApart * smallest;
  });
  Box box = base != moving.end() ? *base : nothing();
  // Others may extend that box, but not so far that it shrinks to a dot.
  for (auto other = moving.begin(); other != moving.end(); ++other) {
    if (other == base) continue;
    const Vector3d room = Vector3d::Constant(0.35 * sizeOf(box));
    extend(box, other->low.cwiseMax(box.low - room), other->high.cwiseMin(box.high + room));
  }
  if (isEmpty(box)) box = {Vector3d::Constant(-1), Vector3d::Constant(1)};
  // Adds the fixed things that belong to the scene: those near it and not much larger.
  const Box bodies = box;
  const double size = sizeOf(bodies);
  const Vector3d around = Vector3d::Constant(2 * size);
  for (const Film& film : films) {
    for (const Rope& rope : film.frames.front().ropes)
      if (isWithin(rope.end, bodies.low - around, bodies.high + around))
        extend(box, rope.end, rope.end);
    for (const Frame::Pose& pose : film.frames.front().poses) {
      const Thing& thing = film.things[std::size_t(pose.thing)];
      const bool near = (pose.low.array() <= bodies.high.array() + size).all() &&
                        (pose.high.array() >= bodies.low.array() - size).all();
      if (thing.mass == 0 && near && !isTerrain(thing, pose, bodies))
        extend(box, pose.low, pose.high);
    }
  }
  return box;
}

bool isTerrain(const Thing& thing, const Frame::Pose& pose, const Box& stage) {
  if (thing.mass > 0) return false;
  if (thing.plane || extent(pose.low, pose.high) > 3 * extent(stage.low, stage.high)) return true;
  // A thing that lies under everything is ground, even if it is hardly larger.
  int covered = 0;
  for (int k = 0; k < 3; ++k)
    covered += pose.low[k] < stage.low[k] && pose.high[k] > stage.high[k] ? 1 : 0;
  return covered >= 2;
}

View frameView(const std::vector<Film>& films, const Box& stage, const Wish& wish, Size size) {
  View view;
  view.up = films.front().up;
  view.fov = wish.fov;
  const Vector3d direction = wish.direction.normalized();
  const double tanY = std::tan(wish.fov * M_PI / 360), tanX = tanY * size.width / size.height;

  // In axes of the camera at the stage's centre (z towards the camera), a point is in the picture
  // from the distance d if
  //     |x - cx| ≤ tanX (d - z)   and   |y - cy| ≤ tanY (d - z).
  view.target = stage.centre();
  view.eye = view.target + direction;
  const Eigen::Matrix3d turn = view.toEye().topLeftCorner<3, 3>();
  double right = -infinite, left = -infinite, top = -infinite, bottom = -infinite, front = 0;
  forEachOnStage(films, stage, [&](const Vector3d& low, const Vector3d& high) {
    for (int corner = 0; corner < 8; ++corner) {
      const Vector3d point((corner & 1) != 0 ? high.x() : low.x(),
                           (corner & 2) != 0 ? high.y() : low.y(),
                           (corner & 4) != 0 ? high.z() : low.z());
      const Vector3d seen = turn * (point - view.target);
      right = std::max(right, seen.x() / tanX + seen.z());
      left = std::max(left, -seen.x() / tanX + seen.z());
      top = std::max(top, seen.y() / tanY + seen.z());
      bottom = std::max(bottom, -seen.y() / tanY + seen.z());
      front = std::max(front, seen.z());
    }
  });
  constexpr double margin = 1.12;
  double distance = 3 * stage.radius();
  if (right > -infinite) {
    const Vector3d shift(tanX * (right - left) / 2, tanY * (top - bottom) / 2, 0);
    view.target += turn.transpose() * shift;
    distance = margin * std::max({(right + left) / 2, (top + bottom) / 2, front + 0.1});
  }
  if (wish.lookAt) view.target = *wish.lookAt;
  view.eye = wish.eye ? *wish.eye : view.target + direction * distance;
  const double reach = (view.eye - stage.centre()).norm();
  view.near = 0.02 * std::max((view.eye - view.target).norm(), 1e-3);
  view.far = 20 * (reach + stage.radius());
  return view;
}

}  // namespace demos::render
