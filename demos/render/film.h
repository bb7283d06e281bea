#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "delassus/active_set.h"
#include "demos/render/shape_mesh.h"
#include "demos/scenes/solvers.h"
#include "demos/scenes/world.h"

namespace demos::render {

/// A half space n·x ≤ c in the body's frame: what Bullet calls a static plane.
struct Plane {
  Eigen::Vector3d normal;
  double offset;
};

/// One collision object of the world: a body, or a link of an articulated one.
struct Thing {
  struct Part {
    int mesh;  ///< among Film::meshes
    Eigen::Matrix4f place;
  };
  std::vector<Part> parts;
  std::optional<Plane> plane;  ///< if set, it has no parts
  double mass = 0;             ///< kg; 0 if it cannot move
};

struct ContactMark {
  Eigen::Vector3d place;
  /// N, as it acts on the body that moves, or else against gravity.
  Eigen::Vector3d force;
  delassus::Mode mode;  ///< by the reaction that the solver wrote; open: released
};
struct JointMark {
  Eigen::Vector3d place;
  Eigen::Vector3d force;  ///< N, likewise
};

/// A string or an arm without a shape: ties a body to a point outside it, where a joint holds it.
struct Rope {
  Eigen::Vector3d body, end;
};

/// The world at one time.
struct Frame {
  struct Pose {
    int thing;
    Eigen::Matrix4f matrix;
    Eigen::Vector3d low, high;  ///< of its box along the axes; without meaning for a plane
  };
  double time = 0;  ///< s
  std::vector<Pose> poses;
  std::vector<ContactMark> contacts;  ///< those that carry or were released in the last step
  std::vector<JointMark> joints;
  std::vector<Rope> ropes;
  /// Natural residual of the last step, largest, m/s; none if nothing was solved.
  std::optional<double> residual;
  double milliseconds = 0;  ///< solveGroup, median of the steps so far; NaN before the first
  bool lost = false;        ///< a body is not shown, since its pose or velocity is not a number
};

/// The material for pictures of one run: values only, still good when the world is gone.
struct Film {
  std::string solver;
  Eigen::Vector3d up{0, 1, 0};  ///< against gravity
  std::vector<Mesh> meshes;     ///< the first is that of ropes: radius 1, from -e_y to e_y
  std::vector<Thing> things;
  std::vector<Frame> frames;
};

/// Steps `world` with `named` at `hz` and keeps a frame at each of `times` (rising, s), rounded to
/// whole steps. Throws std::runtime_error if these are too many (stepsIn). Tells `progress` the
/// fraction done after each step.
Film record(World& world, NamedSolver& named, double hz, const std::vector<double>& times,
            const std::function<void(double)>& progress);

}  // namespace demos::render
