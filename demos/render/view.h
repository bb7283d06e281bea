#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "demos/render/film.h"
#include "demos/render/image.h"

namespace demos::render {

/// A box along the axes, m.
struct Box {
  Eigen::Vector3d low, high;

  Eigen::Vector3d centre() const { return (low + high) / 2; }
  double radius() const { return (high - low).norm() / 2; }
};

/// A camera. Its view depends on the ratio of the picture's sides, not on their size.
struct View {
  Eigen::Vector3d eye{0, 3, 12}, target{0, 1, 0}, up{0, 1, 0};
  double fov = 40;  ///< vertical, degrees
  double near = 0.1, far = 1000;

  Eigen::Matrix4d toEye() const;
  Eigen::Matrix4d projection(double aspect) const;
  /// Pixel (from the top left) and depth as in the depth buffer, 0 to 1. Nothing for points behind
  /// the camera.
  std::optional<Eigen::Vector3d> project(const Eigen::Vector3d& point, Size size) const;
  /// Pixels a metre at the target, across the line of sight.
  double pixelsPerMetre(Size size) const;
};

/// The user's wishes about the camera; the rest is computed.
struct Wish {
  Eigen::Vector3d direction{0.5, 0.35, 1};  ///< from the things towards the camera, any length
  double fov = 30;
  std::optional<Eigen::Vector3d> eye, lookAt;
};

/// The box of the action: everything that moves in the first film, everything near it in the
/// others, and small fixed things. Things that have fallen out of the scene do not count. If the
/// bodies of the first film have flown apart beside those of another, that one takes its place.
Box stage(const std::vector<Film>& films);

/// True for fixed things that are much larger than the stage: the ground.
bool isTerrain(const Thing& thing, const Frame::Pose& pose, const Box& stage);

/// The camera that sees the whole stage, as near as possible, at pictures of `size`.
View frameView(const std::vector<Film>& films, const Box& stage, const Wish& wish, Size size);

}  // namespace demos::render
