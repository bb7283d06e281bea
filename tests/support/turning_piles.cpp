#include "tests/support/turning_piles.h"

#include <Eigen/Geometry>

namespace delassus::test {

TurningFriction aboutTangents(const Contact& c, double spinning, double rolling) {
  return {spinning, rolling, c.frame.rightCols<2>()};
}

void resistTurning(Pile& pile, double largest, Random& random) {
  const auto coefficient = [&] {
    return uniform(random, 0, 1) < 0.3 ? 0 : uniform(random, 0, largest);
  };
  for (std::size_t i = 0; i < pile.contacts.size(); ++i) {
    const double spinning = coefficient(), rolling = coefficient();
    addRows(aboutTangents(pile.contacts[i], spinning, rolling), pile.contacts[i],
            static_cast<int>(i), pile.rows);
  }
}

Pile makeHeap(int balls, double friction, Random& random) {
  Pile pile;
  std::vector<Vec3> centres;
  for (int i = 0; i < balls; ++i) {
    const double mass = uniform(random, 0.5, 2);
    Body ball;
    ball.inverseMass.setConstant(1 / mass);
    ball.inverseInertia = Mat3::Identity() / (0.1 * mass);
    ball.velocity = 0.3 * normalVector(6, random);
    ball.velocity[2] -= 9.81 / 60;
    pile.bodies.push_back(ball);
    centres.push_back({uniform(random, 0, 2), uniform(random, 0, 2), uniform(random, 0.4, 1.6)});
  }
  for (int a = 0; a < balls; ++a) {
    pile.contacts.push_back(makeRestingPoint(a, fixedWorld, {0, 0, -0.5}, Vec3::Zero(), friction));
    for (int b = 0; b < a; ++b) {
      if ((centres[a] - centres[b]).norm() > 1.2) continue;
      const Vec3 n = (centres[a] - centres[b]).normalized(), t = n.unitOrthogonal();
      Contact c = makeRestingPoint(a, b, -0.5 * n, 0.5 * n, friction);
      c.frame << n, t, n.cross(t);
      pile.contacts.push_back(c);
    }
  }
  return pile;
}

}  // namespace delassus::test
