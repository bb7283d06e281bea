/// Articulated bodies that touch something: the paper's regions in joint coordinates, weight,
/// friction.

#include <BulletDynamics/Featherstone/btMultiBodyJointMotor.h>
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <set>

#include "delassus/release.h"
#include "tests/support/multibody_world.h"

namespace delassus::test {
namespace {

/// Sum of the normal impulses of all points, N·s.
double normalSum(MultiBodyWorld& world) {
  double sum = 0;
  for (const btManifoldPoint* point : world.points()) sum += point->m_appliedImpulse;
  return sum;
}

TEST(MultiBodyContacts, FreeBoxCarriesItsWeight) {
  DelassusMultiBodyWorld world;
  world.addGround();
  const btVector3 half(0.5, 0.5, 0.5);
  btMultiBody& box =
      world.addTree(0, 3, boxInertia(half, 3), false, btVector3(0, btScalar(0.5), 0));
  world.addCollider(box, -1, std::make_unique<btBoxShape>(half));
  world.finish(box);
  world.advance(30);

  const double weight = 3 * BulletWorld::gravity * BulletWorld::step;
  EXPECT_NEAR(normalSum(world) / weight, 1, tolerance(1e-9, 1e-4));
  EXPECT_LE(box.getBaseVel().length(), tolerance(1e-9, 1e-5));
  EXPECT_EQ(world.report().contacts, 4);
  EXPECT_EQ(world.report().islands, 1);
  EXPECT_EQ(world.report().solved, 1);
}

/// The turn, rad, after so many steps, of a falling plank with one end on a block. Its joint lets
/// it move in its plane.
double turnOfPlank(MultiBodyWorld& world, int steps) {
  const btVector3 half(1, btScalar(0.1), 0.5);
  world.addGround();
  world.addBox({btScalar(0.1), 0.25, 1}, {btScalar(0.8), 0.25, 0}, 0);
  btMultiBody& tree = world.addTree(1, 1, {1, 1, 1}, true, {0, 0, 0});
  tree.setupPlanar(0, 1, boxInertia(half, 1), -1, btQuaternion::getIdentity(), {0, 0, 1}, {0, 0, 0},
                   true);
  world.addCollider(tree, 0, std::make_unique<btBoxShape>(half));
  world.finish(tree);
  btScalar start[] = {0, btScalar(0.65), 0};
  tree.setJointPosMultiDof(0, start);
  MultiBodyWorld::place(tree);
  world.advance(steps);
  return tree.getJointPosMultiDof(0)[0];
}

// Bullet's Jacobian of the angular velocity leaves out the planar joint.
TEST(MultiBodyContacts, PlankOnAPlanarJointTipsAsInStock) {
  DelassusMultiBodyWorld ours;
  StockMultiBodyWorld stock(1000);
  const double turn = turnOfPlank(ours, 20);
  EXPECT_GT(std::abs(turn), 0.02);
  EXPECT_NEAR(turn, turnOfPlank(stock, 20), tolerance(1e-4, 1e-3));
}

/// A collider without an articulated body is ground, for example after its body was deleted.
TEST(MultiBodyContacts, ColliderWithoutABody) {
  DelassusMultiBodyWorld world;
  btBoxShape shape(btVector3(5, 1, 5));
  btMultiBodyLinkCollider orphan(nullptr, -1);
  orphan.setCollisionShape(&shape);
  orphan.setWorldTransform(btTransform(btQuaternion::getIdentity(), btVector3(0, -1, 0)));
  world.world().addCollisionObject(&orphan);
  world.addCube(btVector3(0, btScalar(0.5), 0), 2);
  world.advance(10);
  EXPECT_EQ(world.report().contacts, 4);
  EXPECT_NEAR(normalSum(world) / (2 * BulletWorld::gravity * BulletWorld::step), 1,
              tolerance(1e-9, 1e-4));
  world.world().removeCollisionObject(&orphan);
}

/// A fixed base is ground; a base that moves by itself carries along what lies on it.
TEST(MultiBodyContacts, BasesThatCannotBePushed) {
  for (const bool kinematic : {false, true}) {
    DelassusMultiBodyWorld world;
    btMultiBody& base = world.addTree(0, 1, btVector3(1, 1, 1), !kinematic, btVector3(0, -1, 0));
    world.addCollider(base, -1, std::make_unique<btBoxShape>(btVector3(5, 1, 5)), 1);
    world.finish(base);
    if (kinematic) base.setBaseDynamicType(btCollisionObject::CF_KINEMATIC_OBJECT);
    const btVector3 velocity(kinematic ? btScalar(0.3) : 0, 0, 0);
    const btRigidBody& box = world.addCube(btVector3(0, btScalar(0.5), 0), 2);
    // Only six steps, since Bullet's points stay a step behind the base that carries them and are
    // lost one by one; when only two are left under the box, rounding decides. The box has the
    // speed of its base after four steps.
    for (int step = 0; step < 6; ++step) {
      base.setBaseVel(velocity);
      world.advance();
    }
    EXPECT_LE((box.getLinearVelocity() - velocity).length(), tolerance(1e-5, 1e-4));
    EXPECT_NEAR(normalSum(world) / (2 * BulletWorld::gravity * BulletWorld::step), 1,
                tolerance(1e-5, 1e-3));
    EXPECT_EQ(base.getBaseVel(), velocity);
  }
}

// A fixed base couples nothing, as ground does not.
TEST(MultiBodyContacts, BoxesOnAFixedBaseAreIslandsOfTheirOwn) {
  DelassusMultiBodyWorld world;
  btMultiBody& base = world.addTree(0, 1, btVector3(1, 1, 1), true, btVector3(0, -1, 0));
  world.addCollider(base, -1, std::make_unique<btBoxShape>(btVector3(5, 1, 5)), 1);
  world.finish(base);
  for (const int x : {-2, 2}) world.addCube(btVector3(btScalar(x), btScalar(0.5), 0));
  world.advance();
  EXPECT_EQ(world.report().islands, 2);
}

/// A lever about z at the end of `tree`, as its link `link`: mass 2 kg, centre at 0.5 m. Its ball
/// lies on a stop at 0.8 m.
struct Lever {
  static constexpr btScalar mass = 2, arm = btScalar(0.8), radius = btScalar(0.1);
  static constexpr double onStop = mass * BulletWorld::gravity * 0.5 / arm;  ///< force, N

  Lever(MultiBodyWorld& world, btMultiBody& tree, int link, const btVector3& pivot) {
    const btScalar I = btScalar(0.1);
    tree.setupRevolute(link, mass, btVector3(I, I, I), link - 1, btQuaternion::getIdentity(),
                       btVector3(0, 0, 1), btVector3(0, 0, 0), btVector3(btScalar(0.5), 0, 0),
                       true);
    auto shape = std::make_unique<btCompoundShape>();
    shape->addChildShape(BulletWorld::at({arm - btScalar(0.5), 0, 0}), &ball);
    world.addCollider(tree, link, std::move(shape), 0);
    world.addSphere(radius, pivot + btVector3(arm, -2 * radius + btScalar(1e-3), 0), 0);
    world.info().m_erp2 = 0;
  }
  btSphereShape ball{radius};
};

/// An earlier solve of the tree must not show: for links that move by themselves Bullet writes
/// nothing.
TEST(MultiBodyContacts, LinksThatCannotBePushed) {
  /// Checks that the solver does not change the velocity of one joint.
  struct Watch : btDelassusMultiBodyConstraintSolver {
    void solveMultiBodyGroup(btCollisionObject** bodies, int bodyCount,
                             btPersistentManifold** manifolds, int manifoldCount,
                             btTypedConstraint** constraints, int constraintCount,
                             btMultiBodyConstraint** multiBodyConstraints,
                             int multiBodyConstraintCount, const btContactSolverInfo& info,
                             btIDebugDraw* drawer, btDispatcher* dispatcher) override {
      const btScalar before = tree->getJointVel(0);
      btDelassusMultiBodyConstraintSolver::solveMultiBodyGroup(
          bodies, bodyCount, manifolds, manifoldCount, constraints, constraintCount,
          multiBodyConstraints, multiBodyConstraintCount, info, drawer, dispatcher);
      EXPECT_EQ(tree->getJointVel(0), before);
    }
    btMultiBody* tree = nullptr;
  };
  MultiBodyWorld world(std::make_unique<Watch>());
  const btVector3 zero(0, 0, 0), inertia(1, 1, 1), away(10, 0, 0);
  btMultiBody& dynamic = world.addTree(1, 0, zero, true);
  const Lever lever(world, dynamic, 0, zero);
  world.finish(dynamic);

  btMultiBody& moved = world.addTree(1, 1, inertia, false, away);
  moved.setupRevolute(0, 1, inertia, -1, btQuaternion::getIdentity(), btVector3(0, 0, 1), zero,
                      btVector3(btScalar(2), 0, 0), true);
  world.addCollider(moved, -1, std::make_unique<btEmptyShape>());
  world.addCollider(moved, 0, std::make_unique<btBoxShape>(btVector3(1, btScalar(0.1), 1)), 1);
  world.finish(moved);
  for (int link : {-1, 0}) moved.setLinkDynamicType(link, btCollisionObject::CF_KINEMATIC_OBJECT);
  const btRigidBody& box = world.addCube(away + btVector3(2, btScalar(0.599), 0), 3);

  dynamic_cast<Watch&>(world.solver()).tree = &moved;
  for (int step = 0; step < 30; ++step) {
    world.advance();
    EXPECT_NEAR(normalSum(world) / BulletWorld::step, Lever::onStop + 3 * BulletWorld::gravity,
                tolerance(1e-6, 1e-2))
        << step;
    EXPECT_LE(box.getLinearVelocity().length(), tolerance(1e-9, 1e-5)) << step;
  }
}

/// The lever feels its stop as on a fixed base, if the links that carry it move by themselves.
TEST(MultiBodyContacts, LinksAfterOneThatCannotBePushed) {
  DelassusMultiBodyWorld world;
  const btVector3 zero(0, 0, 0), inertia(1, 1, 1);
  btMultiBody& tree = world.addTree(2, 1, inertia, false);
  tree.setupRevolute(0, 1, inertia, -1, btQuaternion::getIdentity(), btVector3(0, 1, 0), zero, zero,
                     true);
  const Lever lever(world, tree, 1, zero);
  world.addCollider(tree, -1, std::make_unique<btEmptyShape>());
  world.finish(tree);
  for (int link : {-1, 0}) tree.setLinkDynamicType(link, btCollisionObject::CF_KINEMATIC_OBJECT);
  for (int step = 0; step < 30; ++step) {
    world.advance();
    EXPECT_NEAR(normalSum(world) / BulletWorld::step, Lever::onStop, tolerance(1e-6, 1e-3)) << step;
    EXPECT_NEAR(tree.getJointVel(1), 0, tolerance(1e-9, 1e-5)) << step;
  }
}

/// Bullet's finer integration finds places before the solver is asked: those do not count.
TEST(MultiBodyContacts, LinksOfRungeAndKuttaStayOnTheirStop) {
  DelassusMultiBodyWorld world;
  const btVector3 zero(0, 0, 0);
  btMultiBody& tree = world.addTree(1, 0, zero, true);
  const Lever lever(world, tree, 0, zero);
  tree.useRK4Integration(true);
  world.finish(tree);
  world.advance(60);
  EXPECT_NEAR(tree.getJointVel(0), 0, tolerance(1e-9, 1e-5));
  EXPECT_NEAR(tree.getJointPos(0), 0, tolerance(1e-9, 1e-5));
}

/// A planar arm of two links (theory §4), its joint axes along z, straight along x at rest. A ball
/// at the centre of mass of each link lies on a stop.
struct ArmOnStops {
  static constexpr btScalar m1 = 2, m2 = 1, I1 = btScalar(0.3), I2 = btScalar(0.1);
  static constexpr btScalar length1 = 1, centre1 = btScalar(0.6), centre2 = btScalar(0.5);
  static constexpr btScalar radius = btScalar(0.1);

  ArmOnStops() {
    world->setGravity(btVector3(0, 0, 0));
    const btVector3 axis(0, 0, 1);
    const btQuaternion straight = btQuaternion::getIdentity();
    btMultiBody& tree = world.addTree(2, 0, btVector3(0, 0, 0), true);
    tree.setupRevolute(0, m1, btVector3(I1, I1, I1), -1, straight, axis, btVector3(0, 0, 0),
                       btVector3(centre1, 0, 0), true);
    tree.setupRevolute(1, m2, btVector3(I2, I2, I2), 0, straight, axis,
                       btVector3(length1 - centre1, 0, 0), btVector3(centre2, 0, 0), true);
    for (int link : {0, 1}) {
      world.addCollider(tree, link, std::make_unique<btSphereShape>(radius), 0);
      const btScalar x = link == 0 ? centre1 : length1 + centre2;
      world.addSphere(radius, btVector3(x, -2 * radius, 0), 0);
    }
    world.finish(tree);
    arm = &tree;
  }

  /// J M⁻¹ with the two-link arm's mass matrix in closed form; J: rise of the two balls.
  static Eigen::Matrix2d jacobian() {
    Eigen::Matrix2d J;
    J << centre1, 0, length1 + centre2, centre2;
    return J;
  }
  static Eigen::Matrix2d inverseMass() {
    const double l = length1, c1 = centre1, c2 = centre2;
    Eigen::Matrix2d M;
    M(0, 0) = I1 + I2 + m1 * c1 * c1 + m2 * (l + c2) * (l + c2);
    M(0, 1) = M(1, 0) = I2 + m2 * (c2 * c2 + l * c2);
    M(1, 1) = I2 + m2 * c2 * c2;
    return M.inverse();
  }

  DelassusMultiBodyWorld world;
  btMultiBody* arm;
};

// A link that its rail holds cannot be pushed out of the ground, and slides on.
TEST(MultiBodyContacts, LinksBesideTheirRailAreNotHeldByWhatTheyOverlap) {
  for (const double depth : {1e-2, 1e-5, 0.0}) {
    DelassusMultiBodyWorld world;
    world.addGround();
    const btVector3 zero(0, 0, 0);
    btMultiBody& tree = world.addTree(1, 0, zero, true);
    tree.setupPrismatic(0, 1, btVector3(1, 1, 1), -1, btQuaternion::getIdentity(),
                        btVector3(1, 0, 0), zero, btVector3(0, btScalar(0.5 - depth), 0), true);
    world.addCollider(tree, 0, std::make_unique<btSphereShape>(btScalar(0.5)));
    world.finish(tree);
    tree.setJointVel(0, 1);
    world.advance(10);
    EXPECT_NEAR(tree.getJointVel(0), 1, tolerance(1e-12, 1e-6)) << depth;
    EXPECT_EQ(world.report().contacts, 0) << depth;
  }
}

// Nor can one that turns in place: a ball's point has its arm along its normal, up to rounding.
TEST(MultiBodyContacts, LinksThatTurnInPlaceSpinOnInWhatTheyOverlap) {
  DelassusMultiBodyWorld world;
  const btQuaternion tilt(btVector3(1, 2, 3).normalized(), btScalar(0.3));
  const btVector3 up = quatRotate(tilt, btVector3(0, 1, 0)), zero(0, 0, 0);
  world.addBody(std::make_unique<btBoxShape>(btVector3(5, 1, 5)), btTransform(tilt, -up), 0);
  btMultiBody& tree = world.addTree(1, 0, zero, true, up * btScalar(0.49));
  tree.setupSpherical(0, 1, btVector3(1, 1, 1), -1, btQuaternion::getIdentity(), zero, zero, true);
  world.addCollider(tree, 0, std::make_unique<btSphereShape>(btScalar(0.5)));
  world.finish(tree);
  btScalar spin[] = {1, 2, 3};
  tree.setJointVelMultiDof(0, spin);
  world.advance(10);
  EXPECT_EQ(world.report().contacts, 0);
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(tree.getJointVelMultiDof(0)[k], k + 1, 100 * precision);
}

TEST(MultiBodyContacts, ArmOnTwoStopsKeepsTheContactsOfItsRegion) {
  const Eigen::Matrix2d J = ArmOnStops::jacobian(), inverseMass = ArmOnStops::inverseMass();
  const Eigen::Matrix2d W = J * inverseMass * J.transpose();
  std::set<std::vector<bool>> regions;
  for (int k = 0; k < 24; ++k) {
    const double angle = 2 * M_PI * (k + 0.3) / 24;
    const Eigen::Vector2d torque = 10 * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    const Eigen::Vector2d q = J * inverseMass * torque * BulletWorld::step;
    const ReleaseAnalysis expected = analyseRelease(W, q);
    regions.insert(expected.persisting);

    ArmOnStops scene;
    scene.arm->addJointTorque(0, btScalar(torque[0]));
    scene.arm->addJointTorque(1, btScalar(torque[1]));
    scene.world.advance();
    const std::vector<btManifoldPoint*> points = scene.world.points();
    ASSERT_EQ(points.size(), 2u);
    for (const btManifoldPoint* point : points) {
      const int i = point->getPositionWorldOnA().x() < 1 ? 0 : 1;
      EXPECT_NEAR(point->m_appliedImpulse, expected.r[i], tolerance(1e-9, 1e-5)) << k;
      EXPECT_EQ(point->m_appliedImpulse > 0, expected.persisting[i]) << k;
    }
    const Eigen::Vector2d joints =
        inverseMass * (torque * BulletWorld::step + J.transpose() * expected.r);
    for (int i : {0, 1})
      EXPECT_NEAR(scene.arm->getJointVel(i), joints[i], tolerance(1e-9, 1e-5)) << k;
    EXPECT_LE(scene.world.report().residualMax, tolerance(1e-9, 1e-6));
  }
  EXPECT_EQ(regions.size(), 4u);
}

TEST(MultiBodyContacts, ThePlanCountsATreeWithAllThatItTouchesAsOneIsland) {
  ArmOnStops scene;
  scene.world.advance();
  const StepReport& report = scene.world.report();
  EXPECT_EQ(report.plan.islands, 1);
  EXPECT_EQ(report.plan.islands, report.islands);
  EXPECT_EQ(report.plan.largestIsland, 2);
  EXPECT_EQ(report.plan.unknowns, 2);
}

/// A body on four legs of two links each; feet of radius 5 cm, motors in the joints.
struct Quadruped {
  static constexpr btScalar bodyMass = 20, legMass = btScalar(0.7);
  static constexpr btScalar thigh = btScalar(0.3), shank = btScalar(0.3), foot = btScalar(0.05);

  static constexpr btScalar bend = btScalar(0.5);  ///< of the thigh; the shank bends back as much

  static btScalar height() { return foot + (thigh + shank) * btCos(bend); }

  explicit Quadruped(MultiBodyWorld& world) {
    world.addGround();
    const btVector3 half(btScalar(0.5), btScalar(0.1), btScalar(0.3));
    tree =
        &world.addTree(8, bodyMass, boxInertia(half, bodyMass), false, btVector3(0, height(), 0));
    world.addCollider(*tree, -1, std::make_unique<btBoxShape>(half));
    const btVector3 axis(0, 0, 1), inertia(btScalar(0.01), btScalar(0.01), btScalar(0.01));
    for (int leg = 0; leg < 4; ++leg) {
      const btVector3 hip((leg & 1 ? 1 : -1) * btScalar(0.4), 0, (leg & 2 ? 1 : -1) * half.z());
      const int upper = 2 * leg, lower = upper + 1;
      tree->setupRevolute(upper, legMass, inertia, -1, btQuaternion(axis, -bend), axis, hip,
                          btVector3(0, -thigh / 2, 0), true);
      tree->setupRevolute(lower, legMass, inertia, upper, btQuaternion(axis, 2 * bend), axis,
                          btVector3(0, -thigh / 2, 0), btVector3(0, -shank, 0), true);
      world.addCollider(*tree, lower, std::make_unique<btSphereShape>(foot), 1);
    }
    world.finish(*tree);
    for (int link = 0; link < 8; ++link) {
      auto& motor =
          world.addConstraint<btMultiBodyJointMotor>(tree, link, btScalar(0), btScalar(50));
      motor.setPositionTarget(0, btScalar(0.1));
    }
  }
  static constexpr double mass = bodyMass + 8 * legMass;
  btMultiBody* tree;
};

TEST(MultiBodyContacts, QuadrupedStandsOnFeetThatCarryItsWeight) {
  DelassusMultiBodyWorld world;
  const Quadruped robot(world);
  world.advance(120);
  const double weight = Quadruped::mass * BulletWorld::gravity * BulletWorld::step;
  const std::vector<btManifoldPoint*> feet = world.points();
  ASSERT_EQ(feet.size(), 4u);
  for (int step = 0; step < 30; ++step) {
    world.advance();
    EXPECT_NEAR(normalSum(world) / weight, 1, tolerance(1e-6, 1e-4));
    // Four stiff legs: in single precision rounding decides which of them carry how much.
    for (const btManifoldPoint* foot : world.points()) {
      EXPECT_GE(foot->m_appliedImpulse, 0);
      if (isDouble) {
        EXPECT_NEAR(foot->m_appliedImpulse / weight, 0.25, 0.05);
      }
    }
  }
  EXPECT_EQ(world.report().solved, world.report().islands);
  EXPECT_NEAR(robot.tree->getBasePos().y(), Quadruped::height(), 0.01);
  EXPECT_LE(robot.tree->getBaseVel().length(), tolerance(1e-6, 1e-4));
}

}  // namespace
}  // namespace delassus::test
