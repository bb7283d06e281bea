/// Damaged .bullet files, read as `delassus run FILE.bullet` reads them: each is refused in one
/// line, or steps.
///
/// Bullet's importer trusts what it reads and may crash. For that reason the command rehearses in a
/// process of its own, and so does this target, since it loads files by the same call. The target
/// asks that nothing passes the rehearsal and then crashes or hangs. Bullet's own second reading
/// may still crash, since it reads where it should not: the command reports that (blameCrashesOn);
/// here it ends the run.

#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "demos/scenes/bullet_file.h"
#include "demos/scenes/catalogue.h"
#include "demos/scenes/simulate.h"
#include "demos/subject.h"
#include "tests/fuzz/target.h"

namespace delassus::test {
namespace {

std::string serialised(demos::World& world) {
  btDefaultSerializer serializer;
  world.dynamics().serialize(&serializer);
  return {reinterpret_cast<const char*>(serializer.getBufferPointer()),
          std::size_t(serializer.getCurrentBufferSize())};
}

std::string seed(Random&) {
  static const std::string whole = serialised(*demos::findScene("ragdolls").build());
  return whole;
}

/// The bytes of the file with a few changes: anywhere, or four at once by a number likely to hurt.
std::string mutated(std::string bytes, Random& random) {
  constexpr std::size_t least = 16;
  for (int change = pick(random, 1, 4); change > 0 && bytes.size() >= least; --change) {
    const auto at = std::size_t(pick(random, 0, int(bytes.size()) - 5));
    constexpr unsigned hurting[] = {0,          1,          0xffffffff, 0x7fffffff,
                                    0x80000000, 0x7fc00000, 0x10000,    8};
    switch (pick(random, 0, 3)) {
      case 0:
        bytes[at] = char(pick(random, 0, 255));
        break;
      case 1:
        bytes[at] = char(bytes[at] ^ (1 << pick(random, 0, 7)));
        break;
      case 2:
        for (int i = 0; i < 4; ++i)
          bytes[at / 4 * 4 + std::size_t(i)] = char(hurting[pick(random, 0, 7)] >> 8 * i);
        break;
      case 3:
        if (chance(random, 0.2)) bytes.resize(at + 4);
        break;
    }
  }
  return bytes;
}

Outcome ask(const std::string& bytes) {
  const std::string path = std::filesystem::temp_directory_path() /
                           ("delassus_fuzz_" + std::to_string(getpid()) + ".bullet");
  std::ofstream(path, std::ios::binary).write(bytes.data(), std::streamsize(bytes.size()));
  Outcome outcome;
  try {
    demos::NamedSolver solver("delassus");
    const demos::Subject subject = demos::loadSubject(path);
    demos::simulate(*subject.world, solver, {0.2, subject.hz}, [](double) {});
    ++outcome.counts["run"];
  } catch (const demos::BulletFileError& error) {
    const std::string what = error.what();
    if (what.rfind(path + ":", 0) != 0)
      outcome.faults.insert("does not begin with the file: " + what);
    if (what.find('\n') != std::string::npos) outcome.faults.insert("more than a line: " + what);
    ++outcome.counts["refused"];
  }
  std::filesystem::remove(path);
  return outcome;
}

}  // namespace

const Target target{"bullet_file", ask, seed, mutated, 60, {{"refused", 0.1}, {"run", 0.1}}};

}  // namespace delassus::test
