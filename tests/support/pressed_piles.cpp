#include "tests/support/pressed_piles.h"

#include <cmath>
#include <vector>

namespace delassus::test {

Pile makePressed(int height, double friction, double tilt, double disturbance, double speed,
                 Random& random) {
  Pile pile = makeTower(std::vector<double>(height, 1.0), friction, disturbance, random);
  for (int i = 0; i < 4; ++i) pile.contacts[i].target[0] = speed;
  for (const double x : {-0.5, 0.5})
    for (const double y : {-0.5, 0.5}) {
      Contact c = makeRestingPoint(height - 1, fixedWorld, {x, y, 0.5}, Vec3::Zero(), friction);
      c.frame.col(0) = Vec3(std::sin(tilt), 0, -std::cos(tilt));
      c.frame.col(1) = Vec3(std::cos(tilt), 0, std::sin(tilt));
      c.frame.col(2) = Vec3(0, -1, 0);
      c.target[0] = speed;
      pile.contacts.push_back(c);
    }
  return pile;
}

}  // namespace delassus::test
