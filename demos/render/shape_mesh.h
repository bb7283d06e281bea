#pragma once

#include <btBulletCollisionCommon.h>

#include <Eigen/Core>
#include <vector>

#include "demos/render/mesh.h"

namespace demos::render {

/// A convex part of a shape, or a surface, with its place in the body.
struct ShapePart {
  Mesh mesh;
  Eigen::Matrix4f place;
};

/// The shape that Bullet collides with, as triangles. Boxes, spheres, capsules, cylinders, cones
/// and hulls are exact (but for the hulls' margin). Other convex shapes become the hull of their
/// support points. Concave shapes come triangle by triangle, compounds part by part. `segments` is
/// the number of segments of a full circle.
///
/// Static planes have no end and are not here: see ground.h.
std::vector<ShapePart> shapeParts(const btCollisionShape& shape, int segments);

Eigen::Vector3f toFloat(const btVector3& v);
Eigen::Vector3d toDouble(const btVector3& v);
Eigen::Matrix4f toMatrix(const btTransform& transform);

}  // namespace demos::render
