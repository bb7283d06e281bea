#include <cmath>

#include "demos/scenes/builders.h"

namespace demos {

namespace {

// A card of 2 x 1.4 m and 4 cm, as light as it is thin.
constexpr double halfLength = 1, halfThickness = 0.02, halfWidth = 0.7, mass = 0.1;
// From the vertical. A leg passes its load on along itself if tan(lean) < μ = 0.5.
constexpr double lean = 15 * M_PI / 180;
constexpr double cardGap = 0.01;
// Cards are pressed together by this, m: Bullet reports boxes only when they touch, and rounding
// would part some.
constexpr double bite = 1e-5;

struct Leg {
  double halfSpan = halfLength * std::sin(lean) + halfThickness * std::cos(lean);
  double halfHeight = halfLength * std::cos(lean) + halfThickness * std::sin(lean);
};

/// Two cards that lean on each other above (x, y).
void addPair(World& world, double x, double y) {
  const Leg leg;
  for (const int side : {-1, 1}) {
    const btQuaternion turn = aboutZ(side * lean);
    const btVector3 centre = vec3(x + side * (leg.halfSpan - 0.5 * bite), y + leg.halfHeight, 0);
    addBox(world, vec3(halfThickness, halfLength, halfWidth), btScalar(mass),
           btTransform(turn, centre));
  }
}

}  // namespace

std::unique_ptr<World> buildCardHouse(int storeys) {
  auto world = std::make_unique<World>();
  addGround(*world);
  const Leg leg;
  // A floor card reaches from apex to apex and carries both feet of the pair above it.
  const double span = 4 * leg.halfSpan + 0.1;
  const double storeyHeight = 2 * leg.halfHeight + 2 * halfThickness - 2 * bite;
  for (int storey = 0; storey < storeys; ++storey) {
    const int pairs = storeys - storey;
    const double y = storey * storeyHeight - bite;
    for (int i = 0; i < pairs; ++i) addPair(*world, (i - 0.5 * (pairs - 1)) * span, y);
    for (int i = 0; i < pairs - 1; ++i) {
      const btVector3 half = vec3(0.5 * (span - cardGap), halfThickness, halfWidth);
      const double x = (i - 0.5 * (pairs - 2)) * span;
      addBox(*world, half, btScalar(mass), at(x, y + 2 * leg.halfHeight + halfThickness - bite, 0));
    }
  }
  return world;
}

}  // namespace demos
