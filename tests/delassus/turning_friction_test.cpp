/// Rolling and spinning friction: closed forms of one ball, and the law on islands.
#include "delassus/turning_friction.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "delassus/proximal_walk.h"
#include "delassus/solver.h"
#include "delassus/sweeps.h"
#include "tests/support/certificate.h"
#include "tests/support/random_piles.h"
#include "tests/support/turning_piles.h"

namespace delassus {
namespace {

using namespace delassus::test;

constexpr double g = 9.81, h = 1.0 / 60, mass = 2.5, radius = 0.3;
constexpr double inertia = 0.4 * mass * radius * radius;

/// A ball on a plane that is tilted about y by `slope`: x runs down, z is the normal.
class BallOnPlane {
 public:
  BallOnPlane(double friction, double spinning, double rolling, double slope = 0) {
    ball_.inverseMass.setConstant(1 / mass);
    ball_.inverseInertia = Mat3::Identity() / inertia;
    gravity_ = g * Vec3(std::sin(slope), 0, -std::cos(slope));
    contacts_.push_back(makeRestingPoint(0, fixedWorld, {0, 0, -radius}, Vec3::Zero(), friction));
    addRows(aboutTangents(contacts_[0], spinning, rolling), contacts_[0], 0, rows_);
  }
  void roll(const Vec3& velocity) {
    ball_.velocity << velocity, Vec3(0, 0, 1 / radius).cross(velocity);
  }
  void spin(double rate) { ball_.velocity[5] += rate; }
  void push(const Vec3& torque) { torque_ = torque; }

  /// One step; the search begins with the reactions of the last one.
  void step() {
    std::vector<Body> bodies{ball_};
    bodies[0].velocity.head<3>() += h * gravity_;
    bodies[0].velocity.tail<3>() += h / inertia * torque_;
    const Island island = splitIslands(bodies, contacts_, rows_).at(0);
    solution_ = solver_.solve(assemble(bodies, contacts_, rows_, island), solution_.r);
    EXPECT_EQ(solution_.status, Status::Solved);
    applyReaction(bodies, contacts_, rows_, island, solution_.r);
    ball_ = bodies[0];
  }
  Vec3 velocity() const { return ball_.velocity.head<3>(); }
  Vec3 rotation() const { return ball_.velocity.tail<3>(); }
  const Solution& solution() const { return solution_; }

 private:
  Body ball_;
  Vec3 gravity_, torque_ = Vec3::Zero();
  std::vector<Contact> contacts_;
  std::vector<Row> rows_;
  Solver solver_;
  Solution solution_;
};

TEST(TurningFriction, RollingBallLosesSevenfold) {
  // (I + m R²) dω/dt = −κ m g, with I = 2/5 m R²: the ball loses 5/7 κ g / R.
  constexpr double kappa = 0.004;
  const double loss = 5.0 / 7 * kappa * g / radius;
  for (double direction : {0.0, 0.7, 2.5}) {
    BallOnPlane ball(0.5, 0, kappa);
    double speed = 30.5 * loss * h;
    const Vec3 along(std::cos(direction), std::sin(direction), 0);
    ball.roll(speed * along);
    for (int i = 0; i < 30; ++i) {
      ball.step();
      speed -= loss * h;
      ASSERT_LT((ball.velocity() - speed * along).norm(), 1e-9);
      EXPECT_EQ(ball.solution().activeSet.disks, std::vector<Mode>{Mode::Slide});
      EXPECT_EQ(ball.solution().activeSet.contacts, std::vector<Mode>{Mode::Stick});
    }
    ball.step();
    EXPECT_LT(ball.velocity().norm(), 1e-9) << "half a step's loss is left: it stops and stays";
    EXPECT_EQ(ball.solution().activeSet.disks, std::vector<Mode>{Mode::Stick});
  }
}

TEST(TurningFriction, BallOnInclineHoldsUpToItsAngle) {
  constexpr double kappa = 0.03;
  const double limit = std::atan(kappa / radius);
  for (double part : {0.5, 0.999, 1.001, 1.5}) {
    const double slope = part * limit;
    BallOnPlane ball(0.8, 0, kappa, slope);
    constexpr int steps = 20;
    for (int i = 0; i < steps; ++i) ball.step();
    const double excess = std::sin(slope) - kappa / radius * std::cos(slope);
    const double acceleration = 5.0 / 7 * g * std::max(0.0, excess);
    EXPECT_NEAR(ball.velocity()[0], acceleration * steps * h, 1e-9) << part;
    EXPECT_NEAR(ball.rotation()[1], ball.velocity()[0] / radius, 1e-8) << part;
  }
}

TEST(TurningFriction, BallOnASteepInclineSlidesAndRolls) {
  // Sliding friction μ m g cos θ turns the ball; κ m g cos θ resists.
  constexpr double kappa = 0.02, mu = 0.1, slope = 1;
  BallOnPlane ball(mu, 0, kappa, slope);
  constexpr int steps = 20;
  for (int i = 0; i < steps; ++i) ball.step();
  const double t = steps * h;
  EXPECT_NEAR(ball.velocity()[0], g * t * (std::sin(slope) - mu * std::cos(slope)), 1e-8);
  EXPECT_NEAR(ball.rotation()[1], mass * g * std::cos(slope) * (mu * radius - kappa) / inertia * t,
              1e-8);
}

TEST(TurningFriction, SpinningAloneStopsTheTop) {
  constexpr double kappa = 0.002;
  const double loss = kappa * mass * g / inertia;
  for (double friction : {0.0, 0.6}) {
    BallOnPlane ball(friction, kappa, 0);
    double rate = 15.5 * loss * h;
    ball.spin(rate);
    for (int i = 0; i < 15; ++i) {
      ball.step();
      rate -= loss * h;
      ASSERT_NEAR(ball.rotation()[2], rate, 1e-9);
    }
    ball.step();
    EXPECT_NEAR(ball.rotation()[2], 0, 1e-9);
  }
}

TEST(TurningFriction, SpinningAloneLeavesRollingFree) {
  BallOnPlane ball(0.6, 0.01, 0);
  const Vec3 velocity(1, 2, 0);
  ball.roll(velocity);
  for (int i = 0; i < 10; ++i) ball.step();
  EXPECT_LT((ball.velocity() - velocity).norm(), 1e-9);
}

TEST(TurningFriction, ResistsATorqueUpToItsBound) {
  constexpr double kappa = 0.01, bound = kappa * mass * g;
  for (double part : {0.99, 1.5}) {
    BallOnPlane ball(0.6, kappa, 0);
    ball.push({0, 0, part * bound});
    ball.step();
    EXPECT_NEAR(ball.rotation()[2], std::max(0.0, part - 1) * bound * h / inertia, 1e-9);
  }
}

// A ball between two walls that close in, one of which resists spinning. No motion meets both
// demands, and no spin withstands such a grip.
TEST(TurningFriction, ASqueezedBallStopsSpinning) {
  Body ball;
  ball.inverseMass.setConstant(1 / mass);
  ball.inverseInertia = Mat3::Identity() / inertia;
  ball.velocity << 0, 0, 0, 0, 0, 3;
  std::vector<Contact> contacts{makeRestingPoint(0, fixedWorld, {0, 0, -radius}, Vec3::Zero(), 0),
                                makeRestingPoint(0, fixedWorld, {0, 0, radius}, Vec3::Zero(), 0)};
  contacts[1].frame.col(0) *= -1;
  for (Contact& c : contacts) c.target[0] = 1;
  std::vector<Row> rows;
  addRows(aboutTangents(contacts[0], 0.01, 0), contacts[0], 0, rows);
  const Island island = splitIslands({ball}, contacts, rows).at(0);
  const Problem problem = assemble({ball}, contacts, rows, island);
  const Solution s = solve(problem);
  EXPECT_EQ(s.status, Status::Incompatible);
  EXPECT_EQ(s.blamed, (std::vector<int>{0, 1}));
  EXPECT_NEAR(s.u[2], 0, 1e-6);
  EXPECT_LE(std::abs(s.r[2]), 0.01 * s.r[0] * (1 + 1e-8));
}

TEST(TurningFriction, BallInTheAirTurnsFreely) {
  Body ball;
  ball.inverseMass.setConstant(1 / mass);
  ball.inverseInertia = Mat3::Identity() / inertia;
  ball.velocity << 0, 0, 0.5, 1, 2, 3;
  const std::vector<Contact> contacts{
      makeRestingPoint(0, fixedWorld, {0, 0, -radius}, Vec3::Zero(), 0.5)};
  std::vector<Row> rows;
  addRows(aboutTangents(contacts[0], 0.1, 0.1), contacts[0], 0, rows);
  const Island island = splitIslands({ball}, contacts, rows).at(0);
  const Solution solution = solve(assemble({ball}, contacts, rows, island));
  EXPECT_TRUE(solution.r.isZero(0));
  EXPECT_EQ(solution.activeSet.disks, (std::vector<Mode>{Mode::Open, Mode::Open}));
}

/// How far r is from the law of the disks: outside its disk, or not opposite to u, N·m·s and J.
void expectLaw(const Problem& problem, const Solution& s, double rounding) {
  for (const Disk& disk : problem.disks) {
    const Vec2 r = disk.of(s.r), u = disk.of(s.u);
    const double bound = disk.radius * std::min(s.r[disk.governor], disk.mostLoad);
    EXPECT_LE(r.norm(), bound + rounding);
    EXPECT_NEAR(r.dot(u), -bound * u.norm(), rounding);
  }
}

TEST(TurningFriction, IslandsKeepTheLaw) {
  Random random(7);
  for (int k = 0; k < 60; ++k) {
    Pile pile = k % 2 ? makeTower(randomMasses(1 + k % 6, 3, random), 0.6, 0.3, random)
                      : makeHeap(2 + k % 9, uniform(random, 0, 1), random);
    if (k % 3 == 0) mixFriction(pile, 1, random);
    resistTurning(pile, 0.2, random);
    const PileIsland island(std::move(pile));
    for (const Problem& problem : {island.problem, withEntries(island.problem)}) {
      const Solution s = solve(problem);
      EXPECT_EQ(s.status, Status::Solved) << k;
      EXPECT_LE(naturalResidual(problem, s.r).max, 1e-8 * problem.q.cwiseAbs().maxCoeff()) << k;
      expectLaw(problem, s, 1e-7);
      const EnergyBalance energy = energyBalance(problem, island.target, s.r);
      EXPECT_NEAR(energy.complementarity, 0, 1e-7) << k;
      EXPECT_LE(energy.change, 1e-7) << "friction only takes";
    }
  }
}

TEST(TurningFriction, IslandsKeepTheLawOfAMostLoad) {
  Random random(13);
  int full = 0, growing = 0;
  for (int k = 0; k < 60; ++k) {
    Pile pile = k % 2 ? makeTower(randomMasses(1 + k % 6, 3, random), 0.6, 0.3, random)
                      : makeHeap(2 + k % 9, uniform(random, 0, 1), random);
    resistTurning(pile, 0.5, random);
    const double mostLoad = uniform(random, 0.05, 0.5);
    for (Row& row : pile.rows) row.mostLoad = mostLoad;
    const PileIsland island(std::move(pile));
    for (const Problem& problem : {island.problem, withEntries(island.problem)}) {
      const Solution s = solve(problem);
      EXPECT_EQ(s.status, Status::Solved) << k;
      expectLaw(problem, s, 1e-7);
      for (const Disk& disk : problem.disks)
        if (s.r[disk.governor] > 0) ++(disk.grows(s.r) ? growing : full);
    }
  }
  EXPECT_GT(full, 100);
  EXPECT_GT(growing, 100);
}

TEST(TurningFriction, BallsInTheAirKeepTheirMomentum) {
  Random random(11);
  Pile pile = makeHeap(8, 0.5, random);
  Pile apart;  // without the ground
  apart.bodies = pile.bodies;
  for (const Contact& c : pile.contacts)
    if (c.b >= 0) apart.contacts.push_back(c);
  resistTurning(apart, 0.2, random);
  ASSERT_GT(apart.rows.size(), 5u);
  const auto momentum = [&](const std::vector<Body>& bodies) {
    Vec3 sum = Vec3::Zero();
    for (const Body& b : bodies) sum += b.velocity.head<3>().cwiseQuotient(b.inverseMass);
    return sum;
  };
  std::vector<Body> after = apart.bodies;
  for (const Island& island : splitIslands(apart.bodies, apart.contacts, apart.rows)) {
    const Solution s = solve(assemble(apart.bodies, apart.contacts, apart.rows, island));
    applyReaction(after, apart.contacts, apart.rows, island, s.r);
    // Moments of disks are pure couples: equal and opposite ones balance
    // spin I ω + Σ arm × impulse.
    Vec3 couples = Vec3::Zero();
    const int begin = island.unknowns() - static_cast<int>(island.rows.size());
    for (std::size_t k = 0; k < island.rows.size(); ++k) {
      const Row& row = apart.rows[island.rows[k]];
      couples += (row.jacobianA + row.jacobianB).tail<3>().transpose() * s.r[begin + int(k)];
    }
    EXPECT_LT(couples.norm(), 1e-12);
  }
  EXPECT_LT((momentum(after) - momentum(apart.bodies)).norm(), 1e-12);
}

TEST(TurningFriction, TheRightRegionIsConfirmedAtOnce) {
  Random random(5);
  int confirmed = 0;
  constexpr int samples = 20;
  for (int k = 0; k < samples; ++k) {
    Pile pile = makeHeap(1 + k % 5, 0.4, random);
    resistTurning(pile, 0.1, random);
    const PileIsland island(std::move(pile));
    Solution s = solve(island.problem);
    ASSERT_EQ(s.status, Status::Solved) << k;
    NaturalMap map;
    map.setProblem(island.problem);
    ProximalSpace<BodyMotion> space;
    space.setProblem(island.problem, map);
    s.regions = 0;
    const double tolerance = 1e-8 * island.problem.q.cwiseAbs().maxCoeff();
    s.residual = infinity;
    confirmed +=
        ProximalWalk<BodyMotion>(space).walkFromRegion(tolerance, 1e-6, 8, s) == Outcome::Reached;
  }
  EXPECT_GE(confirmed, samples - 2);
}

TEST(TurningFriction, AgreesWithManySweeps) {
  Random random(3);
  for (int k = 0; k < 12; ++k) {
    Pile pile = makeHeap(3 + k % 4, 0.4, random);
    resistTurning(pile, 0.1, random);
    const PileIsland island(std::move(pile));
    NaturalMap map;
    map.setProblem(island.problem);
    Sweeps sweeps;
    sweeps.setProblem(island.problem, map);
    VectorXd slow = VectorXd::Zero(island.problem.size());
    // One sweep at a time: plain Gauss-Seidel, without its acceleration.
    for (int i = 0; i < 4000; ++i) sweeps.sweep(1, slow);
    ASSERT_LT(naturalResidual(island.problem, slow).max, 1e-7) << k;
    const Solution s = solve(island.problem);
    EXPECT_LT(motionDistance(island, s.r, slow), 1e-6) << k;
  }
}

}  // namespace
}  // namespace delassus
