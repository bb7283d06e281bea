#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "demos/scenes/scene.h"

namespace demos {

/// A scene or a file that does not exist; the message names the nearest that does.
class UnknownScene : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// All built-in scenes, the paper's first.
const std::vector<SceneDescription>& catalogue();

/// The scene of that name. Throws UnknownScene.
const SceneDescription& findScene(const std::string& name);

/// Number of letters to insert, remove or replace to turn `a` into `b` (Levenshtein).
int editDistance(const std::string& a, const std::string& b);

}  // namespace demos
