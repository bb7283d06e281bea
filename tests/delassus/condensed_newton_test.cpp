/// Newton's method on contacts whose joints are eliminated.
#include "delassus/condensed_newton.h"

#include <gtest/gtest.h>

#include "delassus/proximal_walk.h"
#include "delassus/solver.h"
#include "tests/support/random_piles.h"
#include "tests/support/turning_piles.h"

namespace delassus {
namespace {

using namespace delassus::test;

/// Three rows that hold the point `armA` of a and the point `armB` of b together, and close the gap
/// between them.
void addBallJoint(Pile& pile, int a, int b, const Vec3& armA, const Vec3& armB, double target) {
  for (int k = 0; k < 3; ++k) {
    const Vec3 axis = Vec3::Unit(k);
    Row row;
    row.a = a, row.b = b;
    row.jacobianA << axis.transpose(), armA.cross(axis).transpose();
    row.jacobianB << -axis.transpose(), -armB.cross(axis).transpose();
    row.target = target;
    pile.rows.push_back(row);
  }
}

/// Boxes in a row on the ground, each joined to the next by a ball joint with a limit to its
/// bending. Some boxes stand on two points, some on four. One step of gravity and a disturbance.
Pile makeChain(int links, double friction, double disturbance, double massRatio, Random& random) {
  Pile pile;
  const std::vector<double> masses = randomMasses(links, massRatio, random);
  for (int i = 0; i < links; ++i) {
    Vec6 v = disturbance * normalVector(6, random);
    v[2] -= 9.81 / 60;
    pile.bodies.push_back(makeBox(masses[i], 0.5, v));
    for (double y : {-0.5, 0.5})
      for (double x : {-0.4, 0.4})
        if (x < 0 || i % 3 == 0)
          pile.contacts.push_back(
              makeRestingPoint(i, fixedWorld, {x, y, -0.5}, Vec3::Zero(), friction));
    if (i == 0) continue;
    addBallJoint(pile, i - 1, i, {0.5, 0, 0}, {-0.5, 0, 0}, 0.1 * uniform(random, -1, 1));
    Row limit;
    limit.a = i - 1, limit.b = i;
    limit.jacobianA[4] = 1, limit.jacobianB[4] = -1;
    limit.lower = 0;
    limit.target = uniform(random, -0.5, 0.1);
    pile.rows.push_back(limit);
  }
  return pile;
}

struct CondensedAttempt {
  bool reached = false;
  double tolerance = 0, before = 0;
  Solution solution;
};

/// Whether the method is for this problem. A row counts as within its bounds only if these do not
/// end at zero.
bool isFor(const Problem& problem, int most = 60) {
  NaturalMap map;
  map.setProblem(problem);
  return CondensedNewton().setProblem(problem, map, VectorXd::Zero(problem.size()), most);
}

CondensedAttempt condense(const Problem& problem, const VectorXd& start, int budget = 1000) {
  NaturalMap map;
  map.setProblem(problem);
  CondensedAttempt attempt;
  attempt.tolerance = 1e-9 * problem.q.cwiseAbs().maxCoeff();
  attempt.solution = startFrom(problem, map, start);
  attempt.before = attempt.solution.residual;
  CondensedNewton newton;
  EXPECT_TRUE(newton.setProblem(problem, map, attempt.solution.r, 60));
  attempt.reached = newton.solve(attempt.tolerance, budget, attempt.solution);
  return attempt;
}

CondensedAttempt condenseFromRest(const Problem& problem) {
  return condense(problem, VectorXd::Zero(problem.size()));
}

TEST(CondensedNewton, ReachedMeansThatTheLawHolds) {
  Random random(211);
  int reached = 0;
  constexpr int samples = 200;
  for (int k = 0; k < samples; ++k) {
    const PileIsland chain(
        makeChain(2 + k % 4, uniform(random, 0.05, 0.8), k % 2 ? 0.5 : 0.01, 10, random));
    const CondensedAttempt attempt = condenseFromRest(chain.problem);
    EXPECT_LE(attempt.solution.residual, attempt.before);
    EXPECT_LE(infeasibility(chain.problem, attempt.solution.r), 1e-15);
    EXPECT_EQ(attempt.reached, attempt.solution.residual <= attempt.tolerance);
    if (!attempt.reached) continue;
    ++reached;
    EXPECT_LE(naturalResidual(chain.problem, attempt.solution.r).max, 1.01 * attempt.tolerance);
  }
  EXPECT_GE(reached, 0.9 * samples);
}

// Without friction there is one motion, whichever method finds it.
TEST(CondensedNewton, MovesAsTheWalkDoes) {
  Random random(212);
  int compared = 0;
  for (int k = 0; k < 100; ++k) {
    Pile pile = makeChain(2 + k % 4, 0.3, 0.2, 100, random);
    for (Contact& contact : pile.contacts) contact.friction = 0;
    const PileIsland chain(pile);
    const CondensedAttempt attempt = condenseFromRest(chain.problem);
    NaturalMap map;
    map.setProblem(chain.problem);
    ProximalSpace<BodyMotion> space;
    space.setProblem(chain.problem, map);
    Solution other = startFrom(chain.problem, map, VectorXd::Zero(chain.problem.size()));
    const Outcome outcome =
        ProximalWalk<BodyMotion>(space).walk(attempt.tolerance, 1e-2, 400, other);
    if (!attempt.reached || outcome != Outcome::Reached) continue;
    ++compared;
    EXPECT_LE(motionDistance(chain, attempt.solution.r, other.r), 1e-6);
  }
  EXPECT_GE(compared, 90);
}

// From the answer of a like problem and from a wrong one, it comes to the same motion.
TEST(CondensedNewton, BeginsAnywhere) {
  Random random(213);
  int compared = 0;
  for (int k = 0; k < 50; ++k) {
    const PileIsland chain(makeChain(3, 0, 0.2, 10, random));
    const CondensedAttempt rest = condenseFromRest(chain.problem);
    const CondensedAttempt far = condense(chain.problem, randomReactions(chain.problem, 1, random));
    if (!rest.reached || !far.reached) continue;
    ++compared;
    EXPECT_LE(motionDistance(chain, rest.solution.r, far.solution.r), 1e-6);
    const CondensedAttempt again = condense(chain.problem, rest.solution.r);
    EXPECT_TRUE(again.reached);
    EXPECT_LE(again.solution.sweeps, rest.solution.sweeps);
  }
  EXPECT_GE(compared, 40);
}

// Two joints in one place, which give by next to nothing: what they hold together is determined,
// their shares are not.
TEST(CondensedNewton, JointsThatHoldTheSameTwice) {
  Random random(214);
  int reached = 0;
  for (int k = 0; k < 50; ++k) {
    Pile pile = makeChain(3, 0.4, 0.1, 1, random);
    addBallJoint(pile, 0, 1, {0.5, 0, 0}, {-0.5, 0, 0}, pile.rows[0].target);
    for (Row& row : pile.rows) row.compliance = std::isinf(row.lower) ? 1e-10 : 0;
    const PileIsland chain(pile);
    const CondensedAttempt attempt = condenseFromRest(chain.problem);
    reached += attempt.reached ? 1 : 0;
    if (attempt.reached) {
      EXPECT_LE(attempt.solution.r.cwiseAbs().maxCoeff(), 100);
    }
  }
  EXPECT_GE(reached, 45);
}

TEST(CondensedNewton, KeepsItsBudget) {
  Random random(215);
  for (int budget = 0; budget < 12; ++budget) {
    const PileIsland chain(makeChain(5, 0.3, 0.5, 10, random));
    const CondensedAttempt attempt =
        condense(chain.problem, VectorXd::Zero(chain.problem.size()), budget);
    EXPECT_LE(attempt.solution.sweeps, budget);
    EXPECT_EQ(attempt.solution.regions, 1);
    EXPECT_LE(attempt.solution.residual, attempt.before);
  }
}

TEST(CondensedNewton, LeavesToOthersWhatHasManyContacts) {
  Random random(216);
  const PileIsland chain(makeChain(4, 0.3, 0.1, 1, random));
  EXPECT_TRUE(isFor(chain.problem));
  EXPECT_FALSE(isFor(withEntries(chain.problem)));
  EXPECT_FALSE(isFor(PileIsland(makeChain(12, 0.3, 0.1, 1, random)).problem));
  Pile turning = makeChain(4, 0.3, 0.1, 1, random);
  for (int i = 0; i < static_cast<int>(turning.contacts.size()); ++i)
    addRows(aboutTangents(turning.contacts[i], 0.1, 0.1), turning.contacts[i], i, turning.rows);
  EXPECT_FALSE(isFor(PileIsland(turning).problem));
  Pile alone = makeChain(4, 0.3, 0.1, 1, random);
  alone.contacts.clear();
  for (Row& row : alone.rows) row.lower = -infinity;
  EXPECT_FALSE(isFor(PileIsland(alone).problem));
}

// Boxes that touch, without a joint, are left as they are: nothing is eliminated.
TEST(CondensedNewton, FewContactsWithoutJoints) {
  Random random(219);
  int reached = 0;
  constexpr int samples = 100;
  for (int k = 0; k < samples; ++k) {
    const PileIsland tower(
        makeTower(randomMasses(1 + k % 2, 10, random), 0.5, k % 3 * 0.1, random));
    const CondensedAttempt attempt = condenseFromRest(tower.problem);
    EXPECT_LE(attempt.solution.residual, attempt.before);
    EXPECT_LE(infeasibility(tower.problem, attempt.solution.r), 1e-15);
    reached += attempt.reached ? 1 : 0;
  }
  EXPECT_GE(reached, 0.8 * samples);
}

// Contacts that resist rolling and spinning, some up to a load: of balls alone, and of links whose
// joints are eliminated. Of contacts without friction a row governs the disk.
TEST(CondensedNewton, TurningFriction) {
  Random random(220);
  int tried = 0, reached = 0, again = 0;
  constexpr int samples = 200;
  for (int k = 0; k < samples; ++k) {
    Pile pile =
        k % 2 ? makeHeap(1 + k % 3, 0.5, random) : makeChain(2 + k % 3, 0.5, 0.2, 10, random);
    mixFriction(pile, 0.8, random);
    resistTurning(pile, 0.1, random);
    for (Row& row : pile.rows)
      if (row.governor >= 0 && uniform(random, 0, 1) < 0.3)
        row.mostLoad = uniform(random, 0.01, 0.3);
    const PileIsland island(pile);
    if (!isFor(island.problem)) continue;
    ++tried;
    const CondensedAttempt attempt = condenseFromRest(island.problem);
    EXPECT_LE(attempt.solution.residual, attempt.before);
    EXPECT_LE(infeasibility(island.problem, attempt.solution.r), 1e-15);
    EXPECT_EQ(attempt.reached, attempt.solution.residual <= attempt.tolerance);
    if (!attempt.reached) continue;
    ++reached;
    EXPECT_LE(naturalResidual(island.problem, attempt.solution.r).max, 1.01 * attempt.tolerance);
    const VectorXd nearly =
        attempt.solution.r +
        1e-4 * attempt.solution.r.cwiseProduct(normalVector(island.problem.size(), random));
    const CondensedAttempt second = condense(island.problem, nearly);
    again += second.reached && second.solution.sweeps <= 5 ? 1 : 0;
  }
  EXPECT_GE(tried, 0.5 * samples);
  EXPECT_GE(reached, 0.9 * tried);
  EXPECT_GE(again, 0.9 * reached);
}

// Balls that resist rolling are solved under any bound on the work: a region is all they need.
TEST(CondensedNewton, FewSweepsSolveBallsThatResistRolling) {
  Random random(222);
  Options one;
  one.sweepBudget = 1;
  one.newtonBudget = 1;
  int solved = 0;
  constexpr int samples = 100;
  for (int k = 0; k < samples; ++k) {
    Pile pile = makeHeap(1 + k % 2, 0.5, random);
    for (int i = 0; i < static_cast<int>(pile.contacts.size()); ++i)
      addRows(aboutTangents(pile.contacts[i], 0.05, 0.1), pile.contacts[i], i, pile.rows);
    const Solution solution = solve(PileIsland(pile).problem, one);
    EXPECT_LE(solution.regions, 1);
    solved += solution.status == Status::Solved ? 1 : 0;
  }
  EXPECT_GE(solved, 0.95 * samples);
}

// A row that governs a disk is not eliminated, although it is within its bounds.
TEST(CondensedNewton, LeavesWhatGovernsADisk) {
  Random random(221);
  Pile pile = makeHeap(1, 0, random);
  pile.rows.push_back(makeWeakMotor());
  addRows(aboutTangents(pile.contacts[0], 0, 0.1), pile.contacts[0], 0, pile.rows);
  const PileIsland ball(pile);
  ASSERT_EQ(ball.problem.disks.size(), 1U);
  VectorXd r = VectorXd::Zero(ball.problem.size());
  r[ball.problem.disks[0].governor] = 1;
  NaturalMap map;
  map.setProblem(ball.problem);
  EXPECT_TRUE(CondensedNewton().setProblem(ball.problem, map, r, 3));
  EXPECT_FALSE(CondensedNewton().setProblem(ball.problem, map, r, 2));
}

// Joints that break, or strong motors, make rows whose bounds are far away. Where there are many of
// them, they are held.
TEST(CondensedNewton, HoldsWhatIsWithinItsBounds) {
  Random random(218);
  int reached = 0;
  for (int k = 0; k < 20; ++k) {
    Pile pile = makeChain(4, 0.3, 0.1, 1, random);
    for (Row& row : pile.rows)
      if (std::isinf(row.lower)) row.lower = -100, row.upper = 100;
    const PileIsland chain(pile);
    const int contactsEnd = 3 * chain.problem.contacts(), limits = 3;
    EXPECT_FALSE(isFor(chain.problem, contactsEnd + limits - 1));
    EXPECT_TRUE(isFor(chain.problem, contactsEnd + limits));
    NaturalMap map;
    map.setProblem(chain.problem);
    Solution best = startFrom(chain.problem, map, VectorXd::Zero(chain.problem.size()));
    CondensedNewton newton;
    newton.setProblem(chain.problem, map, best.r, contactsEnd + limits);
    const double tolerance = 1e-9 * chain.problem.q.cwiseAbs().maxCoeff();
    reached += newton.solve(tolerance, 1000, best) ? 1 : 0;
    EXPECT_LE(infeasibility(chain.problem, best.r), 1e-15);
  }
  EXPECT_GE(reached, 15);
}

// Rows that are within their bounds are held where nothing else is, and nothing may be left. One
// factor then solves all, if the bounds are wide enough; and if not, that is told.
TEST(CondensedNewton, NothingMayBeLeft) {
  Random random(218);
  for (const double bound : {1e-3, 1e3}) {
    Pile pile = makeChain(12, 0.3, 0.1, 10, random);
    pile.contacts.clear();
    for (Row& row : pile.rows) row.lower = -bound, row.upper = bound;
    const PileIsland chain(pile);
    EXPECT_TRUE(isFor(chain.problem));
    const CondensedAttempt attempt = condenseFromRest(chain.problem);
    EXPECT_EQ(attempt.reached, bound > 1);
    EXPECT_EQ(attempt.reached, attempt.solution.residual <= attempt.tolerance);
    EXPECT_EQ(attempt.solution.regions, 1);
    EXPECT_LE(attempt.solution.residual, attempt.before);
  }
}

// The solver takes this method where sweeps would have to pass impulses along a chain body by body;
// also with few sweeps.
TEST(CondensedNewton, IsWhereTheSolverBegins) {
  Random random(217);
  int first = 0, exact = 0;
  for (int k = 0; k < 50; ++k) {
    const PileIsland chain(makeChain(5, 0.3, 0.1, 10, random));
    const Solution solution = solve(chain.problem);
    EXPECT_EQ(solution.status, Status::Solved);
    first += solution.regions == 1 && solution.sweeps <= 30 ? 1 : 0;
    Options few;
    few.sweepBudget = 20;
    few.newtonBudget = 1;
    const Solution bounded = solve(chain.problem, few);
    EXPECT_EQ(bounded.regions, 1);
    exact += bounded.status == Status::Solved ? 1 : 0;
  }
  EXPECT_GE(first, 40);
  EXPECT_GE(exact, 40);
}

}  // namespace
}  // namespace delassus
