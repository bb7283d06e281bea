/// Threads that a host lends to a solver.
#include <gtest/gtest.h>

#include <cfenv>

#include "delassus/solver.h"
#include "tests/support/box_piles.h"
#include "tests/support/hired_hands.h"
#include "tests/support/random_piles.h"
#include "tests/support/sphere_heaps.h"

namespace delassus {
namespace {

using namespace delassus::test;

// Without sweeps, all that hands can share is the factor. They may come before the first problem or
// later, and go again.
TEST(SolverHands, FactorLargeProblemsWithTheSameBits) {
  Random random(217);
  const PileIsland pile(makePyramid(8, 0.5, 0.1, 1, random));
  Options options;
  options.sweepBudget = 0;
  const auto expectSame = [](const Solution& a, const Solution& b) {
    EXPECT_EQ(a.r, b.r);
    EXPECT_EQ(a.regions, b.regions);
    EXPECT_EQ(a.factorisations, b.factorisations);
  };
  Solver alone(options), early(options), late(options);
  const Solution expected = alone.solve(pile.problem);
  EXPECT_GT(expected.factorisations, 0);
  HiredHands hands(2);
  early.setHands(&hands);
  expectSame(early.solve(pile.problem), expected);
  const int once = hands.tasks;
  EXPECT_GT(once, 0);

  late.solve(pile.problem);
  late.setHands(&hands);
  expectSame(late.solve(pile.problem), expected);
  EXPECT_EQ(hands.tasks, 2 * once);
  late.setHands(nullptr);
  expectSame(late.solve(pile.problem), expected);
  EXPECT_EQ(hands.tasks, 2 * once);
}

#ifdef __GLIBC__
/// Hands whose arithmetic traps.
class TrappingHands final : public Hands {
 public:
  int count() const override { return hired_.count(); }
  using Hands::together;
  void together(void (*work)(const void* context, int hand), const void* context) override {
    const auto trapping = [&](int hand) {
      if (hand > 0) feenableexcept(FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW);
      work(context, hand);
    };
    hired_.together(
        [](const void* of, int hand) { (*static_cast<const decltype(trapping)*>(of))(hand); },
        &trapping);
    tasks = hired_.tasks;
  }
  int tasks = 0;

 private:
  HiredHands hired_ = HiredHands(2);
};

// Walls that are never met lie at x/0, whatever the host's threads do then.
TEST(SolverHands, NoTrapOfAHostIsSprung) {
  Random random(218);
  const PileIsland heap(makeSphereHeap(900, 7, 0.5, 0.3, random));
  TrappingHands hands;
  Solver solver(Options::bounded(20));
  solver.setHands(&hands);
  EXPECT_TRUE(solver.solve(heap.problem).r.allFinite());
  EXPECT_GT(hands.tasks, 0);
}
#endif

}  // namespace
}  // namespace delassus
