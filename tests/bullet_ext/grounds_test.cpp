/// Grounds of all kinds: the narrow phase may make many points of them, or points with a normal
/// each.

#include <gtest/gtest.h>

#include <BulletCollision/CollisionShapes/btHeightfieldTerrainShape.h>
#include <BulletCollision/Gimpact/btGImpactCollisionAlgorithm.h>
#include <BulletCollision/Gimpact/btGImpactShape.h>

#include <cmath>
#include <memory>
#include <vector>

#include "tests/support/bullet_world.h"

namespace delassus::test {
namespace {

/// The sum of the reactions on `body` of all points; it is in all of them.
btVector3 reactionOn(const btRigidBody& body, BulletWorld& world) {
  btVector3 sum(0, 0, 0);
  for (int i = 0; i < world.dispatcher().getNumManifolds(); ++i) {
    const btPersistentManifold& manifold = *world.dispatcher().getManifoldByIndexInternal(i);
    const btScalar sign = manifold.getBody0() == &body ? btScalar(1) : btScalar(-1);
    for (int j = 0; j < manifold.getNumContacts(); ++j) {
      const btManifoldPoint& point = manifold.getContactPoint(j);
      sum += sign * (point.m_appliedImpulse * point.m_normalWorldOnB +
                     point.m_appliedImpulseLateral1 * point.m_lateralFrictionDir1 +
                     point.m_appliedImpulseLateral2 * point.m_lateralFrictionDir2);
    }
  }
  return sum;
}

/// A body left alone stays within `allowed` of where it was put. In each step the reactions of all
/// points make the change of its momentum; where it rests, to a tenth of the tolerance.
///
/// `allowed` is due to the narrow phase. On triangles it picks four points now here, now there, at
/// times all on one side of the centre, and the body tips a little until the next step.
void expectRests(BulletWorld& world, btRigidBody& body, double allowed) {
  const btVector3 place = body.getWorldTransform().getOrigin();
  for (int i = 0; i < 120; ++i) {
    const btVector3 before = body.getLinearVelocity();
    world.advance();
    ASSERT_LT(world.report().residualMax, 1e-5);
    const btVector3 gain =
        body.getLinearVelocity() - before - BulletWorld::step * body.getGravity();
    const btVector3 momentum = gain / body.getInvMass();
    const double missed = (reactionOn(body, world) - momentum).length();
    const bool rests = body.getLinearVelocity().isZero();
    ASSERT_LT(missed, tolerance(rests ? 5e-10 : 1e-13, 1e-6)) << i;
  }
  EXPECT_LT((body.getWorldTransform().getOrigin() - place).length(), allowed);
}

btRigidBody& addBox(BulletWorld& world) {
  return world.addBox({0.5, 0.5, 0.5}, {btScalar(0.1), btScalar(0.5), btScalar(0.2)}, 2);
}

TEST(Grounds, CompoundOfTiles) {
  DelassusWorld world;
  auto tiles = std::make_unique<btCompoundShape>();
  btBoxShape tile(btVector3(0.25, 0.5, 0.25));
  for (int x = -4; x <= 4; ++x)
    for (int z = -4; z <= 4; ++z)
      tiles->addChildShape(BulletWorld::at({btScalar(0.5) * x, btScalar(-0.5), btScalar(0.5) * z}),
                           &tile);
  world.addBody(std::move(tiles), btTransform::getIdentity(), 0);
  expectRests(world, addBox(world), tolerance(1e-6, 1e-3));
}

TEST(Grounds, CompoundBodyOfManyPoints) {
  // Two crossed beams make eight points and more under one body.
  DelassusWorld world;
  world.addGround();
  auto cross = std::make_unique<btCompoundShape>();
  btBoxShape beam(btVector3(1, btScalar(0.1), btScalar(0.2)));
  cross->addChildShape(btTransform::getIdentity(), &beam);
  cross->addChildShape(btTransform(btQuaternion(btVector3(0, 1, 0), SIMD_HALF_PI)), &beam);
  btRigidBody& body = world.addBody(std::move(cross), BulletWorld::at({0, btScalar(0.1), 0}), 2);
  expectRests(world, body, tolerance(1e-6, 1e-4));
  EXPECT_GE(world.points().size(), 8u);
}

/// A flat square of triangles at y = 0.
std::unique_ptr<btTriangleMesh> triangles() {
  auto mesh = std::make_unique<btTriangleMesh>();
  for (int x = -4; x < 4; ++x)
    for (int z = -4; z < 4; ++z) {
      const btVector3 a(x, 0, z), b(x + 1, 0, z), c(x + 1, 0, z + 1), d(x, 0, z + 1);
      mesh->addTriangle(a, d, b);
      mesh->addTriangle(b, d, c);
    }
  return mesh;
}

TEST(Grounds, TriangleMesh) {
  const auto mesh = triangles();
  DelassusWorld world;
  auto shape = std::make_unique<btBvhTriangleMeshShape>(mesh.get(), true);
  world.addBody(std::move(shape), btTransform::getIdentity(), 0);
  expectRests(world, addBox(world), 1e-2);
}

TEST(Grounds, Heightfield) {
  constexpr int size = 9;
  std::vector<float> heights(size * size, 0.0f);
  DelassusWorld world;
  auto shape = std::make_unique<btHeightfieldTerrainShape>(size, size, heights.data(), btScalar(-1),
                                                           btScalar(1), 1, false);
  world.addBody(std::move(shape), btTransform::getIdentity(), 0);
  expectRests(world, addBox(world), 1e-2);
}

TEST(Grounds, GImpactMesh) {
  const auto mesh = triangles();
  DelassusWorld world;
  btGImpactCollisionAlgorithm::registerAlgorithm(&world.dispatcher());
  auto shape = std::make_unique<btGImpactMeshShape>(mesh.get());
  shape->updateBound();
  world.addBody(std::move(shape), btTransform::getIdentity(), 0);
  expectRests(world, addBox(world), 1e-2);
}

// In the first step a plane has one point per body, unless it is asked for all that touch. A body
// that stands on one point alone tips.
TEST(Grounds, APyramidStandsOnAPlaneThatIsTouchedWithAllCorners) {
  constexpr int rows = 6;
  DelassusWorld world;
  static_cast<btDefaultCollisionConfiguration*>(world.dispatcher().getCollisionConfiguration())
      ->setPlaneConvexMultipointIterations();
  world.addBody(std::make_unique<btStaticPlaneShape>(btVector3(0, 1, 0), btScalar(0)),
                btTransform::getIdentity(), 0);
  std::vector<btRigidBody*> cubes;
  std::vector<btVector3> places;
  for (int row = 0; row < rows; ++row)
    for (int i = 0; i < rows - row; ++i) {
      places.emplace_back(btScalar(1.05) * (i + btScalar(0.5) * row), btScalar(0.5) + row, 0);
      cubes.push_back(&world.addCube(places.back()));
    }
  for (int i = 0; i < 60; ++i) {
    world.advance();
    ASSERT_EQ(world.report().solved, 1) << i;
  }
  EXPECT_EQ(world.report().keptIslands, 1);
  for (std::size_t i = 0; i < cubes.size(); ++i)
    EXPECT_LT((cubes[i]->getWorldTransform().getOrigin() - places[i]).length(),
              tolerance(1e-9, 1e-4));
}

TEST(Grounds, HullStandsOnManyPoints) {
  // A drum of 32 corners: Bullet keeps four points of them.
  DelassusWorld world;
  world.addGround();
  auto hull = std::make_unique<btConvexHullShape>();
  for (int i = 0; i < 32; ++i) {
    const btScalar angle = SIMD_2_PI * i / 32;
    for (int y : {-1, 1}) hull->addPoint({btCos(angle), btScalar(0.3) * y, btSin(angle)}, false);
  }
  hull->recalcLocalAabb();
  hull->setMargin(0);
  btRigidBody& drum = world.addBody(std::move(hull), BulletWorld::at({0, btScalar(0.3), 0}), 2);
  expectRests(world, drum, tolerance(1e-4, 1e-3));
}

}  // namespace
}  // namespace delassus::test
