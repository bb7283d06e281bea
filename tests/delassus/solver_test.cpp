/// What `Solved` promises, on piles of boxes with four contacts a face, mass ratios up to 1e3 and
/// friction up to 2.
#include "delassus/solver.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <limits>
#include <stdexcept>

#include "tests/support/certificate.h"
#include "tests/support/problem_samples.h"
#include "tests/support/random_piles.h"

namespace delassus {
namespace {

using namespace delassus::test;
using test::sameBits;

/// Towers and pyramids with targets as restitution and push-out make them; some also have motors
/// and joints.
PileIsland randomIsland(int k, double massRatio, double friction, Random& random) {
  const double disturbance = k % 3 == 0 ? 0 : uniform(random, 0, 1);
  Pile pile = k % 5 == 4
                  ? makePyramid(2 + k % 2, 0, disturbance,
                                std::pow(massRatio, uniform(random, -1, 1)), random)
                  : makeTower(randomMasses(1 + k % 8, massRatio, random), 0, disturbance, random);
  mixFriction(pile, friction, random);
  if (k % 4 == 1)
    for (Contact& c : pile.contacts) c.target[0] = uniform(random, 0, 0.2);
  if (k % 4 == 2) {
    pile.rows.push_back(makeWeakMotor());
    Row spring;
    spring.a = static_cast<int>(pile.bodies.size()) - 1;
    spring.jacobianA << 1, 0, 0, 0, 0.5, 0;
    spring.compliance = 0.1;
    pile.rows.push_back(spring);
  }
  return PileIsland(pile);
}

/// |M (v − v_f) − Jᵀ r|, body by body, with Jᵀ r added up from forces at points; relative to the
/// largest momentum.
double momentumError(const PileIsland& island, const VectorXd& r) {
  const Pile& pile = island.pile;
  std::vector<Vec6> momentum(pile.bodies.size(), Vec6::Zero());
  const auto push = [&](int body, const Vec3& arm, const Vec3& force) {
    if (body < 0) return;
    momentum[body].head<3>() += force;
    momentum[body].tail<3>() += arm.cross(force);
  };
  const auto pushContact = [&](const Contact& c, const Vec3& reaction) {
    push(c.a, c.armA, c.frame * reaction);
    push(c.b, c.armB, -(c.frame * reaction));
  };
  int at = 0;
  for (const int i : island.island.frictional) {
    pushContact(pile.contacts[i], r.segment<3>(at));
    at += 3;
  }
  for (const int i : island.island.frictionless) pushContact(pile.contacts[i], {r[at++], 0, 0});
  for (const int i : island.island.rows)
    momentum[pile.rows[i].a] += pile.rows[i].jacobianA.transpose() * r[at++];

  const std::vector<Body> after = island.after(r);
  double error = 0, size = 0;
  for (std::size_t i = 0; i < after.size(); ++i) {
    const Vec6 change = after[i].velocity - pile.bodies[i].velocity;
    Vec6 gained;
    gained << change.head<3>().cwiseQuotient(pile.bodies[i].inverseMass),
        pile.bodies[i].inverseInertia.inverse() * change.tail<3>();
    error = std::max(error, (gained - momentum[i]).norm());
    size = std::max({size, gained.norm(), r.cwiseAbs().maxCoeff()});
  }
  return error / std::max(size, 1e-300);
}

/// Checks the identity of the energies, and that contacts which obey their law only lose energy of
/// their own.
void expectEnergyIdentity(const PileIsland& island, const Solution& solution) {
  const EnergyBalance balance = energyBalance(island.problem, island.target, solution.r);
  const double before = kineticEnergy(island.pile.bodies);
  const double gained = kineticEnergy(island.after(solution.r)) - before;
  const double scale = before + std::abs(balance.impact) + std::abs(balance.targets);
  EXPECT_NEAR(balance.sum(), balance.change, 1e-11 * scale);
  EXPECT_NEAR(balance.change, gained, 1e-11 * scale);
  EXPECT_LE(balance.friction, 0);
  EXPECT_LE(balance.impact, 0);
  EXPECT_LE(balance.compliance, 0);
  // An error of the law by the residual does no more than this work on the reactions. Motors may
  // only drain energy.
  const double missed = 10 * solution.residual * solution.r.lpNorm<1>() + 1e-12 * scale;
  EXPECT_LE(balance.complementarity, missed);
  const bool motors = !island.pile.rows.empty();
  if (!motors) {
    EXPECT_GE(balance.complementarity, -missed);
  }
}

void expectHonest(const PileIsland& island, const Solution& solution, const Options& options) {
  const Problem& problem = island.problem;
  const double demand = problem.q.cwiseAbs().maxCoeff();
  const double recomputed = naturalResidual(problem, solution.r).max;
  const double roundOff = 1e-13 * (demand + problem.W.diagonal().cwiseProduct(solution.r).norm());
  EXPECT_NEAR(recomputed, solution.residual, roundOff);
  if (solution.status == Status::Solved) {
    EXPECT_LE(recomputed, std::max(options.tolerance * demand, problem.roundOff) + roundOff);
  }
  EXPECT_LT((problem.W * solution.r + problem.q - solution.u).cwiseAbs().maxCoeff(), roundOff);
  EXPECT_LE(infeasibility(problem, solution.r), options.tolerance * solution.r.norm());
  EXPECT_LE(solution.regions, options.newtonBudget);
  EXPECT_LE(solution.sweeps, options.sweepBudget);
  EXPECT_LT(momentumError(island, solution.r), 1e-12);
  expectEnergyIdentity(island, solution);
}

class Piles : public ::testing::TestWithParam<double> {};

TEST_P(Piles, SolvedMeansThatTheLawHolds) {
  const double massRatio = GetParam();
  Random random(71);
  int solved = 0;
  constexpr int samples = 200;
  const Options options;
  for (int k = 0; k < samples; ++k) {
    SCOPED_TRACE(k);
    const PileIsland island = randomIsland(k, massRatio, k % 2 ? 0.5 : 2, random);
    const Solution solution = Solver(options).solve(island.problem);
    EXPECT_NE(solution.status, Status::Incompatible);
    if (solution.status == Status::Solved) ++solved;
    expectHonest(island, solution, options);
  }
  EXPECT_GE(solved, massRatio <= 10 ? samples * 97 / 100 : samples * 9 / 10);
}

INSTANTIATE_TEST_SUITE_P(MassRatios, Piles, ::testing::Values(1, 10, 100, 1000));

// However small its budget, the solver is honest about its answer.
TEST(Solver, ASpentBudgetIsSaidAndNeverWorseThanTheGuess) {
  Random random(72);
  for (int k = 0; k < 100; ++k) {
    const PileIsland island = randomIsland(k, 1e3, 2, random);
    Options options = Options::bounded(k % 5 * 10);
    EXPECT_EQ(options.newtonBudget, std::max(1, options.sweepBudget / 20));
    if (k % 2) options.newtonBudget = k % 7;
    const VectorXd guess = randomReactions(island.problem, 0.1, random);
    const Solution solution = Solver(options).solve(island.problem, guess);
    EXPECT_LE(solution.residual, naturalResidual(island.problem, guess).max);
    EXPECT_LE(solution.regions, std::max(1, options.newtonBudget));  // a formula is one region
    expectHonest(island, solution, options);
  }
}

// Without friction Gauss' principle has one motion. A tower without disturbance rests, which is one
// motion, too.
TEST(Solver, TheMotionDoesNotDependOnTheGuessWhereItIsUnique) {
  Random random(73);
  Options options;
  options.tolerance = 1e-11;
  for (int k = 0; k < 100; ++k) {
    SCOPED_TRACE(k);
    const std::vector<double> masses = randomMasses(1 + k % 8, k % 2 ? 1e3 : 10, random);
    const PileIsland island(k % 4 < 2 ? withoutFriction(makeTower(masses, 0, 0.5, random))
                                      : makeTower(masses, 0.7, 0, random));
    const Solution cold = Solver(options).solve(island.problem);
    const Solution warm =
        Solver(options).solve(island.problem, randomReactions(island.problem, 0.3, random));
    EXPECT_EQ(cold.status, Status::Solved);
    EXPECT_EQ(warm.status, Status::Solved);
    EXPECT_LT(motionDistance(island, cold.r, warm.r), 1e-7);
  }
}

TEST(Solver, AGuessThatIsASolutionComesBackWithoutWork) {
  Random random(74);
  int inside = 0;
  for (int k = 0; k < 60; ++k) {
    const PileIsland island = randomIsland(k, 10, 1, random);
    Solver solver;
    const Solution first = solver.solve(island.problem);
    if (first.status != Status::Solved) continue;
    const Solution again = solver.solve(island.problem, first.r);
    EXPECT_EQ(again.regions, 0) << "island " << k;
    EXPECT_EQ(again.factorisations, 0);
    EXPECT_EQ(again.sweeps, 0);
    EXPECT_EQ(again.status, Status::Solved);
    EXPECT_LE((again.r - first.r).norm(), 1e-8 * first.r.norm());
    // The same bits, if round-off has left no reaction outside its cone in the solver's own
    // arithmetic.
    VectorXd allowed = first.r;
    makeFeasible(island.problem, allowed);
    if (!sameBits(allowed, first.r)) continue;
    ++inside;
    EXPECT_TRUE(sameBits(again.r, first.r)) << "island " << k;
    EXPECT_EQ(again.activeSet, first.activeSet);
  }
  EXPECT_GE(inside, 15);
}

TEST(Solver, TheGuessMayBeTheAnswersOwnReactions) {
  Random random(76);
  for (int k = 0; k < 20; ++k) {
    const PileIsland island = randomIsland(k, 10, 1, random);
    Solver solver;
    const Solution first = solver.solve(island.problem);
    const Solution apart = solver.solve(island.problem, first.r);
    Solution own = first;
    solver.solve(island.problem, own.r, own);
    EXPECT_EQ(own.tier, apart.tier);
    EXPECT_TRUE(sameBits(own.r, apart.r)) << "island " << k;
  }
}

TEST(Solver, AGuessThatIsNoNumberIsNone) {
  Random random(77);
  for (int k = 0; k < 20; ++k) {
    const PileIsland island = randomIsland(k, 10, 1, random);
    VectorXd guess = randomReactions(island.problem, 0.1, random);
    guess[k % guess.size()] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(
        sameBits(Solver().solve(island.problem, guess).r, Solver().solve(island.problem).r));
  }
}

// A chain of rows whose dense matrix would take 3 GB.
TEST(Solver, ManyExplicitRowsTakeNoDenseMatrix) {
  constexpr int n = 20000;
  Random random(78);
  DelassusMatrix::Sparse W(n, n);
  for (int i = 0; i < n; ++i)
    for (int j = std::max(0, i - 1); j < std::min(n, i + 2); ++j)
      W.insert(i, j) = i == j ? 2.5 : -1;
  Problem problem;
  problem.W = DelassusMatrix(W);
  problem.q = normalVector(n, random);
  problem.lower.setZero(n);
  problem.upper = VectorXd::Constant(n, infinity);
  const Solution solution = solve(problem);
  EXPECT_EQ(solution.status, Status::Solved);
  EXPECT_LE(naturalResidual(problem, solution.r).max, 1e-8 * problem.q.cwiseAbs().maxCoeff());
  EXPECT_EQ(solution.factorisations, 0);
}

// Contacts that rest, slide and open have the modes of these names.
TEST(Solver, ModesSayWhatTheMotionDoes) {
  Random random(75);
  int seen[3] = {};
  for (int k = 0; k < 60; ++k) {
    const PileIsland island = randomIsland(k, 10, 1, random);
    const Solution solution = Solver().solve(island.problem);
    ASSERT_EQ(solution.status, Status::Solved);
    const double small = 1e-6 * island.problem.q.cwiseAbs().maxCoeff();
    for (int i = 0; i < island.problem.contacts(); ++i) {
      const Vec3 u = solution.u.segment<3>(3 * i), r = solution.r.segment<3>(3 * i);
      const double slip = std::hypot(u[1], u[2]);
      const double weight = small / island.problem.W.contactBlock(3 * i).trace();
      const Mode mode = solution.activeSet.contacts[i];
      ++seen[static_cast<int>(mode)];
      if (u[0] > small) {
        EXPECT_EQ(mode, Mode::Open);
      }
      if (r[0] > weight) {
        EXPECT_NE(mode, Mode::Open);
      }
      if (r[0] > weight && slip > small) {
        EXPECT_EQ(mode, Mode::Slide);
      }
      if (mode == Mode::Stick) {
        EXPECT_LT(u.norm(), small);
      }
      if (mode == Mode::Open) {
        EXPECT_LT(r.norm(), weight);
      }
    }
  }
  for (const int count : seen) EXPECT_GT(count, 50);
}

// Where few contacts came or went, what is known of all the others is worth more than a fresh
// start.
TEST(Solver, AGuessThatIsFarWrongAtOneContactIsWorthMoreThanNone) {
  Random random(77);
  int warm = 0, cold = 0;
  for (int k = 0; k < 10; ++k) {
    const PileIsland island(makePyramid(4, 0.5, 0.1, 1, random));
    const Solution first = Solver().solve(island.problem);
    ASSERT_EQ(first.status, Status::Solved);
    VectorXd guess = first.r;
    guess.segment<3>(3 * (k * 7 % island.problem.contacts())) += Vec3(3, 0, 0);
    const Solution again = Solver().solve(island.problem, guess);
    EXPECT_EQ(again.status, Status::Solved);
    EXPECT_GT(again.startResidual, 0.1 * island.problem.q.cwiseAbs().maxCoeff());
    warm += again.regions;
    cold += first.regions;
  }
  EXPECT_LT(warm, cold);
}

TEST(Solver, AToleranceThatIsNoNumberIsRefused) {
  for (const double wrong : {0.0, -1e-8, 2.0, infinity, std::numeric_limits<double>::quiet_NaN()}) {
    Options options;
    options.tolerance = wrong;
    EXPECT_THROW(Solver{options}, std::invalid_argument) << wrong;
    EXPECT_THROW(solve(Problem(), options), std::invalid_argument) << wrong;
    options = {};
    options.guessShare = wrong;
    EXPECT_THROW(Solver{options}, std::invalid_argument) << wrong;
  }
  Options beyond;
  beyond.guessShare = 2;
  EXPECT_THROW(Solver{beyond}, std::invalid_argument);
}

// However wide the cone is, a contact that approaches must not be accepted because it also slides.
TEST(Solver, AWideConeHidesNoApproach) {
  int solved = 0;
  for (const double tolerance : {1e-8, 1e-3, 1e-2})
    for (const double mu : {0.5, 10.0, 1e3, 1e6, 1e9}) {
      SCOPED_TRACE(testing::Message() << "tolerance " << tolerance << ", friction " << mu);
      Pile pile;
      pile.bodies.push_back(makeBox(1, 0.5, (Vec6() << 1, 0, -1, 0, 0, 0).finished()));
      for (const double x : {-0.5, 0.5})
        for (const double y : {-0.5, 0.5})
          pile.contacts.push_back(makeRestingPoint(0, fixedWorld, {x, y, -0.5}, {x, y, 0}, mu));
      Options options;
      options.tolerance = tolerance;
      const Solution solution = Solver(options).solve(PileIsland(pile).problem);
      if (solution.status != Status::Solved) continue;
      ++solved;
      for (int i = 0; i < 4; ++i) EXPECT_GE(solution.u[3 * i], -2 * std::max(tolerance, 1e-5));
    }
  EXPECT_GE(solved, 12) << "of 15";
}

// A guess within the tolerance may be improved, and is never made worse.
TEST(Solver, PolishingNeverLosesWhatTheGuessHad) {
  Random random(78);
  Options options;
  options.guessShare = polishedShare;
  int polished = 0, better = 0;
  for (int k = 0; k < 200; ++k) {
    SCOPED_TRACE(k);
    const PileIsland island = randomIsland(k, 1e3, 1, random);
    const Solution first = Solver().solve(island.problem);
    if (first.status != Status::Solved) continue;
    const double tolerance = options.tolerance * island.problem.q.cwiseAbs().maxCoeff();
    VectorXd guess = first.r;
    for (double& r : guess) r *= 1 + uniform(random, -0.1, 0.1) * options.tolerance;
    const Solution again = Solver(options).solve(island.problem, guess);
    if (again.startResidual > tolerance) continue;
    EXPECT_EQ(again.status, Status::Solved);
    EXPECT_LE(again.residual, again.startResidual);
    EXPECT_LE(infeasibility(island.problem, again.r), 1e-12 * first.r.norm());
    polished += again.startResidual > polishedShare * tolerance;
    better += again.residual < 0.1 * again.startResidual;
  }
  EXPECT_GE(polished, 50);
  EXPECT_GE(2 * better, polished);
}

TEST(Solver, AGuessThatIsNotAllowedIsMovedIntoItsConeAndBounds) {
  // A sliding contact and a motor at its limit, which are not coupled. The guess solves them to
  // 1e-10, but lies outside of what is allowed.
  Problem problem;
  problem.W = DelassusMatrix(DelassusMatrix::Sparse(MatrixXd::Identity(4, 4).sparseView()));
  problem.q = Eigen::Vector4d(-1, 1, 0, -5);
  problem.friction = VectorXd::Constant(1, 0.5);
  problem.lower = VectorXd::Constant(1, -2);
  problem.upper = VectorXd::Constant(1, 2);
  const double outside = 1e-10;
  const Solution solution =
      Solver().solve(problem, Eigen::Vector4d(1, -0.5 - outside, 0, 2 + outside));
  EXPECT_EQ(solution.status, Status::Solved);
  EXPECT_LE(infeasibility(problem, solution.r), 1e-15);
}

TEST(Solver, HasNoMemoryOfEarlierProblems) {
  for (const Options& options : {Options(), Options::bounded(3)}) {
    Random random(212);
    Solver used(options);
    for (int k = 0; k < 24; ++k) {
      Pile pile = makeTower(randomMasses(2 + k % 5, 10, random), 0.6, 0.05, random);
      mixFriction(pile, 1, random);
      const PileIsland island(pile);
      const VectorXd guess =
          k % 2 ? VectorXd() : VectorXd(VectorXd::Constant(island.problem.size(), 0.01 * k));
      const Solution again = used.solve(island.problem, guess);
      EXPECT_EQ(again.r, Solver(options).solve(island.problem, guess).r) << k;
    }
  }
}

}  // namespace
}  // namespace delassus
