#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "demos/scenes/world.h"

namespace demos {

/// A .bullet file that cannot be read: "file: why".
class BulletFileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct LoadedFile {
  std::unique_ptr<World> world;
  /// What was read, and which of the file's settings are kept, one line each.
  std::vector<std::string> notes;
};

/// Reads a world that Bullet serialised, in either precision, into a world like those of the
/// scenes.
///
/// Bodies, shapes, joints and gravity are the file's. Its solver settings (iterations, erp, split
/// impulse, ...) are not kept: worlds are compared under the settings that Bullet gives a new
/// world. Sleeping is Bullet's default.
LoadedFile loadBulletFile(const std::string& path);

}  // namespace demos
