/// What a step leaves to the next about an island: reactions that stopped something are kept once
/// they are the reactions of rest, and searches in vain grow rarer.

#include <BulletDynamics/ConstraintSolver/btPoint2PointConstraint.h>
#include <gtest/gtest.h>

#include "bullet_ext/group.h"
#include "bullet_ext/solve_group.h"
#include "bullet_ext/step_report.h"
#include "bullet_ext/workshop.h"
#include "tests/support/bullet_world.h"
#include "tests/support/rowless_constraint.h"

namespace delassus::test {
namespace {

using namespace delassus::bullet;

/// A body of 1 kg that falls with 1 m/s on three points, and the answer to a guess that misses the
/// law by `error`, m/s.
struct Falling {
  Group group;
  Answer answer;

  /// `load`, kg: of a body that falls on top of it; 0: there is none.
  Falling(double error, const IslandMarks& before, const Options& options = {}, double load = 0)
      : Falling(error) {
    if (load > 0) addLoad(load);
    solve(before, options);
  }

 protected:
  explicit Falling(double error = 0) {
    Body& body = group.bodies.emplace_back();
    body.inverseMass.setOnes();
    body.inverseInertia.setIdentity();
    body.velocity[0] = -1;
    group.bodySources.push_back({&rigid_, body.velocity});
    for (const Vec3& arm : {Vec3(-1, 1, 0), Vec3(-1, -0.5, 0.8), Vec3(-1, -0.5, -0.8)}) {
      Contact& contact = group.contacts.emplace_back();
      contact.a = 0;
      contact.armA = arm;
      contact.friction = 0.5;
      group.contactSources.push_back({&manifold_, 0});
      group.guess.push_back({(1 + error) / 3, 0, 0});
      group.pushes.push_back(0);
    }
  }
  void solve(const IslandMarks& before, const Options& options = {}) {
    if (before.any()) group.marks.assign(group.contacts.size(), before);
    Options forWorlds = options;
    forWorlds.guessShare = polishedShare;
    Workshop workshop(forWorlds);
    StepReport report;
    answer.islands.find(group, options.economies);
    startAnswer(group, answer);
    checkIslands(group, workshop, answer);
    solveIslands(group, btContactSolverInfo(), workshop, answer, report);
  }
  void addLoad(double mass) {
    Body& body = group.bodies.emplace_back(group.bodies.front());
    body.inverseMass /= mass;
    body.inverseInertia /= mass;
    rigidLoad_.setMassProps(btScalar(mass), {1, 1, 1});
    group.bodySources.push_back({&rigidLoad_, body.velocity});
    for (int i = 0; i < 3; ++i) {
      Contact contact = group.contacts[i];
      contact.a = 1;
      contact.b = 0;
      contact.armB = contact.armA + Vec3(2, 0, 0);
      group.contacts.push_back(contact);
      group.contactSources.push_back({&manifold_, 0});
      group.guess.push_back(Vec3::Zero());
      group.pushes.push_back(0);
    }
  }

 public:
  bool isKept() const { return answer.results[0].tier == Tier::Kept; }
  const IslandMarks& marks() const { return answer.results[0].marks; }
  bool isRestless() const { return marks().isRestless; }

 protected:
  btRigidBody rigid_{1, nullptr, nullptr, {1, 1, 1}}, rigidLoad_{1, nullptr, nullptr, {1, 1, 1}};
  btPersistentManifold manifold_{&rigid_, &rigidLoad_, 0, btScalar(0.02), btScalar(0.02)};
};

IslandMarks marksOf(bool isRestless) {
  IslandMarks marks;
  marks.isRestless = isRestless;
  return marks;
}

// `good` is what kept reactions must reach, `best` what those that have just been found must reach.
constexpr double tolerance8 = 1e-8, good = 0.3 * keptShare * tolerance8,
                 best = 0.3 * polishedShare * tolerance8, bad = 1e-4;

TEST(RestlessIslands, AreKeptOnlyAtRest) {
  for (const bool wasRestless : {false, true}) {
    EXPECT_EQ(Falling(good, marksOf(wasRestless)).isKept(), !wasRestless);
    EXPECT_TRUE(Falling(best, marksOf(wasRestless)).isKept());
    EXPECT_FALSE(Falling(bad, marksOf(wasRestless)).isKept());
  }
}

TEST(RestlessIslands, AreThoseWhoseReactionsWereOthers) {
  EXPECT_TRUE(Falling(bad, {}).isRestless());
  EXPECT_FALSE(Falling(good, marksOf(true)).isRestless()) << "digits alone change no motion";
  EXPECT_FALSE(Falling(best, marksOf(true)).isRestless());
  Options none;
  none.newtonBudget = none.sweepBudget = 0;
  EXPECT_FALSE(Falling(bad, {}, none).isRestless()) << "no others were found";
}

/// The same above a floor, of which a part that the body touches sinks away.
struct AboveASinkingFloor : Falling {
  explicit AboveASinkingFloor(double error) : Falling(error) {
    group.bodies.emplace_back().velocity[0] = -5;
    group.bodySources.push_back({&rigidLoad_, group.bodies.back().velocity});
    Contact& contact = group.contacts.emplace_back(group.contacts.front());
    contact.b = 1;
    group.contactSources.push_back({&manifold_, 0});
    group.guess.push_back(Vec3::Zero());
    group.pushes.push_back(0);
    solve({});
  }
};

// Where a jam is ruled out first, the guess is that of the first search, not its answer.
TEST(RestlessIslands, AreThoseWhoseFirstReactionsWereOthers) {
  for (const double error : {bad, 3 * bad, 100 * bad}) {
    const AboveASinkingFloor falling(error);
    EXPECT_TRUE(falling.isRestless()) << error;
    EXPECT_EQ(falling.answer.results[0].status, Status::Solved) << error;
  }
  EXPECT_FALSE(AboveASinkingFloor(good).isRestless());
}

/// A constraint without rows that lets its body rise at 1 m/s.
class Lift : public RowlessConstraint {
 public:
  using RowlessConstraint::RowlessConstraint;
  void solveConstraintObsolete(btSolverBody& body, btSolverBody&, btScalar) override {
    body.m_deltaLinearVelocity += btVector3(1, 0, 0) - velocityOf(body);
  }
};

struct Lifted : Falling {
  explicit Lifted(const Options& options) {
    for (Vec3& guess : group.guess) guess.setZero();
    rigid_.setLinearVelocity({-1, 0, 0});
    group.indexOf.insert(&rigid_, 0);
    group.obsolete.push_back(&lift_);
    solve({}, options);
  }

 private:
  Lift lift_{rigid_};
};

// What a constraint without rows has lifted off needs no answer any more, nor a longer search.
TEST(LostIslands, AreForgottenIfTheSameStepSolvesThemAgain) {
  Options none;
  none.newtonBudget = none.sweepBudget = 0;
  const Lifted lifted(none);
  EXPECT_EQ(lifted.answer.results[0].status, Status::Solved);
  EXPECT_NEAR(lifted.answer.bodies[0].velocity[0], 1, 10 * tolerance(1e-9, 1e-6));
  EXPECT_FALSE(lifted.marks().any());
}

// A whole search comes after one, two, four, eight steps in vain, and where a short search leaves
// much more than the last whole one did.
TEST(LostIslands, AreSearchedWhollyEverLessOften) {
  Options none;
  none.newtonBudget = none.sweepBudget = 0;
  const double left = Falling(bad, {}, none).marks().lostResidual;
  EXPECT_NEAR(left, bad, 0.5 * bad);
  for (int steps = 1; steps <= 16; ++steps)
    for (const double before : {left, left / 100}) {
      IslandMarks marks;
      marks.lostSteps = steps - 1;
      marks.lostResidual = steps > 1 ? before : 0;
      const IslandMarks after = Falling(bad, marks, none).marks();
      const bool isWhole = before < left || (steps & (steps - 1)) == 0;
      EXPECT_EQ(after.lostSteps, steps);
      EXPECT_EQ(after.lostResidual, isWhole ? left : before) << steps;
    }
  // As soon as the island is solved, all that is forgotten.
  IslandMarks marks;
  marks.lostSteps = 5;
  marks.lostResidual = left;
  EXPECT_EQ(Falling(bad, marks).marks().lostSteps, 0);
}

// Contacts that give a little sink under a heavy load and take up much, but no more than it brings.
TEST(JammedIslands, AreSolvedExactlyWhereNothingSqueezes) {
  IslandMarks marks;
  marks.isJammed = true;
  for (const double load : {0.0, 1.0, 1e3, 1e6}) {
    const Falling falling(bad, marks, {}, load);
    EXPECT_FALSE(falling.answer.results[0].isSoftened) << load;
    EXPECT_EQ(falling.answer.results[0].status, Status::Solved) << load;
    EXPECT_FALSE(falling.marks().isJammed) << load;
  }
}

/// A body of 1 kg that falls with 1 m/s between a floor that overlaps it and a limit of a joint
/// that it has passed above: each asks it to part at 0.1 m/s. What it loads is the floor.
struct Squeezed : Falling {
  Squeezed(const IslandMarks& before, bool isLimb) {
    for (Contact& contact : group.contacts) contact.target[0] = 0.1;
    Row& limit = group.rows.emplace_back();
    limit.a = 0;
    limit.jacobianA[0] = -1;
    limit.target = 0.1;
    limit.lower = 0;
    group.rowGuess.push_back(0);
    group.joints.push_back({&joint_, 0, 1, 0, 0});
    if (isLimb) {
      const MatrixXd unit = MatrixXd::Identity(6, 6);
      group.articulation.trees.push_back({unit});
      group.articulation.limbs.push_back({0, 0, unit});
    }
    solve(before);
  }
  double onFloor() const {
    return answer.contacts[0][0] + answer.contacts[1][0] + answer.contacts[2][0];
  }
  double onLimit() const { return answer.rows[0]; }

 private:
  btPoint2PointConstraint joint_{rigid_, {0, 0, 0}};
};

IslandMarks quarrelled(int steps) {
  IslandMarks marks;
  marks.quarrelSteps = steps;
  return marks;
}

TEST(QuarrellingIslands, PressWithTheirLoads) {
  for (const int steps : {0, 2, 3}) {
    const Squeezed squeezed(quarrelled(steps), false);
    EXPECT_EQ(squeezed.answer.results[0].status, Status::Incompatible) << steps;
    EXPECT_FALSE(squeezed.answer.results[0].isSoftened) << steps;
    EXPECT_NEAR(squeezed.onFloor(), 1, 0.1) << "its fall is stopped, and some recovery made";
    EXPECT_NEAR(squeezed.onLimit(), 0, 1e-3) << steps;
    EXPECT_NEAR(squeezed.answer.results[0].residualMax, 0.2, 0.02) << "what they still ask for";
    // Every step that is no power of two begins with the recovery.
    EXPECT_EQ(squeezed.marks().quarrelSteps, steps == 2 ? 3 : 0) << steps;
  }
}

TEST(QuarrellingIslands, AreSolvedExactlyOnceNothingQuarrels) {
  const Falling falling(bad, quarrelled(2));
  EXPECT_EQ(falling.answer.results[0].status, Status::Solved);
  EXPECT_EQ(falling.marks().quarrelSteps, 0);
}

// A recovery knows single bodies: a tree is answered by what moves all of it.
TEST(QuarrellingIslands, OfArticulatedBodiesMoveTheTree) {
  const Squeezed squeezed(quarrelled(2), true);
  ASSERT_EQ(squeezed.answer.gains.of.size(), 1u);
  EXPECT_NEAR(squeezed.answer.gains.of[0][0], 1, 0.1) << "its fall is stopped";
}

// If less recovery did not relieve the island, it is tried again after twice as many steps.
TEST(LoadedIslands, AreLookedAtEverLessOften) {
  for (int steps = 1; steps <= 16; ++steps) {
    IslandMarks marks;
    marks.loadedSteps = steps - 1;
    const Squeezed squeezed(marks, false);
    const bool isLookedAt = (steps & (steps - 1)) == 0;
    EXPECT_EQ(squeezed.onLimit() < 1e-3, isLookedAt) << steps;
    EXPECT_EQ(squeezed.marks().loadedSteps, isLookedAt ? 0 : steps);
  }
}

}  // namespace
}  // namespace delassus::test
