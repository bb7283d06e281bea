#include "tests/peers/mixed_piles.h"

#include <string>

#include "tests/support/random_piles.h"

namespace delassus::peers {

std::vector<Problem> mixedPiles() {
  constexpr double speed = 0.3;  // m/s, rad/s
  std::vector<Problem> piles;
  for (const double friction : {0.4, 1.0})
    for (const int layers : {3, 5, 7})
      for (const double ratio : {1e3, 1e6}) {
        Random random(layers);
        const test::PileIsland island(test::makePyramid(layers, friction, speed, ratio, random));
        piles.push_back(island.problem);
        piles.back().name = std::to_string(island.pile.bodies.size()) +
                            " boxes, 1 : " + (ratio > 1e4 ? "1e6" : "1e3") + ", friction " +
                            (friction < 1 ? "0.4" : "1");
      }
  return piles;
}

}  // namespace delassus::peers
