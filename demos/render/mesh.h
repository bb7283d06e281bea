#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

namespace demos::render {

struct Vertex {
  Eigen::Vector3f position, normal;
};

/// Triangles, counter-clockwise seen from outside. Metres.
struct Mesh {
  std::vector<Vertex> vertices;
  std::vector<std::uint32_t> triangles;

  /// A flat convex polygon.
  void addPolygon(const std::vector<Eigen::Vector3f>& corners);
};

/// Edges are rounded by a few per cent, so that they catch the light.
Mesh boxMesh(const Eigen::Vector3f& half);

/// One ring of a body of revolution about e_y, with its normal (outwards, up).
struct Ring {
  float radius, height;
  float normalOut, normalUp;
};
/// Joins each ring to the next, from the top down. Two rings at one place make a sharp edge.
Mesh revolve(const std::vector<Ring>& rings, int segments);

Mesh sphereMesh(float radius, int segments);
/// Axis e_y; `half` is half the height of the straight part.
Mesh capsuleMesh(float radius, float half, int segments);
Mesh cylinderMesh(float radius, float half, int segments);
/// Apex up, from -half to +half.
Mesh coneMesh(float radius, float half, int segments);

}  // namespace demos::render
