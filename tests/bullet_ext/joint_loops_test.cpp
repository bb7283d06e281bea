/// Mechanisms in which joints close loops, and so hold some motions twice.
#include "bullet_ext/joint_loops.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "bullet_ext/gather.h"
#include "bullet_ext/softness.h"
#include "tests/support/bullet_world.h"

namespace delassus::test {
namespace {

using bullet::JointLoops;

TEST(JointLoops, AreThoseOfTheirMechanismAlone) {
  constexpr int standing = JointLoops::standing;
  JointLoops loops;
  for (int round = 0; round < 2; ++round) {  // nothing of the first round shows in the second
    loops.reset(9);
    // A ring 0 1 2 with a tail 3, a chain 4 5 that hangs, a bridge 6 7 that is held at both ends.
    loops.add(0, 1);
    loops.add(1, 2);
    loops.add(2, 0);
    loops.add(2, 3);
    loops.add(standing, 4);
    loops.add(4, 5);
    loops.add(6, standing);
    loops.add(6, 7);
    loops.add(standing, 7);
    loops.close();
    EXPECT_TRUE(loops.hasLoops());
    for (const int body : {0, 1, 2, 3, 6, 7}) EXPECT_TRUE(loops.isLooped(body)) << body;
    for (const int body : {4, 5, 8}) EXPECT_FALSE(loops.isLooped(body)) << body;
  }
  loops.reset(2);
  loops.add(0, 1);
  loops.close();
  EXPECT_FALSE(loops.hasLoops());
  // Two hinges of a door.
  loops.reset(1);
  loops.add(0, standing);
  loops.add(0, standing);
  loops.close();
  EXPECT_TRUE(loops.isLooped(0));
}

/// A joint of one row, a motor that may not push.
class Idle : public btTypedConstraint {
 public:
  explicit Idle(btRigidBody& body) : btTypedConstraint(MAX_CONSTRAINT_TYPE, body) {}
  void getInfo1(btConstraintInfo1* info) override { info->m_numConstraintRows = info->nub = 1; }
  void getInfo2(btConstraintInfo2* info) override {
    info->m_J1linearAxis[0] = 1;
    info->m_lowerLimit[0] = info->m_upperLimit[0] = 0;
  }
  void setParam(int, btScalar, int) override {}
  btScalar getParam(int, int) const override { return 0; }
};

// W of one body that is held at its centre is 1/m.
TEST(JointLoops, GiveByTheirOwnSoftnessFromTwoJointsOn) {
  constexpr double mass = 4;
  for (const int holds : {1, 2})
    for (const int idle : {0, 1}) {
      DelassusWorld world;
      btRigidBody& body = world.addCube({0, 0, 0}, mass);
      std::vector<btTypedConstraint*> joints;
      for (int i = 0; i < idle; ++i) joints.push_back(&world.addJoint<Idle>(body));
      for (int i = 0; i < holds; ++i)
        joints.push_back(&world.addJoint<btPoint2PointConstraint>(body, btVector3(0, 0, 0)));
      bullet::Group group;
      StepReport report;
      const bullet::GroupInput input{nullptr,       0,      nullptr, 0, joints.data(), holds + idle,
                                     &world.info(), nullptr};
      bullet::gatherJoints(group, input, report);
      ASSERT_EQ(group.rows.size(), std::size_t(3 * holds)) << "what may not push has no row";
      const double softness = holds == 1 ? bullet::leastSoftness : bullet::loopSoftness;
      for (const Row& row : group.rows)
        EXPECT_NEAR(row.compliance, softness / mass, 10 * precision * softness);
    }
}

/// A closed chain of hinged plates that stands on the ground or falls freely.
struct Track {
  DelassusWorld world;
  std::vector<btRigidBody*> plates;

  Track(int count, bool hasGround) {
    if (hasGround) world.addGround();
    const double radius = count * 0.4 / SIMD_2_PI;
    const auto joint = [&](int i) {
      const double angle = SIMD_2_PI * i / count;
      return btVector3(btScalar(radius * std::cos(angle)),
                       btScalar(radius * (1 + std::sin(angle)) + 0.1), 0);
    };
    for (int i = 0; i < count; ++i) {
      const btVector3 way = joint(i + 1) - joint(i);
      const btQuaternion turn({0, 0, 1}, btScalar(std::atan2(way.y(), way.x())));
      plates.push_back(&world.addBody(std::make_unique<btBoxShape>(btVector3(0.16, 0.04, 0.3)),
                                      btTransform(turn, (joint(i) + joint(i + 1)) / 2), 1));
    }
    for (int i = 0; i < count; ++i) {
      btRigidBody &a = *plates[i], &b = *plates[(i + 1) % count];
      const btTransform toA = a.getWorldTransform().inverse(),
                        toB = b.getWorldTransform().inverse();
      const btVector3 axis(0, 0, 1), place = joint(i + 1);
      auto& hinge = world.addJoint<btHingeConstraint>(a, b, toA * place, toB * place, axis, axis);
      world->removeConstraint(&hinge);
      world->addConstraint(&hinge, true);  // neighbours do not collide
    }
    plates[0]->setLinearVelocity({btScalar(0.1), 0, btScalar(0.01)});
  }
};

// As the track bends, what its hinges hold twice contradicts itself by ever so little. If it had to
// be met exactly, any reaction would do, and no step could be solved.
TEST(JointLoops, TracksFallFreely) {
  Track track(12, false);
  int unsolved = 0;
  for (int step = 0; step < 240; ++step) {
    track.world.advance();
    unsolved += track.world.report().islands - track.world.report().solved;
  }
  EXPECT_LE(unsolved, tolerance(0, 20));
  const double fallen = track.world.gravity * 4;
  for (const btRigidBody* plate : track.plates)
    EXPECT_NEAR(plate->getLinearVelocity().y(), -fallen, 0.2);
}

TEST(JointLoops, TracksLandAndComeToRest) {
  Track track(20, true);
  double fastest = 0;
  int unsolved = 0;
  for (int step = 0; step < 300; ++step) {
    track.world.advance();
    unsolved += track.world.report().islands - track.world.report().solved;
    for (const btRigidBody* plate : track.plates)
      fastest = std::max(fastest, double(plate->getLinearVelocity().length()));
  }
  EXPECT_LT(fastest, 30);
  EXPECT_LE(unsolved, 3);
  for (const btRigidBody* plate : track.plates) EXPECT_LT(plate->getLinearVelocity().length(), 0.3);
}

}  // namespace
}  // namespace delassus::test
