/// What a step leaves to the next about an island: reactions that stopped something are kept once
/// they are the reactions of rest, and searches in vain grow rarer.
#include <gtest/gtest.h>

#include "bullet_ext/group.h"
#include "bullet_ext/solve_group.h"
#include "bullet_ext/step_report.h"
#include "bullet_ext/workshop.h"
#include "tests/support/bullet_world.h"

namespace delassus::test {
namespace {

using namespace delassus::bullet;

/// A body of 1 kg that falls with 1 m/s on three points, and the answer to a guess that misses the
/// law by `error`, m/s.
struct Falling {
  Group group;
  Answer answer;

  /// `load`, kg: of a body that falls on top of it; 0: there is none.
  Falling(double error, const IslandMarks& before, const Options& options = {}, double load = 0) {
    Body& body = group.bodies.emplace_back();
    body.inverseMass.setOnes();
    body.inverseInertia.setIdentity();
    body.velocity[0] = -1;
    group.bodySources.push_back({nullptr, body.velocity});
    for (const Vec3& arm : {Vec3(-1, 1, 0), Vec3(-1, -0.5, 0.8), Vec3(-1, -0.5, -0.8)}) {
      Contact& contact = group.contacts.emplace_back();
      contact.a = 0;
      contact.armA = arm;
      contact.friction = 0.5;
      group.contactSources.push_back({nullptr, 0});
      group.guess.push_back({(1 + error) / 3, 0, 0});
      group.pushes.push_back(0);
    }
    if (load > 0) addLoad(load);
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
    group.bodySources.push_back({nullptr, body.velocity});
    for (int i = 0; i < 3; ++i) {
      Contact contact = group.contacts[i];
      contact.a = 1;
      contact.b = 0;
      contact.armB = contact.armA + Vec3(2, 0, 0);
      group.contacts.push_back(contact);
      group.contactSources.push_back({nullptr, 0});
      group.guess.push_back(Vec3::Zero());
      group.pushes.push_back(0);
    }
  }
  bool isKept() const { return answer.results[0].tier == Tier::Kept; }
  const IslandMarks& marks() const { return answer.results[0].marks; }
  bool isRestless() const { return marks().isRestless; }
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

// A whole search comes after one, two, four, eight steps in vain, and where a short search leaves
// much more than the last whole one did.
TEST(LostIslands, AreSearchedWhollyEverLessOften) {
  Options none;
  none.newtonBudget = none.sweepBudget = 0;
  const double left = Falling(bad, {}, none).marks().lost;
  EXPECT_NEAR(left, bad, 0.5 * bad);
  for (int steps = 1; steps <= 16; ++steps)
    for (const double before : {left, left / 100}) {
      IslandMarks marks;
      marks.lostSteps = steps - 1;
      marks.lost = steps > 1 ? before : 0;
      const IslandMarks after = Falling(bad, marks, none).marks();
      const bool isWhole = before < left || (steps & (steps - 1)) == 0;
      EXPECT_EQ(after.lostSteps, steps);
      EXPECT_EQ(after.lost, isWhole ? left : before) << steps;
    }
  // As soon as the island is solved, all that is forgotten.
  IslandMarks marks;
  marks.lostSteps = 5;
  marks.lost = left;
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

}  // namespace
}  // namespace delassus::test
