// The triangles of a shape are the shape: same support points, same volume, faces outwards.
#include "demos/render/shape_mesh.h"

#include <gtest/gtest.h>

#include <BulletCollision/CollisionShapes/btHeightfieldTerrainShape.h>
#include <Eigen/Geometry>

#include <cmath>
#include <memory>
#include <random>

namespace demos::render {
namespace {

using Eigen::Vector3f;

constexpr int segments = 48;

Vector3f placed(const ShapePart& part, const Vector3f& point) {
  return (part.place * point.homogeneous()).head<3>();
}

/// Σ a·(b×c)/6 over all triangles: the volume if they close around it, faces outwards.
double volume(const std::vector<ShapePart>& parts) {
  double sum = 0;
  for (const ShapePart& part : parts)
    for (std::size_t i = 0; i < part.mesh.triangles.size(); i += 3) {
      Vector3f corner[3];
      for (std::size_t k = 0; k < 3; ++k)
        corner[k] = placed(part, part.mesh.vertices[part.mesh.triangles[i + k]].position);
      sum += double(corner[0].dot(corner[1].cross(corner[2]))) / 6;
    }
  return sum;
}

double reach(const std::vector<ShapePart>& parts, const Vector3f& direction) {
  float most = -1e30f;
  for (const ShapePart& part : parts)
    for (const Vertex& vertex : part.mesh.vertices)
      most = std::max(most, direction.dot(placed(part, vertex.position)));
  return double(most);
}

struct Sample {
  const char* name;
  std::shared_ptr<btConvexShape> shape;
  double volume;  ///< m³, in closed form
};

std::vector<Sample> samples() {
  auto hull = std::make_shared<btConvexHullShape>();
  for (const btVector3& corner :
       {btVector3(0, 0, 0), btVector3(1, 0, 0), btVector3(0, 1, 0), btVector3(0, 0, 1)})
    hull->addPoint(corner);
  hull->setMargin(0);
  const btVector3 centres[] = {btVector3(-1, 0, 0), btVector3(1, 0, 0)};
  const btScalar radii[] = {btScalar(0.5), btScalar(0.5)};
  const double capsule = M_PI * 0.25 * 2 + 4.0 / 3 * M_PI * 0.125;
  return {
      {"box", std::make_shared<btBoxShape>(btVector3(1, 2, 3)), 48},
      {"sphere", std::make_shared<btSphereShape>(2), 4.0 / 3 * M_PI * 8},
      {"capsule", std::make_shared<btCapsuleShape>(btScalar(0.5), 2), capsule},
      {"capsuleX", std::make_shared<btCapsuleShapeX>(btScalar(0.5), 2), capsule},
      {"capsuleZ", std::make_shared<btCapsuleShapeZ>(btScalar(0.5), 2), capsule},
      {"cylinder", std::make_shared<btCylinderShape>(btVector3(1, 2, 1)), M_PI * 4},
      {"cylinderX", std::make_shared<btCylinderShapeX>(btVector3(2, 1, 1)), M_PI * 4},
      {"cylinderZ", std::make_shared<btCylinderShapeZ>(btVector3(1, 1, 2)), M_PI * 4},
      {"cone", std::make_shared<btConeShape>(1, 3), M_PI},
      {"coneX", std::make_shared<btConeShapeX>(1, 3), M_PI},
      {"coneZ", std::make_shared<btConeShapeZ>(1, 3), M_PI},
      {"hull", hull, 1.0 / 6},
      {"multiSphere", std::make_shared<btMultiSphereShape>(centres, radii, 2), capsule},
  };
}

TEST(ShapeMesh, ConvexShapesHaveTheirVolume) {
  for (const Sample& sample : samples()) {
    const auto parts = shapeParts(*sample.shape, segments);
    // Polygons inscribed in circles and rounded edges take away a little, and never add.
    EXPECT_LE(volume(parts), sample.volume * 1.0001) << sample.name;
    EXPECT_GE(volume(parts), sample.volume * 0.975) << sample.name;
  }
}

TEST(ShapeMesh, ConvexShapesReachAsFarAsBulletSays) {
  std::mt19937_64 random(1920);
  std::normal_distribution<float> normal;
  for (const Sample& sample : samples()) {
    const auto parts = shapeParts(*sample.shape, segments);
    for (int i = 0; i < 50; ++i) {
      const Vector3f direction =
          Vector3f(normal(random), normal(random), normal(random)).normalized();
      const btVector3 support = sample.shape->localGetSupportingVertex(
          btVector3(btScalar(direction.x()), btScalar(direction.y()), btScalar(direction.z())));
      const double expected = double(direction.dot(toFloat(support)));
      // Rounded edges: five per cent of the smallest half size, here at most 1 m. Margins: 0.04 m.
      EXPECT_NEAR(reach(parts, direction), expected, 0.09) << sample.name;
    }
  }
}

TEST(ShapeMesh, CompoundPlacesItsParts) {
  btBoxShape box(btVector3(1, 1, 1));
  btSphereShape ball(1);
  btCompoundShape inner, outer;
  inner.addChildShape(btTransform(btQuaternion::getIdentity(), btVector3(5, 0, 0)), &box);
  outer.addChildShape(btTransform(btQuaternion::getIdentity(), btVector3(0, 3, 0)), &inner);
  outer.addChildShape(btTransform::getIdentity(), &ball);
  const auto parts = shapeParts(outer, segments);
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_NEAR(reach(parts, Vector3f::UnitX()), 6, 1e-5);
  EXPECT_NEAR(reach(parts, Vector3f::UnitY()), 4, 1e-5);
  EXPECT_NEAR(reach(parts, -Vector3f::UnitX()), 1, 1e-2);
}

TEST(ShapeMesh, ConcaveShapesGiveTheirTriangles) {
  btTriangleMesh triangles;
  triangles.addTriangle(btVector3(0, 0, 0), btVector3(1, 0, 0), btVector3(0, 0, 1));
  triangles.addTriangle(btVector3(1, 0, 0), btVector3(1, 0, 1), btVector3(0, 0, 1));
  const btBvhTriangleMeshShape surface(&triangles, true);
  const auto parts = shapeParts(surface, segments);
  ASSERT_EQ(parts.size(), 1u);
  EXPECT_EQ(parts[0].mesh.triangles.size(), 6u);

  const btScalar heights[] = {0, 0, 0, 0, 1, 0, 0, 0, 0};
  const btHeightfieldTerrainShape field(3, 3, heights, 1, 0, 1, 1, PHY_FLOAT, false);
  const auto hills = shapeParts(field, segments);
  ASSERT_EQ(hills.size(), 1u);
  EXPECT_EQ(hills[0].mesh.triangles.size(), 3u * 8u);
  // Bullet centres the field at half its height.
  EXPECT_NEAR(reach(hills, Vector3f::UnitY()), 0.5, 1e-5);
}

}  // namespace
}  // namespace demos::render
