/// What stands or runs keeps to its place for as long as it is watched.
#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/report/stability/run_trial.h"

namespace demos::report::stability {
namespace {

void expectToLast(const std::string& name, double seconds) {
  const SweepGroup group = longRunSweeps();
  for (const Sweep& sweep : group.sweeps)
    if (sweep.name == name) {
      // Wandering is slow: looked at once in ten steps.
      EXPECT_LT(worstError(sweep.build(seconds), 10), sweep.allowed) << name;
      return;
    }
  FAIL() << "there is no long run " << name;
}

TEST(LongRuns, cube) { expectToLast("cube", 60); }
TEST(LongRuns, conveyor) { expectToLast("conveyor", 60); }
TEST(LongRuns, stackOfForty) { expectToLast("stack_40_long", 5); }

// Ten hours.
TEST(LongRunsSlow, cubeSlow) { expectToLast("cube", 36000); }
// One hour.
TEST(LongRunsSlow, conveyorSlow) { expectToLast("conveyor", 3600); }
TEST(LongRunsSlow, stackOfFortySlow) { expectToLast("stack_40_long", 3600); }
// Two minutes: its hour takes ten of the processor.
TEST(LongRunsSlow, archSlow) { expectToLast("arch_long", 120); }

}  // namespace
}  // namespace demos::report::stability
