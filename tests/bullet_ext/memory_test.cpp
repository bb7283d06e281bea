/// The reactions from which points start that Bullet's narrow phase has put in the place of others.
#include "bullet_ext/memory.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <vector>

#include "BulletCollision/NarrowPhaseCollision/btPersistentManifold.h"
#include "bullet_ext/gather.h"
#include "bullet_ext/solve_group.h"
#include "delassus/turning_friction.h"
#include "tests/support/bullet_world.h"

namespace delassus::test {
namespace {

using namespace delassus::bullet;

/// One body on the ground that touches at points below it, as the solver gathers them.
class Touch {
 public:
  explicit Touch(const std::vector<Vec3>& arms) {
    group_.bodies.emplace_back().inverseMass.setOnes();
    for (const Vec3& arm : arms) {
      Contact& contact = group_.contacts.emplace_back();
      contact.a = 0;
      contact.armA = arm;
      contact.friction = 0.5;
      group_.contactSources.push_back({&manifold_, static_cast<int>(group_.contactSources.size())});
      group_.guess.push_back(Vec3::Zero());
    }
  }

  /// The same manifold with other points.
  void replace(const std::vector<Vec3>& arms, bool fresh) {
    for (std::size_t i = 0; i < arms.size(); ++i) {
      group_.contactSources[i].fresh = fresh;
      group_.contacts[i].armA = arms[i];
      group_.guess[i].setZero();
    }
  }
  Vec6 wrench(const std::vector<Vec3>& reactions) const {
    Vec6 sum = Vec6::Zero();
    for (std::size_t i = 0; i < reactions.size(); ++i) {
      const Vec3 force = group_.contacts[i].frame * reactions[i];
      sum.head<3>() += force;
      sum.tail<3>() += group_.contacts[i].armA.cross(force);
    }
    return sum;
  }
  Group& group() { return group_; }

 private:
  btPersistentManifold manifold_;
  Group group_;
};

const std::vector<Vec3> corners{{-1, 0.5, 0.5}, {-1, -0.5, 0.5}, {-1, -0.5, -0.5}, {-1, 0.5, -0.5}};
const std::vector<Vec3> reactions{{3, 0.5, 0.1}, {2, -0.2, 0.3}, {1, 0.1, 0}, {4, 0, -0.4}};

constexpr double h = 1.0 / 60;  ///< s

Answer answerOf(const std::vector<Vec3>& contacts) {
  Answer answer;
  answer.contacts = contacts;
  return answer;
}

TEST(Memory, FreshPointsPushAndTurnAsThoseThatAreGone) {
  Touch touch(corners);
  const Vec6 before = touch.wrench(reactions);
  Memory memory;
  memory.nextStep();
  memory.keep(touch.group(), answerOf(reactions), h);
  memory.nextStep();

  touch.replace({{-1, 0.4, 0.3}, {-1, -0.5, 0.5}, {-1, -0.3, -0.5}, {-1, 0.5, -0.2}}, true);
  memory.recall(touch.group());
  EXPECT_LT((touch.wrench(touch.group().guess) - before).norm(), 1e-6 * before.norm());
}

// Points keep their reactions in double precision, unless somebody has changed them.
TEST(Memory, PointsThatStayHaveAllTheirDigits) {
  Touch touch(corners);
  Memory memory;
  memory.nextStep();
  memory.keep(touch.group(), answerOf(reactions), h);
  memory.nextStep();

  // The order in which the narrow phase may have put the points.
  const auto& guess =
      touch.group().guess = {reactions[2], reactions[0], reactions[3], reactions[1]};
  for (Vec3& r : touch.group().guess)
    for (double& x : r) x = static_cast<btScalar>(x);
  touch.group().guess[1][0] = 7;
  const Vec3 changed = guess[1];
  memory.recall(touch.group());
  EXPECT_EQ(guess[0], reactions[2]);
  EXPECT_EQ(guess[1], changed);
  EXPECT_EQ(guess[2], reactions[3]);
  EXPECT_EQ(guess[3], reactions[1]);
}

// A reaction that float cannot tell from the others belongs to the point at its own place.
TEST(Memory, PointsAlikeKeepTheirOwnDigits) {
  constexpr double belowFloat = 1e-10;
  std::vector<Vec3> alike(4, Vec3(1, 0, 0));
  for (std::size_t i = 0; i < alike.size(); ++i) alike[i][0] += belowFloat * double(i);
  Touch touch(corners);
  Memory memory;
  memory.nextStep();
  memory.keep(touch.group(), answerOf(alike), h);
  memory.nextStep();
  for (std::size_t i = 0; i < alike.size(); ++i)
    touch.group().guess[i] = Vec3(static_cast<btScalar>(alike[i][0]), 0, 0);
  memory.recall(touch.group());
  EXPECT_EQ(touch.group().guess, alike);
}

// A smaller polygon on one side cannot pull, nor bear a moment about itself. The reactions from
// which it starts must be allowed all the same.
TEST(Memory, FreshPointsThatCannotCarryTheWrenchStartInsideTheirCones) {
  Touch touch(corners);
  Memory memory;
  memory.nextStep();
  memory.keep(touch.group(), answerOf({{0, 0, 0}, {0.1, 0, 0}, {6, 3, 0}, {6, -3, 0}}), h);
  memory.nextStep();
  touch.replace({{-1, 0.5, 0.5}, {-1, 0.4, 0.5}, {-1, 0.4, 0.4}, {-1, 0.5, 0.4}}, true);
  memory.recall(touch.group());
  double pushed = 0;
  for (const Vec3& r : touch.group().guess) {
    EXPECT_GE(r[0], 0);
    EXPECT_LE(r.tail<2>().norm(), 0.5 * r[0] * (1 + 1e-12));
    pushed += r[0];
  }
  EXPECT_GT(pushed, 0);
}

// The point of a rolling sphere does so. Tangents are as long as friction is strong along them, or
// zero.
TEST(Memory, ALonePointTakesOverTheForce) {
  for (const Vec3& lengths : {Vec3(1, 1, 1), Vec3(1, 0.2, 3), Vec3(1, 2, 0)}) {
    SCOPED_TRACE(lengths.transpose());
    Touch touch({{-1, 0, 0}});
    const Mat3 turned = Eigen::AngleAxisd(0.01, Vec3(1, 2, 3).normalized()).toRotationMatrix();
    touch.group().contacts[0].frame = turned * lengths.asDiagonal();
    const std::vector<Vec3> last{{3, 0.4, lengths[2] > 0 ? -0.2 : 0}};
    const Vec6 before = touch.wrench(last);
    Memory memory;
    memory.nextStep();
    memory.keep(touch.group(), answerOf(last), h);
    memory.nextStep();

    touch.replace({{-1, 0.3, 0.1}}, true);
    touch.group().contacts[0].frame = lengths.asDiagonal();
    memory.recall(touch.group());
    const Vec3& guess = touch.group().guess[0];
    const Vec3 force = touch.wrench({guess}).head<3>();
    EXPECT_LE(guess.tail<2>().norm(), 0.5 * guess[0] * (1 + 1e-12));
    EXPECT_NEAR(force[0], before[0], 1e-12) << "inside the cone the normal force is the same";
    for (int k = 1; k < 3; ++k) EXPECT_NEAR(force[k], lengths[k] > 0 ? before[k] : 0, 1e-12);
  }
}

// They do so even where a fresh point has come close to the place where they were.
TEST(Memory, PointsThatStayClaimTheirOwnPast) {
  Touch touch({corners[0], corners[2]});
  const std::vector<Vec3> last{{0, 0, 0}, {5, 1, 0}};
  Memory memory;
  memory.nextStep();
  memory.keep(touch.group(), answerOf(last), h);
  memory.nextStep();

  touch.replace({corners[2] + Vec3(0, 0.1, 0), corners[2]}, true);
  touch.group().contactSources[1].fresh = false;
  touch.group().guess[1] = last[1];
  memory.recall(touch.group());
  EXPECT_LT((touch.group().guess[0] - last[0]).norm(), 1e-12) << "what the one that is gone bore";
  EXPECT_LT((touch.group().guess[1] - last[1]).norm(), 1e-12);
}

// All points of a manifold may lie at the centre of their body.
TEST(Memory, PointsWithoutArmsPushOn) {
  Touch touch({Vec3::Zero(), Vec3::Zero()});
  Memory memory;
  memory.nextStep();
  memory.keep(touch.group(), answerOf({{3, 0.5, 0}, {2, 0, 0.5}}), h);
  memory.nextStep();
  touch.replace({Vec3::Zero(), Vec3::Zero()}, true);
  memory.recall(touch.group());
  EXPECT_LT((touch.wrench(touch.group().guess).head<3>() - Vec3(5, 0.5, 0.5)).norm(), 1e-9);
}

// The moments change places with the reactions.
TEST(Memory, WhatResistsTurningStartsAsTheNearestEnded) {
  Touch touch({corners[0], corners[2]});
  TurningFriction friction;
  friction.spinning = friction.rolling = 0.1;
  friction.axes.setIdentity();
  for (int i : {0, 1}) addRows(friction, touch.group().contacts[i], i, touch.group().rows);
  touch.group().turningRows = static_cast<int>(touch.group().rows.size());
  Answer answer = answerOf({{1, 0, 0}, {1, 0, 0}});
  answer.rows = {1, 2, 3, 4, 5, 6};
  Memory memory;
  memory.nextStep();
  memory.keep(touch.group(), answer, h);
  memory.nextStep();
  touch.replace({corners[2] + Vec3(0, 0.1, 0), corners[0]}, false);
  memory.recall(touch.group());
  EXPECT_EQ(touch.group().rowGuess, std::vector<double>({4, 5, 6, 1, 2, 3}));
}

// By these contacts an island is known again. A new body in the place of another one has none.
TEST(Memory, RestlessAreTheContactsThatABodyHadBefore) {
  DelassusWorld world;
  btRigidBody& body = world.addCube({0, 0, 0});
  Touch touch(corners);
  touch.group().bodySources = {{&body, Vec6::Zero()}};
  for (PointSource& source : touch.group().contactSources) source.bodyA = &body;
  Answer answer = answerOf(reactions);
  answer.results.resize(1);
  answer.results[0].marks.isRestless = true;
  answer.results[0].markedBody = 0;
  Memory memory;
  memory.nextStep();
  memory.keep(touch.group(), answer, h);
  memory.nextStep();
  touch.group().contactSources[1].fresh = true;
  memory.recall(touch.group());
  IslandMarks restless;
  restless.isRestless = true;
  EXPECT_EQ(touch.group().marks,
            std::vector<IslandMarks>({restless, IslandMarks(), restless, restless}));
}

TEST(Memory, PointsThatStayAreLeftAlone) {
  Touch touch(corners);
  Memory memory;
  memory.nextStep();
  memory.keep(touch.group(), answerOf(reactions), h);
  memory.nextStep();
  touch.replace({{-1, 0.4, 0.3}, {-1, -0.5, 0.5}, {-1, -0.3, -0.5}, {-1, 0.5, -0.2}}, false);
  memory.recall(touch.group());
  for (const Vec3& guess : touch.group().guess) EXPECT_EQ(guess, Vec3::Zero());
}

// Bullet counts the steps of a point, including the one that made it.
TEST(Memory, PointsOfThisStepAreFresh) {
  DelassusWorld world;
  world.addGround();
  world.addCube({0, btScalar(0.499), 0});
  world.advance();
  const std::vector<btManifoldPoint*> points = world.points();
  ASSERT_GE(points.size(), 3u);
  for (std::size_t i = 0; i < points.size(); ++i) points[i]->m_lifeTime = static_cast<int>(i);

  Group group;
  StepReport report;
  btPersistentManifold* manifold = world.dispatcher().getManifoldByIndexInternal(0);
  const GroupInput input{nullptr, 0, &manifold, 1, nullptr, 0, &world.info(), &world.dispatcher()};
  gatherContacts(group, input, report);
  ASSERT_EQ(group.contactSources.size(), points.size());
  for (const PointSource& source : group.contactSources)
    EXPECT_EQ(source.fresh, source.point <= 1) << source.point;
}

}  // namespace
}  // namespace delassus::test
