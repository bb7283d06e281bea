#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "demos/crash.h"
#include "demos/scenes/scene.h"
#include "demos/scenes/solvers.h"

namespace demos {

/// The subject of a command: a built-in scene or a .bullet file, freshly built.
struct Subject {
  std::string name;
  std::unique_ptr<World> world;
  double seconds;                  ///< how long it is simulated unless the user says otherwise
  double hz;                       ///< and at how many steps a second
  std::vector<std::string> notes;  ///< remarks about a file
  std::optional<Law> law;          ///< of a scene that has one
};

/// `name` is a file if it ends in ".bullet" or has a slash in it, else a scene.
/// Throws UnknownScene or BulletFileError.
Subject loadSubject(const std::string& name);

/// The same for a command: from here on, a crash is blamed on the file, if there is one.
Subject openSubject(const std::string& name);

/// While it lives, a crash is blamed on the solver that runs on `subject`, if it is Bullet's: some
/// of Bullet's solvers overflow the stack with many contacts. Null if the solver is ours. A crash
/// prints `finished` first.
std::unique_ptr<CrashBlame> blameBullet(const std::string& subject, const NamedSolver& solver,
                                        const std::string& finished = "");

/// "double" or "float": the precision of the Bullet library in this build.
const char* precisionName();

}  // namespace demos
