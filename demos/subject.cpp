#include "demos/subject.h"

#include "demos/scenes/bullet_file.h"
#include "demos/scenes/catalogue.h"

namespace demos {

namespace {

bool isFile(const std::string& name) {
  const std::string suffix = ".bullet";
  return name.find('/') != std::string::npos ||
         (name.size() > suffix.size() &&
          name.compare(name.size() - suffix.size(), suffix.size(), suffix) == 0);
}

}  // namespace

Subject openSubject(const std::string& name) {
  if (!isFile(name)) {
    const SceneDescription& scene = findScene(name);
    return {scene.name, scene.build(), scene.seconds, scene.hz, {}};
  }
  constexpr double usualSeconds = 5, usualHz = 60;
  LoadedFile file = loadBulletFile(name);
  return {name, std::move(file.world), usualSeconds, usualHz, std::move(file.notes)};
}

const char* precisionName() { return sizeof(btScalar) == sizeof(double) ? "double" : "float"; }

}  // namespace demos
