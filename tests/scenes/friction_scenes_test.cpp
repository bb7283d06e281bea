// Coulomb's law on slopes and on the flat, in every direction.
#include "demos/scenes/builders.h"
#include "tests/scenes/run_scene.h"

namespace demos {
namespace {

constexpr double degree = M_PI / 180;
std::vector<Slope> slopesAt(double angle) {
  std::vector<Slope> slopes;
  for (const double heading : {0.0, 17.0, 30.0, 45.0, 71.0})
    slopes.push_back({angle, heading * degree});
  return slopes;
}

TEST(Incline, HoldsOneDegreeBelowTheFrictionAngle) {
  OnRegions run(buildInclines(slopesAt(frictionAngle() - degree)));
  const Drift drift(*run.world);
  run.world->run(10, hz);
  EXPECT_LT(drift.largest(), byPrecision(1e-6, 1e-4));
}

/// One step of a box that slides down a slope, in m/s².
struct SlidingStep {
  double acceleration;  ///< along the fall line
  double fromLaw;       ///< distance of the acceleration from g sin θ e_fall − μ g cos θ v/|v|
  double disturbance;   ///< spin and velocity off the slope at the end of the step, rad/s and m/s
  int points;           ///< points that carried the box
  double residual;      ///< m/s
};

std::vector<SlidingStep> slide(double angle, double heading, double seconds) {
  const btVector3 fall = vec3(std::cos(angle), -std::sin(angle), 0),
                  up = vec3(std::sin(angle), std::cos(angle), 0);
  OnRegions run(buildInclines({{angle, heading}}));
  std::vector<SlidingStep> steps;
  while (run.world->time() < seconds) {
    const btVector3 before = run.body().getLinearVelocity();
    run.world->step(1 / hz);
    const btVector3 after = run.body().getLinearVelocity(),
                    gained = (after - before) * btScalar(hz);
    const double disturbance =
        std::fabs(double(after.dot(up))) + double(run.body().getAngularVelocity().length());
    const btVector3 law = fall * btScalar(9.81 * std::sin(angle)) -
                          after.normalized() * btScalar(usualFriction * 9.81 * std::cos(angle));
    steps.push_back({double(gained.dot(fall)), double((gained - law).length()), disturbance,
                     run.solver.report().contacts, run.solver.report().residualMax});
  }
  return steps;
}

// a = g (sin θ − μ cos θ) along the fall line, whatever the heading of the box: within a thousandth
// (in float a tenth) in every step that the box begins and ends flat on the slope. (Where a spell
// has turned its path, friction is along the new one.) Now and then Bullet's narrow phase leaves
// two points under the box, which then tips on to the missing ones. Such a spell begins with the
// points; the law is solved all the time.
TEST(Incline, AcceleratesByTheLawAboveTheFrictionAngle) {
  const double angle = frictionAngle() + degree;
  const double expected = 9.81 * (std::sin(angle) - usualFriction * std::cos(angle));
  const double flat = byPrecision(1e-5, 1e-3);
  for (const double heading : {0.0, 17.0, 30.0, 45.0, 71.0}) {
    SCOPED_TRACE(testing::Message() << "heading " << heading << " degrees");
    const std::vector<SlidingStep> steps = slide(angle, heading * degree, 2.5);
    int undisturbed = 0;
    double mean = 0;
    for (std::size_t i = 0; i < steps.size(); ++i) {
      mean += steps[i].acceleration / double(steps.size());
      EXPECT_LT(steps[i].residual, 1e-8) << "step " << i;
      const bool flatBefore = i == 0 || steps[i - 1].disturbance < flat,
                 flatAfter = steps[i].disturbance < flat;
      if (flatBefore && !flatAfter) {
        EXPECT_LT(steps[i].points, 4) << "the spell that begins at step " << i;
      }
      if (!flatBefore || !flatAfter) continue;
      ++undisturbed;
      EXPECT_LT(steps[i].fromLaw, byPrecision(1e-3, 1e-1) * expected) << "step " << i;
    }
    EXPECT_GT(undisturbed, int(steps.size()) / 3);
    EXPECT_NEAR(mean, expected, 5e-2 * expected) << "what the spells cost";
  }
}

// Semi-implicit Euler stops v/(μ g h) steps later, v²/(2 μ g) − v h/2 further on.
TEST(BoxHeadings, StopOnOneCircle) {
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
    EXPECT_LT(run.body(int(i)).getLinearVelocity().length(), byPrecision(1e-8, 1e-4));
  }
}

// The same with rolling friction: 5/7 κ g/R instead of μ g; the mass has no influence.
TEST(RollingBalls, RollOutAfterTheirDistance) {
  constexpr double speed = 3;
  const std::vector<RollingBall> balls{{0.2, 1}, {0.1, 1}, {0.06, 1}, {0.06, 100}};
  OnRegions run(buildRollingBalls(balls, speed));
  run.world->run(4, hz);
  std::vector<btScalar> stopped;
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const double loss = 5.0 / 7 * balls[i].kappa * 9.81 / rollingRadius;
    const double expected = speed * speed / (2 * loss) - speed / hz / 2;
    stopped.push_back(run.body(int(i)).getWorldTransform().getOrigin().x());
    EXPECT_NEAR(stopped.back(), expected, 2e-3) << balls[i].kappa;
  }
  run.world->run(1, hz);
  for (std::size_t i = 0; i < balls.size(); ++i)
    EXPECT_NEAR(run.body(int(i)).getWorldTransform().getOrigin().x(), stopped[i],
                byPrecision(1e-9, 1e-5));
}

}  // namespace
}  // namespace demos
