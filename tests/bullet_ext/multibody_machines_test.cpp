/// Machines: an arm that pushes a pile, a gripper that holds far more than its own mass.

#include <BulletDynamics/Featherstone/btMultiBodyJointMotor.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "bullet_ext/convert.h"
#include "tests/support/multibody_world.h"
#include "tests/support/rowless_constraint.h"

namespace delassus::test {
namespace {

/// Seven revolute joints, their axes along y and z in turn, lie along x half a metre above the
/// ground, with a paddle at the end. The first joint swings the arm around.
btMultiBody& addSevenJointArm(MultiBodyWorld& world) {
  const btScalar length = btScalar(0.3);
  btMultiBody& arm = world.addTree(7, 0, btVector3(0, 0, 0), true, btVector3(0, btScalar(0.5), 0));
  for (int link = 0; link < 7; ++link) {
    const btVector3 pivot(link == 0 ? 0 : length / 2, 0, 0);
    arm.setupRevolute(link, 1, btVector3(btScalar(0.01), btScalar(0.02), btScalar(0.02)), link - 1,
                      btQuaternion::getIdentity(),
                      link % 2 ? btVector3(0, 0, 1) : btVector3(0, 1, 0), pivot,
                      btVector3(length / 2, 0, 0), true);
  }
  world.addCollider(
      arm, 6, std::make_unique<btBoxShape>(btVector3(length / 2, btScalar(0.3), btScalar(0.05))));
  world.finish(arm);
  for (int link = 0; link < 7; ++link)
    world.addConstraint<btMultiBodyJointMotor>(&arm, link, btScalar(link == 0 ? -1 : 0),
                                               btScalar(20));
  return arm;
}

/// Two layers of boxes in the way of the arm.
std::vector<btRigidBody*> addPile(MultiBodyWorld& world) {
  std::vector<btRigidBody*> boxes;
  const btScalar half = btScalar(0.15);
  for (int layer = 0; layer < 2; ++layer)
    for (int i = 0; i < 3; ++i)
      boxes.push_back(
          &world.addBox(btVector3(half, half, half),
                        {btScalar(1.7) + i * btScalar(0.31), half * (1 + 2 * layer), btScalar(0.6)},
                        btScalar(0.5)));
  return boxes;
}

/// Linear momentum.
Vec3 momentumOf(const std::vector<btRigidBody*>& bodies) {
  Vec3 sum = Vec3::Zero();
  for (const btRigidBody* body : bodies)
    sum += bullet::toCore(body->getLinearVelocity()) / body->getInvMass();
  return sum;
}

/// The impulse of all points on rigid bodies that can move. Points between two such cancel.
Vec3 impulseOnRigidBodies(MultiBodyWorld& world) {
  Vec3 sum = Vec3::Zero();
  for (int i = 0; i < world.dispatcher().getNumManifolds(); ++i) {
    const btPersistentManifold& manifold = *world.dispatcher().getManifoldByIndexInternal(i);
    const auto moves = [](const btCollisionObject* object) {
      const btRigidBody* body = btRigidBody::upcast(object);
      return body && body->getInvMass() > 0;
    };
    const int sign = int(moves(manifold.getBody0())) - int(moves(manifold.getBody1()));
    for (int k = 0; k < manifold.getNumContacts(); ++k) {
      const btManifoldPoint& point = manifold.getContactPoint(k);
      sum += sign * (bullet::toCore(point.m_normalWorldOnB) * point.m_appliedImpulse +
                     bullet::toCore(point.m_lateralFrictionDir1) * point.m_appliedImpulseLateral1 +
                     bullet::toCore(point.m_lateralFrictionDir2) * point.m_appliedImpulseLateral2);
    }
  }
  return sum;
}

TEST(MultiBodyMachines, SevenJointArmPushesAPileByTheLaw) {
  DelassusMultiBodyWorld world;
  world.addGround();
  const btMultiBody& arm = addSevenJointArm(world);
  const std::vector<btRigidBody*> boxes = addPile(world);
  const double mass = 0.5 * boxes.size(), h = BulletWorld::step;
  bool pushed = false;
  for (int step = 0; step < 90; ++step) {
    const Vec3 before = momentumOf(boxes);
    world.advance();
    const Vec3 gain = momentumOf(boxes) - before - Vec3(0, -mass * BulletWorld::gravity * h, 0);
    EXPECT_LE((gain - impulseOnRigidBodies(world)).norm(), tolerance(1e-12, 1e-5)) << step;
    EXPECT_LE(world.report().residualMax, tolerance(1e-7, 1e-6)) << step;
    pushed |= boxes[0]->getLinearVelocity().length() > 0.1;
  }
  EXPECT_TRUE(pushed);
  EXPECT_LT(arm.getJointVel(0), -0.1);
}

/// Two fingers of 0.1 kg on rails along x hold a box of 5 kg between them, 120 N each.
struct Gripper {
  static constexpr btScalar boxMass = 5, fingerMass = btScalar(0.1), grip = 120;

  explicit Gripper(MultiBodyWorld& world) {
    const btScalar half = btScalar(0.1), thickness = btScalar(0.02);
    btMultiBody& hand = world.addTree(3, 0, btVector3(0, 0, 0), true, btVector3(0, 1, 0));
    const btVector3 inertia(btScalar(1e-4), btScalar(1e-4), btScalar(1e-4)), zero(0, 0, 0);
    const btQuaternion straight = btQuaternion::getIdentity();
    hand.setupPrismatic(0, fingerMass, inertia, -1, straight, btVector3(0, 1, 0), zero, zero, true);
    for (int finger = 0; finger < 2; ++finger) {
      const btScalar side = finger == 0 ? -1 : 1;
      hand.setupPrismatic(1 + finger, fingerMass, inertia, 0, straight, btVector3(-side, 0, 0),
                          btVector3(side * (half + thickness), 0, 0), zero, true);
      world.addCollider(hand, 1 + finger,
                        std::make_unique<btBoxShape>(btVector3(thickness, half, half)), 1);
    }
    world.finish(hand);
    lift = &world.addConstraint<btMultiBodyJointMotor>(&hand, 0, btScalar(0), btScalar(100));
    for (int finger : {1, 2})
      world.addConstraint<btMultiBodyJointMotor>(&hand, finger, btScalar(0.05),
                                                 grip * BulletWorld::step);
    box = &world.addBox(btVector3(half, half, half), btVector3(0, 1, 0), boxMass);
    tree = &hand;
  }
  /// Height of the box over the hand.
  double slip() const {
    return box->getWorldTransform().getOrigin().y() - tree->getJointPos(0) - 1;
  }

  btMultiBody* tree;
  btMultiBodyJointMotor* lift;
  btRigidBody* box;
};

/// Lifts at up to 0.2 m/s, then holds. Returns the largest creep after the grip has closed.
double creepOfGripper(int steps) {
  DelassusMultiBodyWorld world;
  const Gripper gripper(world);
  world.advance(30);
  const double start = gripper.slip();
  double creep = 0, lifted = 0;
  for (int step = 0; step < steps; ++step) {
    const double velocity = std::min(0.01 * std::min(step, 50 - step), 0.2);
    gripper.lift->setVelocityTarget(btScalar(std::max(velocity, 0.0)));
    lifted += std::max(velocity, 0.0) * BulletWorld::step;
    world.advance();
    creep = std::max(creep, std::abs(gripper.slip() - start));
  }
  EXPECT_NEAR(gripper.tree->getJointPos(0), lifted, tolerance(1e-6, 1e-4));
  return creep;
}

TEST(MultiBodyMachines, GripperDoesNotCreep) { EXPECT_LE(creepOfGripper(60), 1e-5); }
TEST(MultiBodyMachines, GripperDoesNotCreepInTenSecondsSlow) {
  EXPECT_LE(creepOfGripper(600), 1e-5);
}

/// Everything that moves in a world, bit for bit.
std::vector<btScalar> motionOfMachines() {
  DelassusMultiBodyWorld world;
  world.addGround();
  const btMultiBody& arm = addSevenJointArm(world);
  const std::vector<btRigidBody*> boxes = addPile(world);
  world.advance(60);
  std::vector<btScalar> motion(arm.getVelocityVector(), arm.getVelocityVector() + 13);
  for (const btRigidBody* box : boxes)
    for (const btVector3& v : {box->getWorldTransform().getOrigin(), box->getLinearVelocity()})
      motion.insert(motion.end(), {v.x(), v.y(), v.z()});
  return motion;
}

TEST(MultiBodyMachines, SameBitsEveryTime) {
  const std::vector<btScalar> once = motionOfMachines(), again = motionOfMachines();
  ASSERT_EQ(once.size(), again.size());
  EXPECT_EQ(std::memcmp(once.data(), again.data(), once.size() * sizeof(btScalar)), 0);
}

// The tree is solved again and again while the constraint goes on, and gains only what the last
// answer gives it.
TEST(MultiBodyMachines, AConstraintWithoutRowsCarriesATree) {
  DelassusMultiBodyWorld world;
  world.info().m_numIterations = 1000;  // sweeps of the user's own method
  btRigidBody& table = world.addCube({0, 10, 0}, 1);
  world.addJoint<FallBrake>(table, btScalar(1));
  table.setAngularFactor(0);
  const btScalar radius = btScalar(0.5);
  btMultiBody& ball = world.addTree(0, 1, btVector3(1, 1, 1), false, {0, 10 + 2 * radius, 0});
  world.addCollider(ball, -1, std::make_unique<btSphereShape>(radius));
  world.finish(ball);
  world.advance(60);
  EXPECT_NEAR(table.getLinearVelocity().y(), -1, tolerance(1e-6, 1e-3));
  EXPECT_NEAR(ball.getBaseVel().y(), -1, tolerance(1e-6, 1e-3));
}

// Three links of 10 g and a load of 100 kg, hung up.
TEST(MultiBodyMachines, RopesOfRigidBodiesAreStiffenedToo) {
  DelassusMultiBodyWorld world;
  const btVector3 half(btScalar(0.05), btScalar(0.25), btScalar(0.05)), end(0, half.y(), 0);
  btRigidBody* above = nullptr;
  for (int i = 0; i < 4; ++i) {
    const bool link = i < 3;
    btRigidBody& body = world.addBox(half, -i * 2 * end, btScalar(link ? 0.01 : 100));
    body.setCollisionFlags(btCollisionObject::CF_NO_CONTACT_RESPONSE);
    if (above)
      world.addJoint<btPoint2PointConstraint>(*above, body, -end, end);
    else
      world.addJoint<btPoint2PointConstraint>(body, end);
    above = &body;
  }
  world.advance(2);
  EXPECT_EQ(world.report().stiffened, 3);
  dynamic_cast<btDelassusMultiBodyConstraintSolver&>(world.solver()).setGeometricStiffness(false);
  world.advance();
  EXPECT_EQ(world.report().stiffened, 0);
}

}  // namespace
}  // namespace delassus::test
