#include "demos/render/mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace demos::render {

using Eigen::Vector3f;

namespace {

constexpr float pi = float(M_PI);

/// Appends the rings of a quarter circle (or half of one) around (0, centre), at angles from the
/// axis.
void addArc(std::vector<Ring>& rings, float radius, float centre, float from, float to, int steps) {
  for (int i = 0; i <= steps; ++i) {
    const float angle = from + (to - from) * float(i) / float(steps);
    const float out = std::sin(angle), up = std::cos(angle);
    rings.push_back({radius * out, centre + radius * up, out, up});
  }
}

}  // namespace

void Mesh::addPolygon(const std::vector<Vector3f>& corners) {
  if (corners.size() < 3) return;
  // Newell's sum: good for any flat polygon, also where the first corners are in line.
  Vector3f normal = Vector3f::Zero();
  for (std::size_t i = 0; i < corners.size(); ++i)
    normal += corners[i].cross(corners[(i + 1) % corners.size()]);
  if (normal.norm() == 0) return;
  normal.normalize();
  const auto first = std::uint32_t(vertices.size());
  for (const Vector3f& corner : corners) vertices.push_back({corner, normal});
  for (std::uint32_t i = 2; i < corners.size(); ++i)
    triangles.insert(triangles.end(), {first, first + i - 1, first + i});
}

Mesh boxMesh(const Vector3f& half) {
  const float bevel = 0.05f * half.minCoeff();
  Mesh mesh;
  // Vertex 3 c + a is that of corner c on the face across axis a; bit k of c says on which side it
  // lies along axis k.
  const auto side = [](int corner, int axis) { return (corner >> axis & 1) != 0 ? 1.0f : -1.0f; };
  for (int corner = 0; corner < 8; ++corner)
    for (int axis = 0; axis < 3; ++axis) {
      Vector3f position;
      for (int k = 0; k < 3; ++k)
        position[k] = side(corner, k) * (half[k] - (k == axis ? 0 : bevel));
      mesh.vertices.push_back({position, side(corner, axis) * Vector3f::Unit(axis)});
    }
  // Turns the triangle to face outwards, in whatever order its corners come.
  const auto addTriangle = [&mesh](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const Vector3f &pa = mesh.vertices[a].position, &pb = mesh.vertices[b].position,
                   &pc = mesh.vertices[c].position;
    const Vector3f outwards =
        mesh.vertices[a].normal + mesh.vertices[b].normal + mesh.vertices[c].normal;
    if ((pb - pa).cross(pc - pa).dot(outwards) < 0) std::swap(b, c);
    mesh.triangles.insert(mesh.triangles.end(), {a, b, c});
  };
  const auto addQuad = [&](int a, int b, int c, int d) {
    addTriangle(std::uint32_t(a), std::uint32_t(b), std::uint32_t(c));
    addTriangle(std::uint32_t(a), std::uint32_t(c), std::uint32_t(d));
  };
  for (int axis = 0; axis < 3; ++axis) {
    const int u = 1 << (axis + 1) % 3, v = 1 << (axis + 2) % 3;
    const int nextAxis = (axis + 1) % 3, lastAxis = (axis + 2) % 3;
    for (const int low : {0, 1 << axis}) {
      // The face, then two of the four edges along this axis, whose ends differ in bit `axis`
      // alone.
      addQuad(3 * low + axis, 3 * (low | u) + axis, 3 * (low | u | v) + axis, 3 * (low | v) + axis);
    }
    for (const int edge : {0, u, v, u | v}) {
      const int other = edge | 1 << axis;
      addQuad(3 * edge + nextAxis, 3 * other + nextAxis, 3 * other + lastAxis, 3 * edge + lastAxis);
    }
  }
  for (int corner = 0; corner < 8; ++corner)
    addTriangle(std::uint32_t(3 * corner), std::uint32_t(3 * corner + 1),
                std::uint32_t(3 * corner + 2));
  return mesh;
}

Mesh revolve(const std::vector<Ring>& rings, int segments) {
  Mesh mesh;
  for (const Ring& ring : rings)
    for (int i = 0; i <= segments; ++i) {
      const float angle = 2 * pi * float(i) / float(segments);
      const float x = std::cos(angle), z = -std::sin(angle);
      mesh.vertices.push_back({{ring.radius * x, ring.height, ring.radius * z},
                               {ring.normalOut * x, ring.normalUp, ring.normalOut * z}});
    }
  const auto stride = std::uint32_t(segments + 1);
  for (std::uint32_t ring = 0; ring + 1 < rings.size(); ++ring)
    for (std::uint32_t i = 0; i < std::uint32_t(segments); ++i) {
      const std::uint32_t a = ring * stride + i, b = a + stride;
      if (rings[ring].radius > 0) mesh.triangles.insert(mesh.triangles.end(), {a, b, a + 1});
      if (rings[ring + 1].radius > 0)
        mesh.triangles.insert(mesh.triangles.end(), {a + 1, b, b + 1});
    }
  return mesh;
}

Mesh sphereMesh(float radius, int segments) {
  std::vector<Ring> rings;
  addArc(rings, radius, 0, 0, pi, segments / 2);
  return revolve(rings, segments);
}

Mesh capsuleMesh(float radius, float half, int segments) {
  std::vector<Ring> rings;
  addArc(rings, radius, half, 0, pi / 2, segments / 4);
  addArc(rings, radius, -half, pi / 2, pi, segments / 4);
  return revolve(rings, segments);
}

Mesh cylinderMesh(float radius, float half, int segments) {
  return revolve({{0, half, 0, 1},
                  {radius, half, 0, 1},
                  {radius, half, 1, 0},
                  {radius, -half, 1, 0},
                  {radius, -half, 0, -1},
                  {0, -half, 0, -1}},
                 segments);
}

Mesh coneMesh(float radius, float half, int segments) {
  const float slant = std::hypot(radius, 2 * half);
  const float out = 2 * half / slant, up = radius / slant;
  // The apex is a ring of hardly any radius, so that each segment has its own normal there.
  return revolve({{1e-4f * radius, half, out, up},
                  {radius, -half, out, up},
                  {radius, -half, 0, -1},
                  {0, -half, 0, -1}},
                 segments);
}

}  // namespace demos::render
