// The bodies of Delassus' paper: on our solver Bullet's world does what the region theory predicts.
#include <Eigen/Dense>
#include <random>

#include "bullet_ext/convert.h"
#include "delassus/release.h"
#include "demos/scenes/builders.h"
#include "tests/scenes/run_scene.h"

namespace demos {
namespace {

using delassus::analyseRelease;
using delassus::ReleaseAnalysis;
using delassus::bullet::toCore;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Each row is the normal of a plane that the bead touches, as Bullet has rounded it.
MatrixXd planeNormals(const World& world) {
  std::vector<Eigen::Vector3d> normals;
  const btCollisionObjectArray& objects = world.dynamics().getCollisionObjectArray();
  for (int i = 0; i < objects.size(); ++i) {
    const btCollisionShape* shape = objects[i]->getCollisionShape();
    if (shape->getShapeType() == STATIC_PLANE_PROXYTYPE)
      normals.push_back(toCore(static_cast<const btStaticPlaneShape*>(shape)->getPlaneNormal()));
  }
  MatrixXd rows(normals.size(), 3);
  for (std::size_t i = 0; i < normals.size(); ++i) rows.row(Eigen::Index(i)) = normals[i];
  return rows;
}

/// Steps the bead once and compares it with the region of W = N Nᵀ, q = h N F (1 kg).
void expectPredictedOutcome(std::unique_ptr<World> built) {
  OnRegions run(std::move(built));
  const MatrixXd normals = planeNormals(*run.world);
  const Eigen::Vector3d force = toCore(run.body().getGravity());
  const MatrixXd W = normals * normals.transpose();
  const ReleaseAnalysis predicted = analyseRelease(W, h * normals * force);
  run.world->step(h);

  // In single precision up to an ulp of the radius is between a plane and the bead on it, and the
  // step may close that.
  const double speed = h * beadForce, tolerance = byPrecision(1e-9, 1e-4) * speed;
  const VectorXd u = normals * toCore(run.body().getLinearVelocity());
  for (int i = 0; i < u.size(); ++i) {
    EXPECT_NEAR(u[i], predicted.u[i], tolerance) << "opening velocity of contact " << i;
    // On a wall of the region either label is right; the motion is the same.
    if (predicted.distance > 2 * tolerance) {
      EXPECT_EQ(u[i] <= tolerance, bool(predicted.persisting[i])) << "contact " << i;
    }
  }
  EXPECT_EQ(run.solver.report().outOfBudget + run.solver.report().incompatible, 0);
}

class BeadInAngle : public testing::TestWithParam<double> {};

TEST_P(BeadInAngle, KeepsWhatTheRegionSaysInAllDirections) {
  for (int degree = 0; degree < 360; ++degree) {
    SCOPED_TRACE("force at " + std::to_string(degree) + " degrees");
    expectPredictedOutcome(buildBeadInAngle(GetParam(), degree * M_PI / 180));
  }
}

INSTANTIATE_TEST_SUITE_P(narrowAndWide, BeadInAngle,
                         testing::Values(-0.5, -0.99, -0.9999, 0.5, 0.9));

// Paper §10: to drop every contact with a negative forced reaction is wrong in both ways.
TEST(BeadInAngle, RefutesTheCurrentIdea) {
  const auto analyse = [](const std::string& scene) {
    OnRegions run(scene);
    const MatrixXd normals = planeNormals(*run.world);
    return analyseRelease(normals * normals.transpose(),
                          h * normals * toCore(run.body().getGravity()));
  };
  const ReleaseAnalysis narrow = analyse("bead_in_angle");
  EXPECT_LT(narrow.forced.maxCoeff(), 0);
  EXPECT_EQ(narrow.persisting, (std::vector<bool>{true, false}));
  expectPredictedOutcome(findScene("bead_in_angle").build());

  const ReleaseAnalysis wide = analyse("bead_in_angle_wide");
  EXPECT_GT(wide.forced[0], 0);
  EXPECT_LT(wide.forced[1], 0);
  EXPECT_EQ(wide.persisting, (std::vector<bool>{false, false}));
  expectPredictedOutcome(findScene("bead_in_angle_wide").build());
}

TEST(BeadInTrihedron, KeepsWhatTheRegionSaysOverTheSphere) {
  std::mt19937_64 random(11);
  std::normal_distribution<double> normal;
  for (const double height : {0.2, 0.4, 0.8})
    for (int i = 0; i < 200; ++i) {
      const double x = normal(random), y = normal(random), z = normal(random);
      SCOPED_TRACE(testing::Message()
                   << "height " << height << ", force along " << x << " " << y << " " << z);
      expectPredictedOutcome(buildBeadInTrihedron(height, vec3(x, y, z)));
    }
}

TEST(BeadUnderPlane, FallsFreelyFromTheFirstStep) {
  OnRegions run("bead_under_plane");
  for (int k = 1; k <= 30; ++k) {
    run.world->step(h);
    const double expected = -9.81 * h * h * k * (k + 1) / 2;  // semi-implicit Euler's y = −g t²/2
    EXPECT_NEAR(run.body().getWorldTransform().getOrigin().y(), expected, byPrecision(1e-12, 1e-5));
  }
}

// A rod of mass m and inertia I on supports at ±a: A = 1/m + a²/I on the diagonal, B = 1/m − a²/I
// beside it (theory §4).
TEST(RodOnSupports, LiftsOffWhereTheRegionSays) {
  for (const double a : {0.4, 0.8, 1.5, 1.9})
    for (const double pull : {2.0, 4.0, 6.0, 8.0, 20.0, 60.0}) {
      SCOPED_TRACE(testing::Message() << "supports at " << a << " m, pull " << pull << " N");
      OnRegions run(buildRodOnSupports(a, pull));
      const double inverseInertia = run.body().getInvInertiaDiagLocal().z();
      const double A = 1 + a * a * inverseInertia, B = 1 - a * a * inverseInertia;
      const double lift = h * (pull - 9.81), turn = h * 2 * pull * inverseInertia;
      const ReleaseAnalysis predicted = analyseRelease(
          (MatrixXd(2, 2) << A, B, B, A).finished(), VectorXd{{lift + a * turn, lift - a * turn}});
      run.world->step(h);

      const double v = run.body().getLinearVelocity().y(), w = run.body().getAngularVelocity().z();
      EXPECT_NEAR(v + a * w, predicted.u[0], byPrecision(1e-9, 1e-4));
      EXPECT_NEAR(v - a * w, predicted.u[1], byPrecision(1e-9, 1e-4));
    }
}

/// Total impulse of the contacts between the two shapes in the last step, N·s.
double pressedBy(const World& world, const btCollisionObject* support) {
  btDispatcher* dispatcher = const_cast<btDiscreteDynamicsWorld&>(world.dynamics()).getDispatcher();
  double total = 0;
  for (int i = 0; i < dispatcher->getNumManifolds(); ++i) {
    const btPersistentManifold& manifold = *dispatcher->getManifoldByIndexInternal(i);
    if (manifold.getBody0() != support && manifold.getBody1() != support) continue;
    for (int j = 0; j < manifold.getNumContacts(); ++j)
      total += manifold.getContactPoint(j).m_appliedImpulse;
  }
  return total;
}

/// Steps until the object no longer presses on the body.
void runUntilReleased(OnRegions& run, const btCollisionObject* support, double hz) {
  run.world->step(1 / hz);
  ASSERT_GT(pressedBy(*run.world, support), 0);
  while (pressedBy(*run.world, support) > 0 && run.world->time() < 5) run.world->step(1 / hz);
  ASSERT_LT(run.world->time(), 5);
}

/// If the rate is doubled the error must be halved, up to the half step in which the release falls
/// at random, and in single precision up to the shift by rounded positions.
void expectProportionalToStep(const std::vector<double>& errors) {
  const double rounding = byPrecision(0, 1e-3);
  EXPECT_LT(errors.back(), 1.5 * errors.front() / std::pow(2, errors.size() - 1) + rounding);
  for (std::size_t i = 1; i < errors.size(); ++i)
    EXPECT_LT(errors[i], 0.75 * errors[i - 1] + rounding) << "halving " << i;
}

TEST(BallOffBall, LeavesAtTwoThirdsOfItsHeight) {
  constexpr double start = 3 * M_PI / 180;
  std::vector<double> errors;
  for (const double hz : {120., 240., 480., 960.}) {
    OnRegions run(buildBallOffBall(start));
    runUntilReleased(run, run.world->dynamics().getCollisionObjectArray()[0], hz);
    const btVector3 centre = run.body().getWorldTransform().getOrigin();
    const double angle = std::atan2(centre.x(), centre.y());
    errors.push_back(std::fabs(angle - std::acos(2.0 / 3 * std::cos(start))));
    RecordProperty("error_at_" + std::to_string(int(hz)), std::to_string(errors.back()));
  }
  expectProportionalToStep(errors);
}

TEST(SlidingLadder, LeavesTheWallAtTwoThirdsOfItsHeight) {
  constexpr double start = 75 * M_PI / 180;
  std::vector<double> errors;
  for (const double hz : {120., 240., 480., 960.}) {
    OnRegions run(buildSlidingLadder(start));
    runUntilReleased(run, run.world->dynamics().getCollisionObjectArray()[1], hz);
    const double height = run.body().getWorldTransform().getOrigin().y();
    errors.push_back(std::fabs(height / std::sin(start) - 2.0 / 3));
    RecordProperty("error_at_" + std::to_string(int(hz)), std::to_string(errors.back()));
  }
  expectProportionalToStep(errors);
}

}  // namespace
}  // namespace demos
