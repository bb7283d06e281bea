#include "demos/render/instances.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "demos/render/palette.h"

namespace demos::render {

using Eigen::Matrix4d;
using Eigen::Matrix4f;
using Eigen::Vector3d;
using Eigen::Vector3f;

namespace {

Vector3f linear(Colour colour) {
  const auto channel = [](std::uint8_t value) {
    const float x = float(value) / 255;
    return x <= 0.04045f ? x / 12.92f : std::pow((x + 0.055f) / 1.055f, 2.4f);
  };
  return {channel(colour.r), channel(colour.g), channel(colour.b)};
}

bool isBehind(const Vector3d& eye, const Plane& plane, const Matrix4f& pose) {
  const Matrix4d matrix = pose.cast<double>();
  const Vector3d normal = matrix.topLeftCorner<3, 3>() * plane.normal;
  return normal.dot(eye - matrix.topRightCorner<3, 1>()) < plane.offset;
}

/// The pose of the unit cylinder as a rope of that radius.
Matrix4f stretched(const Rope& rope, double radius) {
  const Vector3d along = (rope.end - rope.body) / 2;
  Matrix4d matrix = Matrix4d::Identity();
  matrix.col(0).head<3>() = radius * along.unitOrthogonal();
  matrix.col(1).head<3>() = along;
  matrix.col(2).head<3>() = radius * along.normalized().cross(along.unitOrthogonal()) * -1;
  matrix.col(3).head<3>() = rope.body + along;
  return matrix.cast<float>();
}

Colour colourOf(const Thing& thing, int number, bool terrain, double heavy) {
  if (thing.mass == 0) return terrain ? palette::terrain : palette::fixed;
  if (thing.mass >= heavy) return palette::heavy;
  // Skips a tone every seventh time: otherwise things in rows of twenty would make columns.
  return palette::bodies[std::size_t(number + number / 7) % std::size(palette::bodies)];
}

}  // namespace

double heavyFrom(const Film& film) {
  std::vector<double> masses;
  for (const Thing& thing : film.things)
    if (thing.mass > 0) masses.push_back(thing.mass);
  if (masses.empty()) return std::numeric_limits<double>::infinity();
  const auto middle = masses.begin() + std::ptrdiff_t(masses.size() / 2);
  std::nth_element(masses.begin(), middle, masses.end());
  const double usual = *middle, most = *std::max_element(masses.begin(), masses.end());
  return std::max(10 * usual, 0.3 * most);
}

Batches batchesOf(const Film& film, const Frame& frame, const View& view, const Box& stage) {
  const double heavy = heavyFrom(film);
  constexpr float glassAlpha = 0.14f;
  std::vector<std::vector<Instance>> solid(film.meshes.size()), glass(film.meshes.size());
  for (const Frame::Pose& pose : frame.poses) {
    const Thing& thing = film.things[std::size_t(pose.thing)];
    const bool terrain = isTerrain(thing, pose, stage);
    const Vector3f tint = linear(colourOf(thing, pose.thing, terrain, heavy));
    const bool seeThrough = thing.plane && isBehind(view.eye, *thing.plane, pose.matrix);
    for (const Thing::Part& part : thing.parts) {
      const Matrix4f matrix = pose.matrix * part.place;
      Instance instance{{},
                        {tint.x(), tint.y(), tint.z(), seeThrough ? glassAlpha : 1},
                        {std::uint32_t(pose.thing) + 1, terrain ? 1u : 0u}};
      std::copy_n(matrix.data(), 16, instance.matrix);
      (seeThrough ? glass : solid)[std::size_t(part.mesh)].push_back(instance);
    }
  }
  // Ropes have no number, since no thing of the world is there.
  const Vector3f dark = linear(palette::ink);
  for (const Rope& rope : frame.ropes) {
    const Matrix4f matrix = stretched(rope, 0.004 * stage.radius());
    Instance instance{{}, {dark.x(), dark.y(), dark.z(), 1}, {0, 0}};
    std::copy_n(matrix.data(), 16, instance.matrix);
    solid[0].push_back(instance);
  }

  Batches batches;
  const auto append = [&batches](const std::vector<std::vector<Instance>>& byMesh,
                                 std::vector<Batch>& to) {
    for (std::size_t mesh = 0; mesh < byMesh.size(); ++mesh) {
      if (byMesh[mesh].empty()) continue;
      to.push_back({int(mesh), batches.instances.size(), byMesh[mesh].size()});
      batches.instances.insert(batches.instances.end(), byMesh[mesh].begin(), byMesh[mesh].end());
    }
  };
  append(solid, batches.solid);
  append(glass, batches.glass);
  return batches;
}

}  // namespace demos::render
