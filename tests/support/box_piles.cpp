#include "tests/support/box_piles.h"

namespace delassus::test {

Body makeBox(double mass, double halfSize, const Vec6& velocity) {
  Body box;
  box.inverseMass.setConstant(1 / mass);
  box.inverseInertia = Mat3::Identity() * (1.5 / (mass * halfSize * halfSize));
  box.velocity = velocity;
  return box;
}

Contact makeRestingPoint(int above, int below, const Vec3& armAbove, const Vec3& armBelow,
                         double friction) {
  Contact c;
  c.a = above;
  c.b = below;
  c.armA = armAbove;
  c.armB = armBelow;
  c.frame << 0, 1, 0,  //
      0, 0, 1,         //
      1, 0, 0;
  c.friction = friction;
  return c;
}

Row makeWeakMotor() {
  Row motor;
  motor.a = 0;
  motor.jacobianA << 0, 0, 0, 0, 0, 1;
  motor.target = 1;
  motor.lower = -0.1, motor.upper = 0.1;
  return motor;
}

Pile makeTower(const std::vector<double>& masses, double friction, double disturbance,
               std::mt19937_64& random) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  Pile pile;
  for (int i = 0; i < static_cast<int>(masses.size()); ++i) {
    Vec6 v = Vec6::Zero();
    v[2] = -9.81 / 60;
    for (int k = 0; k < 6; ++k) v[k] += disturbance * uniform(random);
    pile.bodies.push_back(makeBox(masses[i], 0.5, v));
    for (double x : {-0.5, 0.5})
      for (double y : {-0.5, 0.5})
        pile.contacts.push_back(makeRestingPoint(i, i - 1, {x, y, -0.5},
                                                 i > 0 ? Vec3(x, y, 0.5) : Vec3::Zero(), friction));
  }
  return pile;
}

Pile makePyramid(int base, double friction, double disturbance, double massRatio,
                 std::mt19937_64& random) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  Pile pile;
  std::vector<int> below;
  for (int layer = 0; layer < base; ++layer) {
    const int width = base - layer;
    std::vector<int> here;
    for (int i = 0; i < width * width; ++i) {
      Vec6 v = Vec6::Zero();
      v[2] = -9.81 / 60;
      for (int k = 0; k < 6; ++k) v[k] += disturbance * uniform(random);
      const int me = static_cast<int>(pile.bodies.size());
      pile.bodies.push_back(makeBox(layer % 2 ? massRatio : 1, 0.5, v));
      here.push_back(me);
      if (layer == 0) {
        for (double x : {-0.5, 0.5})
          for (double y : {-0.5, 0.5})
            pile.contacts.push_back(
                makeRestingPoint(me, fixedWorld, {x, y, -0.5}, Vec3::Zero(), friction));
        continue;
      }
      for (int dx = 0; dx < 2; ++dx)
        for (int dy = 0; dy < 2; ++dy) {
          const int under = below[(i / width + dx) * (width + 1) + i % width + dy];
          const Vec3 offset(dx - 0.5, dy - 0.5, 0);
          for (double x : {0.0, 0.5})
            for (double y : {0.0, 0.5}) {
              const Vec3 at((dx ? x : -x), (dy ? y : -y), 0);
              pile.contacts.push_back(makeRestingPoint(me, under, at - Vec3(0, 0, 0.5),
                                                       at - offset + Vec3(0, 0, 0.5), friction));
            }
        }
    }
    below = here;
  }
  return pile;
}

}  // namespace delassus::test
