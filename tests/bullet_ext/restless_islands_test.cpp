/// Reactions that stopped something are kept once they are those of the rest.
#include <gtest/gtest.h>

#include "bullet_ext/group.h"
#include "bullet_ext/solve_group.h"
#include "bullet_ext/step_report.h"
#include "bullet_ext/workshop.h"
#include "tests/support/bullet_world.h"

namespace delassus::test {
namespace {

using namespace delassus::bullet;

/// A body of 1 kg that falls with 1 m/s on three points, and what is made of a guess that misses
/// the law by so much, m/s.
struct Falling {
  Group group;
  Answer answer;

  Falling(double error, bool wasRestless, const Options& options = {}) {
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
    if (wasRestless) group.marks.assign(3, {true, false});
    Options forWorlds = options;
    forWorlds.guessShare = polishedShare;
    Workshop workshop(forWorlds);
    StepReport report;
    answer.islands.find(group, options.economies);
    startAnswer(group, answer);
    checkIslands(group, workshop, answer);
    solveIslands(group, btContactSolverInfo(), workshop, answer, report);
  }
  bool isKept() const { return answer.results[0].tier == Tier::Kept; }
  bool isRestless() const { return answer.results[0].marks.isRestless; }
};

// As good as kept reactions have to be, and as those that have just been found.
constexpr double tolerance8 = 1e-8, good = 0.3 * keptShare * tolerance8,
                 best = 0.3 * polishedShare * tolerance8, bad = 1e-4;

TEST(RestlessIslands, AreKeptOnlyAtRest) {
  for (const bool wasRestless : {false, true}) {
    EXPECT_EQ(Falling(good, wasRestless).isKept(), !wasRestless);
    EXPECT_TRUE(Falling(best, wasRestless).isKept());
    EXPECT_FALSE(Falling(bad, wasRestless).isKept());
  }
}

TEST(RestlessIslands, AreThoseWhoseReactionsWereOthers) {
  EXPECT_TRUE(Falling(bad, false).isRestless());
  EXPECT_FALSE(Falling(good, true).isRestless()) << "digits alone change no motion";
  EXPECT_FALSE(Falling(best, true).isRestless());
  Options none;
  none.newtonBudget = none.sweepBudget = 0;
  EXPECT_FALSE(Falling(bad, false, none).isRestless()) << "no others were found";
}

}  // namespace
}  // namespace delassus::test
