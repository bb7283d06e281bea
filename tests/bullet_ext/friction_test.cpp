/// Coulomb's law on one body: incline, isotropy, torque (Bullet's contract, friction).

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/bullet_world.h"

namespace delassus::test {
namespace {

constexpr double degree = SIMD_RADS_PER_DEG;

/// A slab on level ground. An incline is a tilted gravity: the same physics without tilted shapes.
btRigidBody& addSlab(BulletWorld& world) {
  world.addGround();
  return world.addBox({0.5, 0.1, 0.5}, {0, btScalar(0.1), 0});
}

/// A body with one contact point that cannot turn, at any speed.
btRigidBody& addUnturning(BulletWorld& world) {
  world.addGround();
  btRigidBody& runner = world.addSphere(0.5, {0, btScalar(0.5), 0});
  runner.setAngularFactor(0);
  return runner;
}

/// The tangential reaction on body 0 of the point's manifold.
btVector3 tangentialReaction(const btManifoldPoint& point) {
  return point.m_appliedImpulseLateral1 * point.m_lateralFrictionDir1 +
         point.m_appliedImpulseLateral2 * point.m_lateralFrictionDir2;
}

void tilt(BulletWorld& world, btRigidBody& body, double angle, double heading) {
  const btVector3 gravity(btScalar(g * std::sin(angle) * std::cos(heading)),
                          btScalar(-g * std::cos(angle)),
                          btScalar(g * std::sin(angle) * std::sin(heading)));
  world->setGravity(gravity);
  body.setGravity(gravity);
}

/// How deep boxes with a friction of 10 lie in each other at most, as they fall on a heap, m.
double deepestOverlapOfRoughBoxes(BulletWorld& world) {
  constexpr int boxes = 12;
  world.addGround();
  for (int i = 0; i < boxes; ++i) {
    const double turn = 2.4 * i;
    btRigidBody& box = world.addBox(
        {0.5, 0.5, 0.5},
        {btScalar(0.6 * std::cos(turn)), btScalar(2 + 1.3 * i), btScalar(0.6 * std::sin(turn))});
    const btQuaternion turned(btVector3(btScalar(std::sin(turn)), 1, btScalar(std::cos(2 * turn))),
                              btScalar(turn));
    box.setWorldTransform(btTransform(turned, box.getWorldTransform().getOrigin()));
    box.setFriction(10);
  }
  double deepest = 0;
  for (int step = 0; step < 240; ++step) {
    world.advance();
    for (const btManifoldPoint* point : world.points())
      deepest = std::max(deepest, -double(point->getDistance()));
  }
  return deepest;
}

// Much friction must not make an answer that lets bodies sink look as good as one that lets them
// slip.
TEST(FewSweeps, DoNotLetRoughBoxesSink) {
  constexpr double most = 0.5;  // m, half a box; stock's, and all sweeps, let them sink 0.2 m
  for (const int sweeps : {5, 10}) {
    DelassusWorld world(Options::bounded(sweeps));
    EXPECT_LT(deepestOverlapOfRoughBoxes(world), most) << sweeps;
  }
}

TEST(Parity, Row17SticksBelowTheFrictionAngle) {
  for (double heading : {0.0, 0.5, 1.2}) {
    DelassusWorld world;
    btRigidBody& slab = addSlab(world);
    tilt(world, slab, std::atan(friction) - degree, heading);
    world.advance(1);  // the first step settles the rounding of the initial pose
    const btVector3 start = slab.getWorldTransform().getOrigin();
    world.advance(600);
    EXPECT_LT((slab.getWorldTransform().getOrigin() - start).length(), tolerance(1e-6, 1e-4))
        << heading;
  }
}

TEST(Parity, Row17SlidesAboveTheFrictionAngle) {
  for (double heading : {0.0, 0.5, 1.2}) {
    SCOPED_TRACE(heading);
    DelassusWorld world;
    btRigidBody& runner = addUnturning(world);
    const double angle = std::atan(friction) + degree;
    tilt(world, runner, angle, heading);
    constexpr int steps = 120;
    world.advance(steps);
    const double expected =
        g * (std::sin(angle) - friction * std::cos(angle)) * steps * BulletWorld::step;
    const btVector3 v = runner.getLinearVelocity();
    // In float the narrow phase's normals lean by 1e-5, against sin − μ cos = 0.02.
    EXPECT_NEAR(std::hypot(v.x(), v.z()), expected, tolerance(1e-9, 1e-3) * expected);
    EXPECT_NEAR(std::atan2(v.z(), v.x()), heading, tolerance(1e-9, 1e-3)) << "the fall line";
  }
}

TEST(Parity, Row17EachPointOfASlidingSlabIsOnTheConeAgainstItsSlip) {
  // Bullet's narrow phase drops points of a slab that slides obliquely. So the slab tips and hops a
  // little, and its speed has no closed form. The law holds at each point all the same:
  //     r_t = −μ r_n u_t/|u_t|,   and the reactions are what changes the momentum.
  DelassusWorld world;
  btRigidBody& slab = addSlab(world);
  tilt(world, slab, std::atan(friction) + degree, 1.2);
  for (int step = 0; step < 120; ++step) {
    const btVector3 centre = slab.getWorldTransform().getOrigin();
    const btVector3 before = slab.getLinearVelocity();
    world.advance();
    btVector3 momentum = BulletWorld::step * slab.getGravity();
    const bool slabFirst = world.dispatcher().getManifoldByIndexInternal(0)->getBody0() == &slab;
    for (const btManifoldPoint* point : world.points()) {
      const btVector3 arm =
          (slabFirst ? point->getPositionWorldOnA() : point->getPositionWorldOnB()) - centre;
      const btVector3 n = (slabFirst ? 1 : -1) * point->m_normalWorldOnB;
      const btVector3 onSlab = (slabFirst ? 1 : -1) * tangentialReaction(*point);
      btVector3 slip = slab.getLinearVelocity() + slab.getAngularVelocity().cross(arm);
      slip -= slip.dot(n) * n;
      const btVector3 law = -friction * point->m_appliedImpulse * slip.normalized();
      ASSERT_NEAR((onSlab - law).length(), 0, tolerance(1e-9, 1e-3) * g * BulletWorld::step);
      momentum += point->m_appliedImpulse * n + onSlab;
    }
    ASSERT_NEAR((slab.getLinearVelocity() - before - momentum).length(), 0, tolerance(1e-13, 1e-6));
  }
}

/// Slides `body` at `speed` in many directions of the ground. It must lose μ g per second on a
/// straight path.
template <class Add>
void expectRoundCone(const Add& add, double speed, int steps) {
  for (int angle = 0; angle <= 90; angle += 15) {
    SCOPED_TRACE(angle);
    DelassusWorld world;
    btRigidBody& body = add(world);
    const double heading = angle * degree;
    body.setLinearVelocity(
        {btScalar(speed * std::cos(heading)), 0, btScalar(speed * std::sin(heading))});
    world.advance(steps);
    const btVector3 v = body.getLinearVelocity();
    const double left = speed - friction * g * steps * BulletWorld::step;
    EXPECT_NEAR(std::hypot(v.x(), v.z()), left, tolerance(1e-6, 1e-4));
    EXPECT_NEAR(std::atan2(v.z(), v.x()), heading, tolerance(1e-6, 1e-4)) << "a straight path";
  }
}

TEST(Parity, Row18SlidingFrictionIsTheSameInAllDirections) {
  expectRoundCone(addUnturning, 4, 30);
  // Four points share the load. One step only, since Bullet's narrow phase drops points of a box
  // that slides on.
  expectRoundCone(addSlab, 1, 1);
}

TEST(Parity, Row19TorqueBelowFrictionTurnsNothing) {
  DelassusWorld world;
  world.addGround();
  btRigidBody& box = world.addCube({0, btScalar(0.5), 0});
  // Four corners can hold up to μ m g √½ = 3.5 N m.
  for (int i = 0; i < 300; ++i) {
    box.applyTorque({0, 2, 0});
    world.advance();
    ASSERT_NEAR(box.getAngularVelocity().y(), 0, tolerance(1e-9, 1e-5));
  }
  for (int i = 0; i < 60; ++i) {
    box.applyTorque({0, 5, 0});
    world.advance();
  }
  EXPECT_GT(box.getAngularVelocity().y(), 1) << "above the limit it turns";
}

TEST(Friction, NegativeCoefficientIsNone) {
  DelassusWorld world;
  btRigidBody& slab = addSlab(world);
  slab.setFriction(-1);
  slab.setLinearVelocity({1, 0, 0});
  world.advance(30);
  EXPECT_NEAR(slab.getLinearVelocity().x(), 1, tolerance(1e-12, 1e-5));
  EXPECT_EQ(world.report().stick, 0);
}

}  // namespace
}  // namespace delassus::test
