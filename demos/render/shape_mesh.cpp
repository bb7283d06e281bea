#include "demos/render/shape_mesh.h"

#include <LinearMath/btConvexHullComputer.h>

#include <cmath>

namespace demos::render {

using Eigen::Matrix4f;
using Eigen::Vector3f;

namespace {

/// The turn that brings e_y to Bullet's axis number `axis`.
Matrix4f upAlong(int axis) {
  Matrix4f turn = Matrix4f::Identity();
  if (axis == 0) turn.topLeftCorner<3, 3>() << 0, 1, 0, -1, 0, 0, 0, 0, 1;
  if (axis == 2) turn.topLeftCorner<3, 3>() << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  return turn;
}

Mesh hullMesh(const std::vector<btVector3>& points) {
  Mesh mesh;
  if (points.size() < 4) return mesh;
  btConvexHullComputer hull;
  hull.compute(&points[0].m_floats[0], sizeof(btVector3), int(points.size()), 0, 0);
  for (int face = 0; face < hull.faces.size(); ++face) {
    std::vector<Vector3f> corners;
    const btConvexHullComputer::Edge* const first = &hull.edges[hull.faces[face]];
    const btConvexHullComputer::Edge* edge = first;
    do {
      corners.push_back(toFloat(hull.vertices[edge->getSourceVertex()]));
      edge = edge->getNextEdgeOfFace();
    } while (edge != first);
    mesh.addPolygon(corners);
  }
  return mesh;
}

std::vector<btVector3> cornersOf(const btPolyhedralConvexShape& shape) {
  std::vector<btVector3> corners(std::size_t(shape.getNumVertices()));
  for (int i = 0; i < shape.getNumVertices(); ++i) shape.getVertex(i, corners[std::size_t(i)]);
  return corners;
}

/// Support points in directions spread evenly over the sphere (Fibonacci's spiral).
std::vector<btVector3> supportPoints(const btConvexShape& shape, int count) {
  const double golden = M_PI * (3 - std::sqrt(5.0));
  std::vector<btVector3> points;
  for (int i = 0; i < count; ++i) {
    const double y = 1 - 2 * (i + 0.5) / count, out = std::sqrt(1 - y * y);
    points.push_back(shape.localGetSupportingVertex(btVector3(
        btScalar(out * std::cos(golden * i)), btScalar(y), btScalar(out * std::sin(golden * i)))));
  }
  return points;
}

class TriangleCollector : public btTriangleCallback {
 public:
  void processTriangle(btVector3* corners, int, int) override {
    mesh.addPolygon({toFloat(corners[0]), toFloat(corners[1]), toFloat(corners[2])});
  }
  Mesh mesh;
};

Mesh surfaceMesh(const btConcaveShape& shape) {
  btVector3 low, high;
  shape.getAabb(btTransform::getIdentity(), low, high);
  TriangleCollector collector;
  shape.processAllTriangles(&collector, low, high);
  return std::move(collector.mesh);
}

void addConvex(std::vector<ShapePart>& parts, const btConvexShape& shape, const Matrix4f& place,
               int segments) {
  switch (shape.getShapeType()) {
    case BOX_SHAPE_PROXYTYPE: {
      const auto& box = static_cast<const btBoxShape&>(shape);
      parts.push_back({boxMesh(toFloat(box.getHalfExtentsWithMargin())), place});
      return;
    }
    case SPHERE_SHAPE_PROXYTYPE: {
      const auto& sphere = static_cast<const btSphereShape&>(shape);
      parts.push_back({sphereMesh(float(sphere.getRadius()), segments), place});
      return;
    }
    case CAPSULE_SHAPE_PROXYTYPE: {
      const auto& capsule = static_cast<const btCapsuleShape&>(shape);
      parts.push_back(
          {capsuleMesh(float(capsule.getRadius()), float(capsule.getHalfHeight()), segments),
           place * upAlong(capsule.getUpAxis())});
      return;
    }
    case CYLINDER_SHAPE_PROXYTYPE: {
      const auto& cylinder = static_cast<const btCylinderShape&>(shape);
      const btVector3 half = cylinder.getHalfExtentsWithMargin();
      parts.push_back(
          {cylinderMesh(float(cylinder.getRadius()), float(half[cylinder.getUpAxis()]), segments),
           place * upAlong(cylinder.getUpAxis())});
      return;
    }
    case CONE_SHAPE_PROXYTYPE: {
      const auto& cone = static_cast<const btConeShape&>(shape);
      parts.push_back({coneMesh(float(cone.getRadius()), float(cone.getHeight()) / 2, segments),
                       place * upAlong(cone.getConeUpIndex())});
      return;
    }
    case CONVEX_HULL_SHAPE_PROXYTYPE:
    case TETRAHEDRAL_SHAPE_PROXYTYPE:
      parts.push_back(
          {hullMesh(cornersOf(static_cast<const btPolyhedralConvexShape&>(shape))), place});
      return;
    default:
      parts.push_back({hullMesh(supportPoints(shape, 16 * segments)), place});
  }
}

void addShape(std::vector<ShapePart>& parts, const btCollisionShape& shape, const Matrix4f& place,
              int segments) {
  if (shape.isCompound()) {
    const auto& compound = static_cast<const btCompoundShape&>(shape);
    for (int i = 0; i < compound.getNumChildShapes(); ++i)
      addShape(parts, *compound.getChildShape(i), place * toMatrix(compound.getChildTransform(i)),
               segments);
  } else if (shape.isConvex()) {
    addConvex(parts, static_cast<const btConvexShape&>(shape), place, segments);
  } else if (shape.isConcave() && shape.getShapeType() != STATIC_PLANE_PROXYTYPE) {
    parts.push_back({surfaceMesh(static_cast<const btConcaveShape&>(shape)), place});
  }
}

}  // namespace

Vector3f toFloat(const btVector3& v) { return {float(v.x()), float(v.y()), float(v.z())}; }
Eigen::Vector3d toDouble(const btVector3& v) {
  return {double(v.x()), double(v.y()), double(v.z())};
}

Matrix4f toMatrix(const btTransform& transform) {
  Matrix4f matrix = Matrix4f::Identity();
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) matrix(i, j) = float(transform.getBasis()[i][j]);
    matrix(i, 3) = float(transform.getOrigin()[i]);
  }
  return matrix;
}

std::vector<ShapePart> shapeParts(const btCollisionShape& shape, int segments) {
  std::vector<ShapePart> parts;
  addShape(parts, shape, Matrix4f::Identity(), segments);
  return parts;
}

}  // namespace demos::render
