/// Articulated and rigid bodies, thrown together at random: they may fly apart, but stay finite.

#include <BulletDynamics/Featherstone/btMultiBodyJointLimitConstraint.h>
#include <BulletDynamics/Featherstone/btMultiBodyJointMotor.h>
#include <BulletDynamics/Featherstone/btMultiBodyPoint2Point.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "tests/support/multibody_world.h"
#include "tests/support/random_problems.h"

namespace delassus::test {
namespace {

/// A few boxes and balls, and a few trees of up to three links, that may lie deep in each other.
class Heap {
 public:
  explicit Heap(int seed)
      : random_(seed),
        world_(std::make_unique<btDelassusMultiBodyConstraintSolver>(
            chance(0.5) ? Options::bounded(static_cast<int>(draw(1, 20))) : Options())) {
    world_.addGround();
    world_.info().m_splitImpulse = chance(0.8);
    const auto bodies = static_cast<int>(draw(1, 6)), trees = static_cast<int>(draw(1, 4));
    for (int k = 0; k < bodies; ++k) addBody();
    for (int k = 0; k < trees; ++k) addTree();
  }

  /// The speed of the fastest body after a step, m/s; not finite once one is nowhere.
  double fastest() {
    world_.advance();
    double most = 0;
    const auto look = [&](const btVector3& place, const btVector3& velocity) {
      most = std::max<double>(most, std::isfinite(place.length2()) ? velocity.length() : INFINITY);
    };
    for (const btRigidBody* body : bodies_)
      look(body->getWorldTransform().getOrigin(), body->getLinearVelocity());
    for (const btMultiBody* tree : trees_) look(tree->getBasePos(), tree->getBaseVel());
    return most;
  }

 private:
  double draw(double from, double to) { return uniform(random_, from, to); }
  bool chance(double share) { return draw(0, 1) < share; }
  btVector3 place() {
    const double x = draw(-0.6, 0.6), y = draw(0.3, 2.5), z = draw(-0.6, 0.6);
    return {btScalar(x), btScalar(y), btScalar(z)};
  }

  void addBody() {
    const auto mass = btScalar(std::pow(10, draw(-1, 2)));
    const btVector3 half(0.5, 0.5, 0.5);
    bodies_.push_back(chance(0.6) ? &world_.addBox(half, place(), mass)
                                  : &world_.addSphere(btScalar(0.3), place(), mass));
    bodies_.back()->setFriction(btScalar(draw(0, 1.2)));
    if (chance(0.3)) bodies_.back()->setRestitution(btScalar(draw(0, 1)));
  }

  void addTree() {
    const btVector3 half(0.5, 0.5, 0.5);
    const btVector3 halfLink(btScalar(0.1), btScalar(0.3), btScalar(0.1));
    const auto links = static_cast<int>(draw(0, 4));
    const bool isFixed = chance(0.4);
    btMultiBody& tree = world_.addTree(links, isFixed && chance(0.5) ? 0 : 1, boxInertia(half, 1),
                                       isFixed, place());
    tree.setHasSelfCollision(true);
    for (int link = 0; link < links; ++link) addLink(tree, link, halfLink);
    world_.addCollider(tree, -1, std::make_unique<btBoxShape>(half));
    for (int link = 0; link < links; ++link)
      world_.addCollider(tree, link, std::make_unique<btBoxShape>(halfLink));
    world_.finish(tree);
    trees_.push_back(&tree);
    for (int link = 0; link < links; ++link)
      if (tree.getLink(link).m_dofCount == 1 && chance(0.4)) drive(tree, link);
    if (links > 0 && chance(0.4))
      world_.addConstraint<btMultiBodyPoint2Point>(&tree, links - 1, bodies_.front(),
                                                   btVector3(0, btScalar(0.3), 0),
                                                   btVector3(0, btScalar(0.2), 0));
  }

  void addLink(btMultiBody& tree, int link, const btVector3& half) {
    const auto mass = btScalar(0.3);
    const btVector3 inertia = boxInertia(half, mass), toCentre(0, btScalar(0.3), 0);
    const btVector3 toJoint(0, btScalar(link == 0 ? 0.5 : 0.3), 0);
    const btQuaternion straight = btQuaternion::getIdentity();
    switch (static_cast<int>(draw(0, 4))) {
      case 0:
        return tree.setupFixed(link, mass, inertia, link - 1, straight, toJoint, toCentre);
      case 1:
        return tree.setupSpherical(link, mass, inertia, link - 1, straight, toJoint, toCentre,
                                   true);
      case 2:
        return tree.setupPrismatic(link, mass, inertia, link - 1, straight, {0, 1, 0}, toJoint,
                                   toCentre, true);
      default:
        return tree.setupRevolute(link, mass, inertia, link - 1, straight, {0, 0, 1}, toJoint,
                                  toCentre, true);
    }
  }

  void drive(btMultiBody& tree, int link) {
    if (chance(0.5))
      world_.addConstraint<btMultiBodyJointMotor>(&tree, link, btScalar(draw(-5, 5)),
                                                  btScalar(draw(0, 10)));
    else
      world_.addConstraint<btMultiBodyJointLimitConstraint>(&tree, link, btScalar(-0.3),
                                                            btScalar(0.3));
  }

  Random random_;
  MultiBodyWorld world_;
  std::vector<btRigidBody*> bodies_;
  std::vector<btMultiBody*> trees_;
};

// Some come to a thousand metres a second, as with stock's solver after a thousand sweeps: Bullet's
// time stepping lets trees that spin gain energy.
TEST(MultiBodyContacts, HeapsThatOverlapStayFinite) {
  for (int seed = 0; seed < 60; ++seed) {
    Heap heap(seed);
    for (int step = 0; step < 40; ++step)
      ASSERT_TRUE(std::isfinite(heap.fastest())) << seed << ", " << step;
  }
}

}  // namespace
}  // namespace delassus::test
