#include "tests/support/sphere_heaps.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <vector>

namespace delassus::test {
namespace {

constexpr double radius = 0.5, rate = 60;

/// Centres of spheres that fell, pushed each other away and were kept between the walls, many times
/// over.
std::vector<Vec3> pour(int count, double side, Random& random) {
  constexpr int rounds = 400, pushes = 4;
  constexpr double firstFall = 0.02, looseness = 2;
  std::vector<Vec3> centres(count);
  for (Vec3& x : centres)
    for (int k = 0; k < 3; ++k)
      x[k] = radius + uniform(random, 0, k < 2 ? side - 1 : looseness * count / (side * side));
  for (int round = 0; round < rounds; ++round) {
    for (Vec3& x : centres) x[2] -= firstFall * (rounds - round) / rounds;
    for (int k = 0; k < pushes; ++k) {
      for (int i = 0; i < count; ++i)
        for (int j = 0; j < i; ++j) {
          const Vec3 apart = centres[i] - centres[j];
          const double distance = apart.norm();
          if (!(distance < 2 * radius && distance > 0)) continue;
          const Vec3 push = (radius / distance - 0.5) * apart;
          centres[i] += push;
          centres[j] -= push;
        }
      for (Vec3& x : centres) {
        for (int axis : {0, 1}) x[axis] = std::clamp(x[axis], radius, side - radius);
        x[2] = std::max(x[2], radius);
      }
    }
  }
  return centres;
}

/// A contact in which n points from the other thing to sphere `a`.
Contact touch(int a, int b, const Vec3& n, double gap, double friction) {
  constexpr double recovery = 0.2;
  Contact c;
  c.a = a;
  c.b = b;
  c.armA = -radius * n;
  if (b >= 0) c.armB = radius * n;
  const Vec3 tangent = n.unitOrthogonal();
  c.frame << n, tangent, n.cross(tangent);
  c.friction = friction;
  c.target[0] = -gap * rate * (gap < 0 ? recovery : 1);
  return c;
}

}  // namespace

Pile makeSphereHeap(int count, double side, double friction, double disturbance, Random& random) {
  constexpr double near = 0.01;  // m: a gap that is a contact
  const std::vector<Vec3> centres = pour(count, side, random);
  Pile pile;
  for (int i = 0; i < count; ++i) {
    Vec6 v;
    for (int k = 0; k < 6; ++k) v[k] = uniform(random, -disturbance, disturbance);
    v[2] -= 9.81 / rate;
    Body sphere = makeBox(1, radius, v);
    sphere.inverseInertia = Mat3::Identity() / (0.4 * radius * radius);
    pile.bodies.push_back(sphere);

    const auto add = [&](int other, const Vec3& n, double gap) {
      if (gap < near) pile.contacts.push_back(touch(i, other, n, gap, friction));
    };
    const Vec3& x = centres[i];
    for (int j = 0; j < i; ++j) {
      const Vec3 apart = x - centres[j];
      add(j, apart.normalized(), apart.norm() - 2 * radius);
    }
    for (int axis : {0, 1}) {
      add(fixedWorld, Vec3::Unit(axis), x[axis] - radius);
      add(fixedWorld, -Vec3::Unit(axis), side - radius - x[axis]);
    }
    add(fixedWorld, Vec3::UnitZ(), x[2] - radius);
  }
  return pile;
}

}  // namespace delassus::test
