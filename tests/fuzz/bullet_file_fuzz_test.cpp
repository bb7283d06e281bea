/// Damaged .bullet files: `delassus run` refuses each or runs it, and never crashes.

#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>

#include "demos/scenes/builders.h"
#include "tests/fuzz/fuzz.h"
#include "tests/scenes/run_scene.h"

namespace demos {
namespace {

using delassus::Random;
using delassus::testing::chance;
using delassus::testing::pick;

std::string serialised(World& world) {
  btDefaultSerializer serializer;
  world.dynamics().serialize(&serializer);
  return {reinterpret_cast<const char*>(serializer.getBufferPointer()),
          std::size_t(serializer.getCurrentBufferSize())};
}

/// A few bytes of the file changed: anywhere, or four at once by a number that is likely to hurt.
std::string mutated(std::string bytes, Random& random) {
  for (int change = pick(random, 1, 4); change > 0; --change) {
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
    if (bytes.size() < 16) return bytes;
  }
  return bytes;
}

/// Exit status of `delassus run FILE`, or the signal that ended it, negative.
int outcomeOf(const std::string& path) {
  const int status =
      std::system((DELASSUS_COMMAND " run " + path + " --seconds 0.05 >/dev/null 2>&1").c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

TEST(BulletFileFuzz, DamagedFilesAreRefusedOrRead) {
  const std::string whole = serialised(*findScene("ragdolls").build());
  const auto path = std::filesystem::temp_directory_path() /
                    ("delassus_fuzz_" + std::to_string(getpid()) + ".bullet");
  std::map<int, int> shares;
  const int rounds = delassus::testing::fuzzRounds(60);
  for (int round = 0; round < rounds; ++round) {
    Random random = delassus::testing::fuzzRandom(round);
    const std::string bytes = round == 0 ? whole : mutated(whole, random);
    std::ofstream(path, std::ios::binary).write(bytes.data(), std::streamsize(bytes.size()));
    const int outcome = outcomeOf(path.string());
    ++shares[outcome];
    EXPECT_TRUE(outcome == 0 || outcome == 1) << "round " << round << ": " << outcome;
  }
  std::filesystem::remove(path);
  EXPECT_GT(shares[0], 0);
  if (!delassus::testing::isLongFuzz()) return;
  for (const auto& [outcome, count] : shares) std::printf("outcome %d: %d\n", outcome, count);
}

}  // namespace
}  // namespace demos
