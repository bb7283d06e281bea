#pragma once
/// Worlds that nobody would build: any shapes, masses over twelve decades, joints of any kind,
/// flags, broken numbers.
///
/// At most one argument of a call is drawn, or the call has braces. Compilers evaluate arguments in
/// different orders, and the same bytes must make the same world.

#include <limits>
#include <memory>
#include <vector>

#include "tests/fuzz/byte_draws.h"
#include "tests/support/bullet_world.h"

namespace delassus::test {

/// Traits of a world, so that a law is asked only of worlds for which it holds.
struct WorldTraits {
  bool joints = false;      ///< their rows may feed energy in
  bool lockedAxes = false;  ///< momentum along them goes nowhere
  bool bounces = false;     ///< restitution feeds energy in
  bool broken = false;      ///< some number is NaN or absurd
};

class RandomWorld {
 public:
  explicit RandomWorld(ByteDraws& random) : random_(random) {
    setUpStep();
    if (chance(random, 0.8)) world_.addGround();
    traits_.bounces = chance(random, 0.2);
    traits_.lockedAxes = chance(random, 0.2);
    turning_ = chance(random, 0.3);
    const double decadesOfMass = chance(random, 0.5) ? 6 : 1;
    const int count = pick(random, 1, 12);
    for (int i = 0; i < count; ++i) addBody(decadesOfMass);
    if (chance(random, 0.5))
      for (int i = pick(random, 1, 6); i > 0; --i) addJoint();
  }

  BulletWorld& world() { return world_; }
  const WorldTraits& traits() const { return traits_; }
  btScalar timeStep() const { return timeStep_; }

  /// Makes some number NaN or absurd.
  void breakSomething() {
    traits_.broken = true;
    const btScalar bad[] = {std::numeric_limits<btScalar>::quiet_NaN(),
                            std::numeric_limits<btScalar>::infinity(), SIMD_INFINITY,
                            -SIMD_INFINITY, -1};
    const btScalar x = bad[pick(random_, 0, 4)];
    btRigidBody& body = *bodies_[pick(random_, 0, int(bodies_.size()) - 1)];
    switch (pick(random_, 0, 8)) {
      case 0:
        body.setLinearVelocity({x, 0, 0});
        break;
      case 1:
        body.setAngularVelocity({0, x, 0});
        break;
      case 2:
        body.applyCentralForce({0, 0, x});
        break;
      case 3:
        body.setMassProps(x, {1, 1, 1});
        break;
      case 4:
        body.setMassProps(1, {1, x, 1});
        body.updateInertiaTensor();
        break;
      case 5:
        body.setFriction(x);
        break;
      case 6:
        body.setRestitution(x);
        break;
      case 7:
        body.setRollingFriction(x);
        break;
      case 8:
        body.setSpinningFriction(x);
        break;
    }
  }

 private:
  btScalar some(double from, double to) { return btScalar(uniform(random_, from, to)); }
  btVector3 someVector(double size) {
    return {some(-size, size), some(-size, size), some(-size, size)};
  }
  btQuaternion someTurn() {
    const btVector3 axis = someVector(1) + btVector3(0, btScalar(1e-3), 0);
    return chance(random_, 0.4) ? btQuaternion::getIdentity()
                                : btQuaternion(axis.normalized(), some(-3, 3));
  }

  void setUpStep() {
    timeStep_ = chance(random_, 0.7) ? BulletWorld::step : btScalar(decades(random_, -3.5, -1.3));
    btContactSolverInfo& info = world_.info();
    info.m_splitImpulse = chance(random_, 0.5);
    info.m_erp2 = some(0, 1);
    if (chance(random_, 0.2)) info.m_globalCfm = btScalar(decades(random_, -9, -2));
    if (chance(random_, 0.2)) info.m_solverMode &= ~SOLVER_USE_WARMSTARTING;
    if (chance(random_, 0.2)) info.m_linearSlop = some(0, 0.01);
    if (chance(random_, 0.3)) info.m_minimumSolverBatchSize = pick(random_, 1, 3);
  }

  std::unique_ptr<btCollisionShape> someShape() {
    const btScalar a = btScalar(decades(random_, -1, 0.3)), b = btScalar(decades(random_, -1, 0.3));
    switch (pick(random_, 0, 6)) {
      case 0:
      case 1:
        return std::make_unique<btBoxShape>(btVector3(a, b, btScalar(decades(random_, -1, 0.3))));
      case 2:
        return std::make_unique<btSphereShape>(a);
      case 3:
        return std::make_unique<btCapsuleShape>(a, b);
      case 4:
        return std::make_unique<btCylinderShape>(btVector3(a, b, a));
      case 5:
        return std::make_unique<btConeShape>(a, b);
      default: {
        auto hull = std::make_unique<btConvexHullShape>();
        for (int i = 0; i < 8; ++i) hull->addPoint(someVector(double(a)));
        return hull;
      }
    }
  }

  /// Locks each axis or leaves it free.
  btVector3 someLocks() {
    const int locks = pick(random_, 0, 7);
    return {btScalar(locks & 1), btScalar(locks >> 1 & 1), btScalar(locks >> 2 & 1)};
  }

  void addBody(double decadesOfMass) {
    const btVector3 place{some(-1.5, 1.5), some(0, 3), some(-1.5, 1.5)};
    const btScalar mass =
        chance(random_, 0.1) ? 0 : btScalar(decades(random_, -decadesOfMass, decadesOfMass));
    std::unique_ptr<btCollisionShape> shape = someShape();
    btRigidBody& body = world_.addBody(std::move(shape), btTransform(someTurn(), place), mass);
    bodies_.push_back(&body);
    body.setLinearVelocity(someVector(chance(random_, 0.1) ? 100 : 3));
    body.setAngularVelocity(someVector(3));
    body.setFriction(chance(random_, 0.2) ? 0 : some(0, 2));
    if (traits_.bounces) body.setRestitution(some(0, 1));
    if (traits_.lockedAxes && chance(random_, 0.5)) {
      body.setLinearFactor(someLocks());
      body.setAngularFactor(someLocks());
    }
    if (chance(random_, 0.1))
      body.setCollisionFlags(body.getCollisionFlags() | btCollisionObject::CF_KINEMATIC_OBJECT);
    if (chance(random_, 0.1)) {
      const btScalar stiffness = btScalar(decades(random_, 1, 9));
      body.setContactStiffnessAndDamping(stiffness, some(0, 100));
    }
    if (chance(random_, 0.2)) body.setFlags(pick(random_, 0, 15));
    if (chance(random_, 0.1)) {
      const btScalar linear = some(0, 1);
      body.setDamping(linear, some(0, 1));
    }
    if (chance(random_, 0.1)) body.forceActivationState(pick(random_, 1, 5));
    if (!turning_) return;
    if (chance(random_, 0.5)) body.setRollingFriction(btScalar(decades(random_, -4, 1)));
    if (chance(random_, 0.5)) body.setSpinningFriction(btScalar(decades(random_, -4, 1)));
    if (chance(random_, 0.3))
      body.setAnisotropicFriction({some(0, 1), some(0, 1), some(0, 1)},
                                  btCollisionObject::CF_ANISOTROPIC_ROLLING_FRICTION);
  }

  void addJoint() {
    traits_.joints = true;
    btRigidBody& a = *bodies_[pick(random_, 0, int(bodies_.size()) - 1)];
    btRigidBody& b = *bodies_[pick(random_, 0, int(bodies_.size()) - 1)];
    const btTransform inA{someTurn(), someVector(1)}, inB{someTurn(), someVector(1)};
    if (&a == &b) {
      world_.addJoint<btPoint2PointConstraint>(a, inA.getOrigin());
      return;
    }
    switch (pick(random_, 0, 6)) {
      case 0:
        world_.addJoint<btPoint2PointConstraint>(a, b, inA.getOrigin(), inB.getOrigin());
        break;
      case 1: {
        auto& hinge = world_.addJoint<btHingeConstraint>(a, b, inA, inB);
        if (chance(random_, 0.5)) {
          const btScalar low = some(-1, 0);
          hinge.setLimit(low, some(0, 1));
        }
        if (chance(random_, 0.5)) {
          const btScalar speed = some(-5, 5);
          hinge.enableAngularMotor(true, speed, some(0, 10));
        }
        break;
      }
      case 2:
        world_.addJoint<btSliderConstraint>(a, b, inA, inB, true);
        break;
      case 3: {
        const btScalar swing1 = some(0, 1), swing2 = some(0, 1);
        world_.addJoint<btConeTwistConstraint>(a, b, inA, inB).setLimit(swing1, swing2, some(0, 1));
        break;
      }
      case 4: {
        auto& spring = world_.addJoint<btGeneric6DofSpring2Constraint>(a, b, inA, inB);
        const int axis = pick(random_, 0, 5);
        spring.enableSpring(axis, true);
        spring.setStiffness(axis, btScalar(decades(random_, 0, 9)));
        spring.setDamping(axis, some(0, 10));
        break;
      }
      case 5:
        world_.addJoint<btFixedConstraint>(a, b, inA, inB);
        break;
      case 6:
        world_.addJoint<btGearConstraint>(a, b, btVector3(0, 1, 0), btVector3(1, 0, 0),
                                          some(0.1, 3));
        break;
    }
  }

  ByteDraws& random_;
  DelassusWorld world_;
  WorldTraits traits_;
  bool turning_ = false;  ///< bodies resist rolling and spinning
  btScalar timeStep_ = BulletWorld::step;
  std::vector<btRigidBody*> bodies_;
};

}  // namespace delassus::test
