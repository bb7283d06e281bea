// A crash of the command: what is blamed for it, and what is not lost.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "tests/command_call.h"
#include "tests/support/shared_data.h"

namespace {

using delassus::test::lines;
using delassus::test::Outcome;

class Crash : public delassus::test::CommandCall {};

/// A damaged file may break something at once or at any later time.
TEST_F(Crash, IsBlamedOnTheFile) {
  const std::vector<std::filesystem::path> worlds =
      delassus::test::sharedFiles("worlds", {".bullet"});
  if (worlds.empty()) GTEST_SKIP() << delassus::test::noSharedFolder;
  const std::string path = worlds.front();
  // The signal must come after the run has begun, which may take time on a busy machine.
  Outcome crash;
  for (const char* delay : {"0.5", "2", "8"}) {
    crash = call("run --seconds 1e4 " + path,
                 std::string("timeout --preserve-status --signal=SEGV ") + delay);
    if (crash.err.find("is damaged") == std::string::npos) break;
  }
  EXPECT_EQ(crash.status, 1);
  EXPECT_NE(crash.err.find(path + ": crashes"), std::string::npos) << crash.err;
  EXPECT_EQ(lines(crash.err), 1) << crash.err;
}

// The output of what was done before is as if nothing had happened.
TEST_F(Crash, IsBlamedOnTheSolverOfBullet) {
  // Our solver has a millisecond's work; the sweeps of the other one take hours.
  const std::string arguments = "run one_box --seconds 1 --solver delassus,si:10000000,si:1";
  for (const bool json : {false, true}) {
    Outcome crash;
    for (const char* delay : {"0.5", "2", "8"}) {
      crash = call(arguments + (json ? " --json" : ""),
                   std::string("timeout --preserve-status --signal=SEGV ") + delay);
      if (!crash.out.empty()) break;
    }
    EXPECT_EQ(crash.status, 1);
    EXPECT_EQ(crash.err, "delassus: one_box: Bullet's own solver si:10000000 crashes on it\n");
    EXPECT_NE(crash.out.find("delassus"), std::string::npos) << crash.out;
    EXPECT_EQ(crash.out.find("si:"), std::string::npos) << crash.out;
    EXPECT_EQ(lines(crash.out), json ? 1 : 4) << crash.out;
  }
}

}  // namespace
