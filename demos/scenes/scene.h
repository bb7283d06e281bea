#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "demos/scenes/world.h"

namespace demos {

/// The camera for pictures of a scene. Metres; `fov` is the vertical angle of view in degrees.
struct Camera {
  btVector3 eye{0, 3, 12};
  btVector3 target{0, 1, 0};
  double fov = 40;
};

/// How far the last step, of `timeStep` s, is from a scene's expectation, if one number can say it.
struct Law {
  std::string name;  ///< of the number, with its unit
  std::function<double(const World&, double timeStep)> error;
};

/// One scene: everything that a run, a test, a picture or a report needs to know about it.
struct SceneDescription {
  std::string name;
  std::string summary;  ///< one line
  double seconds = 5;   ///< simulated, s
  Camera camera;
  std::string expectation;  ///< the closed form or the law that the motion obeys
  std::function<std::unique_ptr<World>()> build;
  double hz = 60;  ///< steps a second
  std::optional<Law> law = std::nullopt;
  bool driven = false;  ///< something in it does work: energy is gained
};

}  // namespace demos
