// Coulomb's law on slopes and on the flat, in every direction.
#include "demos/scenes/builders.h"
#include "tests/scenes/run_scene.h"

namespace demos {
namespace {

constexpr double degree = M_PI / 180;
constexpr double hz = 60;

std::vector<Slope> slopesAt(double angle) {
  std::vector<Slope> slopes;
  for (const double heading : {0.0, 17.0, 30.0, 45.0, 71.0})
    slopes.push_back({angle, heading * degree});
  return slopes;
}

TEST(Incline, holdsOneDegreeBelowTheFrictionAngle) {
  OnRegions run(buildInclines(slopesAt(frictionAngle() - degree)));
  const Drift drift(*run.world);
  run.world->run(10, hz);
  EXPECT_LT(drift.largest(), byPrecision(1e-6, 1e-4));
}

// a = g (sin θ − μ cos θ) along the fall line, whatever the heading of the box.
TEST(Incline, acceleratesByTheLawAboveTheFrictionAngle) {
  const double angle = frictionAngle() + degree;
  const double expected = 9.81 * (std::sin(angle) - usualFriction * std::cos(angle));
  const btVector3 fall = vec3(std::cos(angle), -std::sin(angle), 0);
  OnRegions run(buildInclines(slopesAt(angle)));
  run.world->run(0.5, hz);
  std::vector<btVector3> before;
  for (const btRigidBody* body : run.world->movableBodies())
    before.push_back(body->getLinearVelocity());
  constexpr double seconds = 2;
  run.world->run(seconds, hz);
  for (std::size_t i = 0; i < before.size(); ++i) {
    const btVector3 gained = run.body(int(i)).getLinearVelocity() - before[i];
    EXPECT_NEAR(double(gained.dot(fall)) / seconds, expected, byPrecision(1e-3, 1e-2) * expected)
        << "lane " << i;
    EXPECT_NEAR(gained.z(), 0, byPrecision(1e-3, 1e-2) * expected)
        << "lane " << i << " strays from the fall line";
  }
}

// Semi-implicit Euler stops v/(μ g h) steps later, v²/(2 μ g) − v h/2 further on.
TEST(BoxHeadings, stopOnOneCircle) {
  constexpr double speed = 4;
  OnRegions run(buildBoxHeadings(12, speed));
  run.world->run(3, hz);
  const double expected =
      headingsRadius + speed * speed / (2 * usualFriction * 9.81) - speed / hz / 2;
  for (std::size_t i = 0; i < 12; ++i) {
    const btVector3 centre = run.body(int(i)).getWorldTransform().getOrigin();
    EXPECT_NEAR(std::hypot(centre.x(), centre.z()), expected, 2e-3) << "heading " << 30 * i;
    const double heading = std::atan2(double(centre.z()), double(centre.x()));
    EXPECT_NEAR(std::remainder(heading - 30 * degree * double(i), 2 * M_PI), 0, 3e-3);
    EXPECT_LT(run.body(int(i)).getLinearVelocity().length(), byPrecision(1e-9, 1e-4));
  }
}

}  // namespace
}  // namespace demos
