/// Scenes that stand or run keep to their place for as long as they are watched.
#include <gtest/gtest.h>

#include <stdexcept>

#include "demos/scenes/measures.h"
#include "tests/report/stability/run_trial.h"

namespace demos::report::stability {
namespace {

Sweep sweepOf(const std::string& name) {
  for (const Sweep& sweep : longRunSweeps().sweeps)
    if (sweep.name == name) return sweep;
  throw std::runtime_error("there is no long run " + name);
}

void expectToLast(const std::string& name, double seconds) {
  const Sweep sweep = sweepOf(name);
  // Wandering is slow, so one look in ten steps is enough.
  EXPECT_LT(worstError(sweep.build(seconds), 10), sweep.allowed);
}

TEST(LongRuns, Cube) { expectToLast("cube", 60); }
TEST(LongRuns, Conveyor) { expectToLast("conveyor", 60); }
TEST(LongRuns, StackOfForty) { expectToLast("stack_40_long", 5); }

// Ten hours.
TEST(LongRunsSlow, CubeSlow) { expectToLast("cube", 36000); }
// One hour.
TEST(LongRunsSlow, ConveyorSlow) { expectToLast("conveyor", 3600); }
TEST(LongRunsSlow, StackOfFortySlow) { expectToLast("stack_40_long", 3600); }
// Two minutes, since an hour of it takes three to twenty hours of the processor.
TEST(LongRunsSlow, ArchSlow) { expectToLast("arch_long", 120); }

// Only the recovery of depths that the narrow phase brings in moves the arch.
TEST(LongRunsSlow, ArchWithoutRecoveryStaysWhereItSettledSlow) {
  constexpr double settled = 20, rate = 60;
  NamedSolver named("delassus");
  Trial trial = sweepOf("arch_unrecovered").build(60);
  trial.world->setSolver(named.solver());
  trial.world->run(settled, rate);
  const Drift drift(*trial.world);
  trial.world->run(60 - settled, rate);
  EXPECT_LT(drift.largest(), 1e-7);
  trial.world.reset();  // before its solver
}

}  // namespace
}  // namespace demos::report::stability
