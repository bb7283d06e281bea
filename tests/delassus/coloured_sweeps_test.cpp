/// Sweeps by colour: eight contacts at a time, in single precision.
#include "delassus/coloured_sweeps.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "delassus/flush_to_zero.h"
#include "delassus/one_contact.h"
#include "delassus/solver.h"
#include "tests/support/hired_hands.h"
#include "tests/support/random_piles.h"
#include "tests/support/sphere_heaps.h"
#include "tests/support/turning_piles.h"

namespace delassus {
namespace {

using namespace delassus::test;

/// About 400 contacts between spheres.
PileIsland heapOfSpheres(int seed, double friction = 0.5) {
  Random random(seed);
  return PileIsland(makeSphereHeap(200, 4.7, friction, 0.1, random));
}

/// A tower of boxes whose contacts have different friction, some none.
PileIsland towerOfMixedFriction(int height, Random& random) {
  Pile pile = makeTower(randomMasses(height, 10, random), 0, 0.3, random);
  mixFriction(pile, 1, random);
  return PileIsland(pile);
}

/// A plate on `count` points, each between the plate and the world: no two can have one colour.
PileIsland plateOnPoints(int count, Random& random) {
  Pile pile;
  pile.bodies.push_back(makeBox(10, 1, normalVector(6, random)));
  for (int k = 0; k < count; ++k)
    pile.contacts.push_back(
        makeRestingPoint(0, fixedWorld, normalVector(3, random), Vec3::Zero(), 0.5));
  return PileIsland(pile);
}

/// The same with contacts that resist rolling and spinning, some of them only up to a load. The
/// inertias are not the same about all axes.
Pile resistingTurning(Pile pile, Random& random) {
  for (Body& body : pile.bodies)
    body.inverseInertia.diagonal() *= uniform(random, 0.2, 1), body.inverseInertia(0, 0) *= 3;
  mixFriction(pile, 0.8, random);
  resistTurning(pile, 0.1, random);
  for (Row& row : pile.rows)
    if (uniform(random, 0, 1) < 0.3) row.mostLoad = uniform(random, 0.05, 0.5);
  return pile;
}

VectorXd velocities(const Problem& problem, const VectorXd& r) { return problem.W * r + problem.q; }

struct Swept {
  VectorXd r;
  int made;
};

Swept sweep(const Problem& problem, int most, double aim, VectorXd r, bool narrow = false) {
  NaturalMap map;
  map.setProblem(problem);
  ColouredSweeps sweeps;
  if (narrow) sweeps.narrow();
  EXPECT_TRUE(sweeps.setProblem(problem, map));
  const int made = sweeps.sweep(most, aim, velocities(problem, r), r);
  return {r, made};
}

VectorXd zero(const Problem& problem) { return VectorXd::Zero(problem.size()); }

TEST(ColouredSweeps, ReactionsStayInTheirCones) {
  Random random(71);
  for (int k = 0; k < 20; ++k) {
    const PileIsland island = towerOfMixedFriction(1 + k % 6, random);
    const VectorXd start = randomReactions(island.problem, 3, random);
    for (const int count : {1, 2, 7, 20}) {
      const VectorXd r = sweep(island.problem, count, 0, start).r;
      EXPECT_LE(infeasibility(island.problem, r), 1e-14 * (1 + r.norm())) << count << " sweeps";
    }
  }
}

TEST(ColouredSweeps, OneContactAloneIsSolved) {
  Random random(72);
  for (int k = 0; k < 100; ++k) {
    Pile pile;
    pile.bodies.push_back(makeBox(uniform(random, 1, 10), 0.5, normalVector(6, random)));
    pile.contacts.push_back(makeRestingPoint(0, fixedWorld, 0.5 * normalVector(3, random),
                                             Vec3::Zero(), uniform(random, 0, 1)));
    const Problem problem = PileIsland(pile).problem;
    const VectorXd exact =
        solveOneContact(problem.W.contactBlock(0), problem.q, problem.friction[0]);
    const VectorXd r = sweep(problem, 100, 0, randomReactions(problem, 1, random)).r;
    EXPECT_LT((r - exact).norm(), 1e-5 * (1 + exact.norm())) << k;
  }
}

// The result of the sweeps is compared with the measure in double precision and with the solver.
TEST(ColouredSweeps, ComeToTheAnswerOfTheSolver) {
  for (const double friction : {0.0, 0.1, 0.3}) {
    const PileIsland heap = heapOfSpheres(3, friction);
    Swept swept{zero(heap.problem), 0};
    for (int k = 0; k < 20; ++k) swept = sweep(heap.problem, 500, 1e-8, swept.r);
    EXPECT_LT(naturalResidual(heap.problem, swept.r).max, 1e-6) << friction;
    const Solution exact = Solver().solve(heap.problem);
    ASSERT_EQ(exact.status, Status::Solved);
    EXPECT_LT(motionDistance(heap, swept.r, exact.r), 1e-4) << friction;
  }
}

// Single precision limits the change that sweeps from one start make, not where they end. That
// includes sliding contacts, whose velocities stay large.
TEST(ColouredSweeps, FromTheirOwnEndGoOnToDoublePrecision) {
  for (const double friction : {0.1, 0.3, 0.5}) {
    const PileIsland heap = heapOfSpheres(3, friction);
    VectorXd r = zero(heap.problem);
    for (int k = 0; k < 40; ++k) r = sweep(heap.problem, 500, 1e-14, r).r;
    int sliding = 0;
    const VectorXd u = heap.problem.W * r + heap.problem.q;
    for (int i = 0; i < heap.problem.contacts(); ++i)
      sliding += r[3 * i] > 0 && u.segment<2>(3 * i + 1).norm() > 1e-3;
    EXPECT_GT(sliding, 10) << friction;
    EXPECT_LT(naturalResidual(heap.problem, r).max, 1e-12) << friction;
  }
}

// From millimetres and milligrams to light years, the same bits.
TEST(ColouredSweeps, OtherUnitsDoNotChangeABit) {
  Random random(7);
  const Pile own = makeSphereHeap(120, 4, 0.5, 0.1, random);
  const PileIsland heap(own);
  const VectorXd answer = sweep(heap.problem, 300, 1e-6, zero(heap.problem)).r;
  for (const auto& [lengths, masses] : {std::pair(10, 10), {-10, -20}, {-20, -60}, {53, 90}}) {
    const Problem other = PileIsland(inOtherUnits(own, lengths, masses)).problem;
    const Swept swept = sweep(other, 300, std::ldexp(1e-6, lengths), zero(other));
    EXPECT_TRUE(swept.r == answer * std::ldexp(1, lengths + masses)) << lengths << ' ' << masses;
  }
}

TEST(ColouredSweeps, AreLeftOnceTheirChangesAreSmall) {
  const PileIsland heap = heapOfSpheres(3, 0.1);
  int before = 0;
  for (const double aim : {1e-2, 1e-3, 1e-4}) {
    const Swept swept = sweep(heap.problem, 5000, aim, zero(heap.problem));
    EXPECT_GT(swept.made, before);
    EXPECT_LT(swept.made, 5000);
    before = swept.made;
    // One more sweep changes no velocity by much more than `aim`.
    const VectorXd next = sweep(heap.problem, 1, 0, swept.r).r;
    const VectorXd change = heap.problem.W.diagonal().cwiseProduct(next - swept.r);
    EXPECT_LT(change.cwiseAbs().maxCoeff(), 10 * aim);
  }
}

// Sweeps leave a solution where it is.
TEST(ColouredSweeps, ASolutionIsAFixedPoint) {
  const PileIsland heap = heapOfSpheres(5);
  const Solution exact = Solver().solve(heap.problem);
  ASSERT_EQ(exact.status, Status::Solved);
  const Swept swept = sweep(heap.problem, 20, 0, exact.r);
  EXPECT_LT(naturalResidual(heap.problem, swept.r).max, 1e-8);
  EXPECT_LT((swept.r - exact.r).norm(), 1e-7 * exact.r.norm());
}

// With momentum, sweeps find the slips of piles sooner than as many sweeps in calls of one, which
// begin anew every time.
TEST(ColouredSweeps, MomentumHurriesThem) {
  const PileIsland heap = heapOfSpheres(3, 0.1);
  VectorXd plain = zero(heap.problem);
  for (int k = 0; k < 200; ++k) plain = sweep(heap.problem, 1, 0, plain).r;
  const VectorXd hurried = sweep(heap.problem, 200, 0, zero(heap.problem)).r;
  EXPECT_LT(naturalResidual(heap.problem, hurried).rms,
            0.1 * naturalResidual(heap.problem, plain).rms);
}

// However many plain sweeps there are, each begins where the last has ended.
TEST(ColouredSweeps, PlainOnesHaveNoMomentum) {
  const PileIsland heap = heapOfSpheres(3, 0.1);
  NaturalMap map;
  map.setProblem(heap.problem);
  ColouredSweeps sweeps;
  ASSERT_TRUE(sweeps.setProblem(heap.problem, map));
  for (const int count : {0, 1, 100, 230}) {
    VectorXd plain = zero(heap.problem), single = plain;
    sweeps.sweepPlainly(count, plain);
    for (int k = 0; k < count; ++k) sweeps.sweep(1, 0, velocities(heap.problem, single), single);
    EXPECT_LT((plain - single).norm(), 1e-5 * single.norm() + 1e-300) << count;
  }
}

TEST(ColouredSweeps, TheWidthOfTheProcessorDoesNotChangeABit) {
  Random random(73);
  const PileIsland heap = heapOfSpheres(7), plate = plateOnPoints(100, random),
                   tower = towerOfMixedFriction(5, random);
  const PileIsland turning(resistingTurning(makeSphereHeap(100, 4.7, 0.5, 0.1, random), random));
  for (const Problem& problem : {heap.problem, plate.problem, tower.problem, turning.problem}) {
    const VectorXd start = randomReactions(problem, 1, random);
    EXPECT_EQ(sweep(problem, 50, 0, start, false).r, sweep(problem, 50, 0, start, true).r);
  }
}

TEST(ColouredSweeps, HandsDoNotChangeABit) {
  Random random(76);
  // The first island has rows too; the second has contacts that come one by one; the third disks.
  const PileIsland turning(
      resistingTurning(makeTower(randomMasses(100, 10, random), 0, 0.3, random), random));
  for (const PileIsland& island :
       {towerOfMixedFriction(300, random), plateOnPoints(1100, random), turning}) {
    const Problem& problem = island.problem;
    ASSERT_GE(problem.parts(), 1000);
    const VectorXd start = randomReactions(problem, 1, random);
    NaturalMap map;
    map.setProblem(problem);
    ColouredSweeps sweeps;
    ASSERT_TRUE(sweeps.setProblem(problem, map));
    VectorXd alone = start;
    sweeps.sweep(30, 0, velocities(problem, alone), alone);
    for (int count : {1, 2, 9}) {
      HiredHands hands(count);
      sweeps.setHands(&hands);
      VectorXd r = start;
      EXPECT_EQ(sweeps.sweep(30, 0, velocities(problem, r), r), 30);
      EXPECT_EQ(r, alone) << count << " hands";
      EXPECT_EQ(hands.tasks, 1);
      sweeps.setHands(nullptr);
      sweeps.sweep(1, 0, velocities(problem, r), r);
      EXPECT_EQ(hands.tasks, 1);
    }
  }
}

// The sweeps take numbers below the smallest normal one for zero; the caller keeps them.
TEST(ColouredSweeps, LeaveTheProcessorAsItWas) {
  const PileIsland heap = heapOfSpheres(3);
  volatile float small = 1e-38f;
  const auto isKept = [&] { return small * 0.1f > 0; };
  ASSERT_TRUE(isKept());
  sweep(heap.problem, 3, 0, zero(heap.problem));
  EXPECT_TRUE(isKept());
  {
    const FlushToZero quick;
#ifdef __SSE__
    EXPECT_FALSE(isKept());
#endif
  }
  EXPECT_TRUE(isKept());
}

// One body has more contacts than there are colours.
TEST(ColouredSweeps, ABodyMayHaveHundredsOfContacts) {
  Random random(74);
  const PileIsland plate = plateOnPoints(150, random);
  const Swept swept = sweep(plate.problem, 20000, 1e-9, zero(plate.problem));
  const double fallen = naturalResidual(plate.problem, zero(plate.problem)).max;
  EXPECT_LT(naturalResidual(plate.problem, swept.r).max, 1e-4 * fallen);
}

TEST(ColouredSweeps, NoneMeansNone) {
  const PileIsland heap = heapOfSpheres(2);
  Random random(75);
  const VectorXd start = randomReactions(heap.problem, 1, random);
  const Swept swept = sweep(heap.problem, 0, 0, start);
  EXPECT_EQ(swept.made, 0);
  EXPECT_LT((swept.r - start).norm(), 1e-14 * start.norm());
}

// One object serves many islands: nothing of the last one shows.
TEST(ColouredSweeps, HaveNoMemory) {
  const PileIsland large = heapOfSpheres(2), small = heapOfSpheres(4);
  NaturalMap largeMap, smallMap;
  largeMap.setProblem(large.problem);
  smallMap.setProblem(small.problem);
  ColouredSweeps used;
  for (int k = 0; k < 2; ++k) {
    VectorXd r = zero(large.problem);
    ASSERT_TRUE(used.setProblem(large.problem, largeMap));
    used.sweep(20, 0, velocities(large.problem, r), r);
    r = zero(small.problem);
    ASSERT_TRUE(used.setProblem(small.problem, smallMap));
    used.sweep(20, 0, velocities(small.problem, r), r);
    EXPECT_EQ(r, sweep(small.problem, 20, 0, zero(small.problem)).r);
  }
}

// A joint, a motor of bounded force, and contacts without friction beside others: the sweeps treat
// rows too.
TEST(ColouredSweeps, RowsKeepTheirBoundsAndComeToTheAnswer) {
  Random random(76);
  Pile pile = makeTower({2, 1, 3}, 0.4, 0.3, random);
  pile.contacts[0].friction = 0;
  pile.rows.push_back(makeWeakMotor());
  Row joint;
  joint.a = 2;
  joint.jacobianA << 1, 0, 0, 0, 0.5, 0;
  joint.compliance = 0.01;
  pile.rows.push_back(joint);
  const PileIsland island(pile);
  ASSERT_GT(island.problem.rows(), 2);
  Swept swept{zero(island.problem), 0};
  for (int k = 0; k < 20; ++k) swept = sweep(island.problem, 500, 1e-8, swept.r);
  EXPECT_LE(infeasibility(island.problem, swept.r), 1e-14 * (1 + swept.r.norm()));
  EXPECT_LT(naturalResidual(island.problem, swept.r).max, 1e-6);
}

// As for contacts that slide (FromTheirOwnEndGoOnToDoublePrecision), for disks that do.
TEST(ColouredSweeps, DisksStayOnTheirRimsAndComeToTheAnswer) {
  Random random(79);
  const PileIsland heap(resistingTurning(makeSphereHeap(100, 4.7, 0.5, 1, random), random));
  const Problem& problem = heap.problem;
  VectorXd r = randomReactions(problem, 1, random);
  for (int k = 0; k < 60; ++k) {
    r = sweep(problem, 500, 1e-14, r).r;
    ASSERT_LE(infeasibility(problem, r), 1e-14 * (1 + r.norm()));
  }
  const VectorXd u = velocities(problem, r);
  EXPECT_LT(naturalResidual(problem, r).max, 1e-11);
  int turning = 0, still = 0, full = 0;
  for (const Disk& disk : problem.disks) {
    if (!(disk.radiusAt(r) > 0)) continue;
    ++(disk.of(u).norm() > 1e-3 ? turning : still);
    full += disk.grows(r) ? 0 : 1;
  }
  EXPECT_GT(turning, 20);
  EXPECT_GT(still, 20);
  EXPECT_GT(full, 5);
}

TEST(ColouredSweeps, ADiskAloneIsSolved) {
  Random random(80);
  for (int k = 0; k < 100; ++k) {
    Pile pile;
    pile.bodies.push_back(makeBox(uniform(random, 1, 10), 0.5, normalVector(6, random)));
    pile.bodies[0].velocity[2] = -1;
    pile.contacts.push_back(makeRestingPoint(0, fixedWorld, {0, 0, -0.5}, Vec3::Zero(), k % 2));
    pile = resistingTurning(pile, random);
    const Problem problem = PileIsland(pile).problem;
    VectorXd r = sweep(problem, 200, 0, randomReactions(problem, 1, random)).r;
    EXPECT_LT(naturalResidual(problem, r).max, 1e-5) << k;  // the rim follows its load
    for (int pass = 0; pass < 10; ++pass) r = sweep(problem, 100, 0, r).r;
    EXPECT_LT(naturalResidual(problem, r).max, 1e-12) << k;
  }
}

TEST(ColouredSweeps, AreNotForExplicitEntries) {
  const auto isTaken = [](const Problem& problem) {
    NaturalMap map;
    map.setProblem(problem);
    return ColouredSweeps().setProblem(problem, map);
  };
  const PileIsland heap = heapOfSpheres(3);
  EXPECT_TRUE(isTaken(heap.problem));
  EXPECT_FALSE(isTaken(withEntries(heap.problem)));
}

}  // namespace
}  // namespace delassus
