#include "demos/subject.h"

#include <filesystem>
#include <system_error>

#include "bullet_ext/btDelassusConstraintSolver.h"
#include "demos/process/apart.h"
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

/// A damaged file can lead Bullet's importer into any memory. So loading and the first steps are
/// tried in a process apart, and a crash there becomes a message. The contents of that memory may
/// differ here: see blameCrashesOn.
void rehearse(const std::string& file) {
  constexpr double patience = 60;  // seconds
  // A damaged count asks for any amount of memory; its pages cost seconds, and take memory from
  // other processes.
  std::error_code ignored;
  const double size = double(std::filesystem::file_size(file, ignored));
  const double bytes = 5e8 + 100 * (ignored ? 0 : size);
  const auto work = [&file] {
    try {
      const LoadedFile loaded = loadBulletFile(file);
      delassus::Options few;  // slow exact steps are not the file's fault
      few.sweepBudget = few.newtonBudget = 10;
      btDelassusConstraintSolver solver(few);
      loaded.world->setSolver(solver);
      for (int step = 0; step < 3; ++step) loaded.world->step(1.0 / 60);
    } catch (const BulletFileError&) {
      // Refused: the caller will say why.
    }
    return std::vector<double>();
  };
  const ApartResult result = runApart(work, {patience, bytes});
  if (result.ending != Ending::Done)
    throw BulletFileError(file +
                          (result.ending == Ending::Crashed
                               ? ": is damaged: Bullet's importer, or the first step, crashes on it"
                               : ": reading it and three steps take more than a minute: it is too "
                                 "large, or is damaged"));
}

}  // namespace

Subject loadSubject(const std::string& name) {
  std::error_code ignored;  // of a file that cannot be looked at: opening it will say why
  if (!isFile(name)) {
    try {
      const SceneDescription& scene = findScene(name);
      return {scene.name, scene.build(), scene.seconds, scene.hz, {}, scene.law};
    } catch (const UnknownScene& error) {
      if (!std::filesystem::is_regular_file(name, ignored)) throw;
      throw UnknownScene(std::string(error.what()) + "; the file of that name is ./" + name);
    }
  }
  constexpr double usualSeconds = 5, usualHz = 60;
  // A pipe can be read only once, and may never end.
  const std::filesystem::file_status status = std::filesystem::status(name, ignored);
  if (exists(status) && !is_regular_file(status))
    throw BulletFileError(name + ": is not a regular file");
  rehearse(name);
  LoadedFile file = loadBulletFile(name);
  return {name, std::move(file.world), usualSeconds, usualHz, std::move(file.notes), std::nullopt};
}

Subject openSubject(const std::string& name) {
  if (isFile(name)) blameCrashesOn(name);
  return loadSubject(name);
}

std::unique_ptr<CrashBlame> blameBullet(const std::string& subject, const NamedSolver& solver,
                                        const std::string& finished) {
  if (solver.delassus() != nullptr) return nullptr;
  return std::make_unique<CrashBlame>(subject + ": Bullet's own solver " + solver.name() +
                                          " crashes on it" +
                                          (isFile(subject) ? ", unless the file is damaged" : ""),
                                      finished);
}

const char* precisionName() { return sizeof(btScalar) == sizeof(double) ? "double" : "float"; }

}  // namespace demos
