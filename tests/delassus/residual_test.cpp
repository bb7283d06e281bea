#include "delassus/residual.h"

#include <gtest/gtest.h>

#include <Eigen/SVD>
#include <cmath>
#include <map>
#include <random>

#include "delassus/cone.h"
#include "tests/support/reference_contact.h"

namespace delassus {
namespace {

/// An explicit problem, with one number of friction for each contact and one pair of bounds for
/// each row.
Problem problemOf(const MatrixXd& W, const VectorXd& q, const VectorXd& friction,
                  const VectorXd& lower = {}, const VectorXd& upper = {}) {
  Problem problem;
  problem.W = DelassusMatrix(DelassusMatrix::Sparse(W.sparseView()));
  problem.q = q;
  problem.friction = friction;
  problem.lower = lower;
  problem.upper = upper;
  return problem;
}

Problem oneContact(const Mat3& W, const Vec3& q, double mu) {
  return problemOf(W, q, VectorXd::Constant(1, mu));
}

Problem oneRow(double W, double q, double lower, double upper) {
  return problemOf(MatrixXd::Constant(1, 1, W), VectorXd::Constant(1, q), {},
                   VectorXd::Constant(1, lower), VectorXd::Constant(1, upper));
}

VectorXd one(double x) { return VectorXd::Constant(1, x); }

/// W of a contact of one or two rigid bodies with arms and inertias of everyday proportions:
/// symmetric, positive definite.
class RandomContact {
 public:
  explicit RandomContact(unsigned seed) : random_(seed) {}

  Mat3 W() {
    Mat3 W = Mat3::Identity() * (0.2 + uniform());
    for (int body = 0; body < 2; ++body) {
      const Mat3 arm = Mat3::Zero().unaryExpr([&](double) { return normal(); });
      W += uniform() * arm * arm.transpose();
    }
    return W;
  }
  Vec3 q() { return {normal(), normal(), normal()}; }
  double friction() { return 0.05 + uniform(); }
  double uniform() { return std::uniform_real_distribution<double>()(random_); }
  double normal() { return std::normal_distribution<double>()(random_); }

 private:
  std::mt19937_64 random_;
};

TEST(NaturalResidual, VanishesAtSolutionsOfOneContactInAllThreeModes) {
  RandomContact random(13);
  std::map<Mode, int> seen;
  for (int k = 0; k < 300; ++k) {
    const Mat3 W = random.W();
    Vec3 q = random.q();
    if (k % 2) q.tail<2>() /= 10;  // slow enough to stick, now and then
    const double mu = random.friction();
    const auto solutions = test::allContactSolutions(W, q, mu);
    ASSERT_FALSE(solutions.empty()) << "each contact has a solution";
    for (const test::ReferenceContact& solution : solutions) {
      const VelocityResidual residual = naturalResidual(oneContact(W, q, mu), solution.r);
      // u = W r + q has the rounding of terms of the size of q.
      EXPECT_LT(residual.max, 1e-14 * W.norm() * (solution.r.norm() + q.norm()));
      EXPECT_EQ(residual.worst, 0);
      ++seen[solution.mode];
    }
  }
  EXPECT_GT(seen[Mode::Open], 30);
  EXPECT_GT(seen[Mode::Stick], 30);
  EXPECT_GT(seen[Mode::Slide], 30);
}

TEST(NaturalResidual, PublishedOneContactVectors) {
  struct Vector {
    Mat3 W;
    Vec3 q;
    double mu;
    Vec3 r;
    Mode mode;
  };
  const Mat3 Wd = (Mat3() << 2, .5, 0, .5, 1, 0, 0, 0, 1).finished();
  const Mat3 We = (Mat3() << 2, .5, -.3, .5, 1, .2, -.3, .2, 1.5).finished();
  // Algorithms §13 d (twice) and e, given to twelve digits.
  const Vector vectors[] = {
      {Wd, {-1, 2, -1}, 0.5, {0.564647845166, -0.258591380665, 0.113301787755}, Mode::Slide},
      {Wd, {-1, .2, -.1}, 0.5, {0.569750906328, -0.279003625313, 0.0575412971501}, Mode::Slide},
      {We, {-1, 2, -1}, 0.8, {0.651442442405, -0.467126218802, 0.231072584697}, Mode::Slide},
  };
  for (const Vector& v : vectors) {
    EXPECT_LT(naturalResidual(oneContact(v.W, v.q, v.mu), v.r).max, 1e-11);
    const test::ReferenceContact reference = test::referenceContact(v.W, v.q, v.mu);
    EXPECT_EQ(reference.mode, v.mode);
    EXPECT_LT((reference.r - v.r).norm(), 1e-11);
  }
  const Vec3 ud = test::referenceContact(Wd, {-1, 2, -1}, 0.5).u;
  EXPECT_LT((ud - Vec3(0, 2.02373254192, -0.886698212245)).norm(), 1e-11);
  const Vec3 ue = test::referenceContact(We, {-1, 2, -1}, 0.8).u;
  EXPECT_LT((ue - Vec3(0, 1.90480951934, -0.942249099436)).norm(), 1e-11);
}

TEST(NaturalResidual, IsTheVelocityMissed) {
  // A body of 2 kg falls on the ground at 3 m/s: without reaction, with a third of the right one,
  // and with the right one.
  const Problem problem = oneContact(Mat3::Identity() / 2, {-3, 0, 0}, 0.5);
  EXPECT_DOUBLE_EQ(naturalResidual(problem, Vec3::Zero()).max, 3);
  EXPECT_DOUBLE_EQ(naturalResidual(problem, Vec3(2, 0, 0)).max, 2);
  EXPECT_DOUBLE_EQ(naturalResidual(problem, Vec3(6, 0, 0)).max, 0);
}

/// The errors of these reactions, for a search that aims at a residual of 1e-8 m/s.
VelocityResidual errorOf(const Problem& problem, const VectorXd& r) {
  NaturalMap map;
  map.setProblem(problem);
  map.aimAt(1e-8);
  return map.error(r, problem.W * r + problem.q);
}

// A body of 1 kg nears the ground at 1 m/s, and slips.
TEST(SearchErrors, HideNoApproachBehindFriction) {
  for (const double mu : {0.5, 2.0, 10.0, 1000.0}) {
    const Problem problem = oneContact(Mat3::Identity(), {-1, 1 / mu, 0}, mu);
    EXPECT_GE(errorOf(problem, Vec3::Zero()).max, 0.44) << mu;  // 1/√5 where friction is 2
  }
  const Problem problem = oneContact(Mat3::Identity(), {-1, 0.1, 0}, 10);
  EXPECT_LT(naturalResidual(problem, Vec3::Zero()).max, 0.1);
}

// Far from an answer they say nothing of residuals; the nearer it is, the more they do.
TEST(SearchErrors, AreResidualsNearAnAnswer) {
  RandomContact random(5);
  for (int i = 0; i < 100; ++i) {
    const Mat3 W = random.W();
    const Vec3 q = random.q();
    for (const double mu : {0.9, 2.0, 2.1, 10.0}) {
      const Problem problem = oneContact(W, q, mu);
      const Vec3 r = test::referenceContact(W, q, mu).r;
      EXPECT_LT(errorOf(problem, r).max, 1e-12);
      for (const double off : {1e-10, 1e-7, 1e-1}) {
        const Vec3 near = projectOnCone(r + off * random.q(), mu);
        const double error = errorOf(problem, near).max;
        const double residual = naturalResidual(problem, near).max;
        if (mu <= 2)
          EXPECT_EQ(error, residual);
        else
          EXPECT_GE(error, std::min(residual, 1e-5)) << mu << " " << off;
      }
    }
  }
}

/// The convex relaxation lets a sliding body lift at μ|u_t|. The residual must not take that for
/// Coulomb's law.
TEST(NaturalResidual, RefusesTheConvexRelaxation) {
  const double mu = 0.5;
  const Vec3 q(-1, 2, 0);
  // For W = 1 it is the projection of -q on the cone, with r ⟂ u and u in the dual cone.
  const Vec3 n = Vec3(1, -mu, 0).normalized();
  const Vec3 r = n.dot(-q) * n;
  const Vec3 u = r + q;
  ASSERT_NEAR(r.dot(u), 0, 1e-15);
  ASSERT_GT(u[0], 0.1);
  EXPECT_GT(naturalResidual(oneContact(Mat3::Identity(), q, mu), r).max, 0.1);
}

TEST(NaturalResidual, DoesNotDependOnTheUnitOfMass) {
  RandomContact random(5);
  const int n = 3;
  MatrixXd W = MatrixXd::Zero(3 * n + 1, 3 * n + 1);
  VectorXd q(3 * n + 1), r(3 * n + 1), friction(n);
  for (int a = 0; a < n; ++a) {
    W.block<3, 3>(3 * a, 3 * a) = random.W();
    friction[a] = random.friction();
  }
  W(3 * n, 3 * n) = 0.7;
  W(0, 3 * n) = W(3 * n, 0) = 0.1;
  for (double& x : q) x = random.normal();
  for (double& x : r) x = random.normal();
  const double gram = 1024;  // a power of two: not even the rounding changes

  const Problem problem = problemOf(W, q, friction, one(-1), one(2));
  const Problem scaled = problemOf(W / gram, q, friction, one(-1 * gram), one(2 * gram));
  const VelocityResidual a = naturalResidual(problem, r), b = naturalResidual(scaled, gram * r);
  EXPECT_GT(a.max, 0);
  EXPECT_DOUBLE_EQ(a.max, b.max);
  EXPECT_DOUBLE_EQ(a.rms, b.rms);
  EXPECT_EQ(a.worst, b.worst);

  const FclibMeasures c = fclibMeasures(problem, r), d = fclibMeasures(scaled, gram * r);
  EXPECT_DOUBLE_EQ(c.vel, d.vel);
  EXPECT_GT(std::abs(c.rel - d.rel), 0.1 * c.rel) << "rel depends on units, which is its fault";
}

TEST(NaturalResidual, DoesNotDependOnTheTangents) {
  RandomContact random(6);
  for (int k = 0; k < 50; ++k) {
    const Mat3 W = random.W();
    const Vec3 q = random.q(), r = random.q();
    const double mu = random.friction(), angle = 6 * random.uniform();
    Mat3 turn = Mat3::Identity();
    turn.bottomRightCorner<2, 2>() << std::cos(angle), -std::sin(angle), std::sin(angle),
        std::cos(angle);
    const double before = naturalResidual(oneContact(W, q, mu), r).max;
    const double after =
        naturalResidual(oneContact(turn * W * turn.transpose(), turn * q, mu), turn * r).max;
    EXPECT_NEAR(before, after, 1e-12 * (1 + before));
  }
}

TEST(NaturalResidual, RowsObeyTheirBounds) {
  const double W = 4;
  struct Case {
    double lower, upper, r, u, missed;
  };
  const Case cases[] = {
      {0, infinity, 0, 3, 0},           // open
      {0, infinity, 2, 0, 0},           // held
      {0, infinity, 0, -3, 3},          // penetrates
      {0, infinity, -0.5, 0, 2},        // pulls: W times the forbidden part
      {0, infinity, 2, 1, 1},           // pushes while opening
      {-infinity, infinity, -7, 0, 0},  // joint held
      {-infinity, infinity, 5, -2, 2},  // joint slips
      {-1, 2, -1, 3, 0},                // motor at its lower bound
      {-1, 2, 2, -3, 0},                // at its upper bound
      {-1, 2, 2, 3, 3},                 // at the wrong bound
      {-1, 2, 2.5, 0, 2},               // beyond its bound
      {1, 1, 1, 5, 0},                  // no freedom: any velocity is right
  };
  for (const Case& c : cases) {
    const Problem problem = oneRow(W, c.u - W * c.r, c.lower, c.upper);
    EXPECT_DOUBLE_EQ(naturalResidual(problem, one(c.r)).max, c.missed) << c.r << " " << c.u;
    EXPECT_DOUBLE_EQ(naturalResidual(problem, one(c.r), one(c.u)).rms, c.missed);
  }
}

TEST(NaturalResidual, FrictionlessContactIsARow) {
  const Mat3 W = Mat3::Identity() / 2;
  for (const double rn : {-2.0, 0.0, 1.0, 6.0}) {
    const double contact = naturalResidual(oneContact(W, {-3, 5, 1}, 0), Vec3(rn, 0, 0)).max;
    const double row = naturalResidual(oneRow(0.5, -3, 0, infinity), one(rn)).max;
    EXPECT_DOUBLE_EQ(contact, row) << rn;
  }
  EXPECT_EQ(naturalResidual(oneContact(W, {3, 0, 0}, 0), Vec3::Zero()).max, 0)
      << "opens without sliding";
  EXPECT_DOUBLE_EQ(naturalResidual(oneContact(W, {1, 0, 0}, 0), Vec3(0, 4, 0)).max, 2)
      << "a tangential reaction without friction";
}

TEST(NaturalResidual, BlocksThatVanishAreJudgedToo) {
  // A contact between bodies that cannot move, alone and beside a contact that can.
  for (const double other : {0.0, 0.5}) {
    MatrixXd W = MatrixXd::Zero(6, 6);
    W.bottomRightCorner<3, 3>() = other * Mat3::Identity();
    VectorXd q(6), r = VectorXd::Zero(6);
    q << 1, 0, 0, 1, 0, 0;
    const Vec3 friction(0.5, 0.5, 0);
    EXPECT_EQ(naturalResidual(problemOf(W, q, friction.head(2)), r).max, 0);
    r[0] = 1;  // pushes while opening
    const VelocityResidual pushes = naturalResidual(problemOf(W, q, friction.head(2)), r);
    EXPECT_GT(pushes.max, 0);
    EXPECT_TRUE(std::isfinite(pushes.max) && std::isfinite(pushes.rms));
    q[0] = -1;  // penetrates: nothing can help
    r[0] = 0;
    EXPECT_DOUBLE_EQ(naturalResidual(problemOf(W, q, friction.head(2)), r).max, 1);
    EXPECT_TRUE(std::isfinite(fclibMeasures(problemOf(W, q, friction.head(2)), r).vel));
  }
  // The saddle point  u_0 = r_1 - 1, u_1 = -r_0 + 2: diagonal zero, solution (2, 1).
  const MatrixXd saddle = (MatrixXd(2, 2) << 0, 1, -1, 0).finished();
  const Eigen::Vector2d q(-1, 2), lower(0, 0), upper(infinity, infinity);
  const Problem problem = problemOf(saddle, q, {}, lower, upper);
  EXPECT_EQ(naturalResidual(problem, Eigen::Vector2d(2, 1)).max, 0);
  EXPECT_EQ(fclibMeasures(problem, Eigen::Vector2d(2, 1)).vel, 0);
  EXPECT_GT(naturalResidual(problem, Eigen::Vector2d(1, 2)).max, 0.1) << "not complementary";
}

// A demand for a velocity that its own reactions cannot give says nothing about how exact the
// others must be.
TEST(Demand, IsWhatReactionsCanAnswer) {
  const Mat3 W = Mat3::Identity();
  EXPECT_EQ(oneContact(W, {-3, 1, -2}, 0.5).demand(), 3);
  EXPECT_EQ(oneContact(W, {1500, 1, -2}, 0.5).demand(), 2) << "it is open";
  EXPECT_EQ(oneRow(2, -1e9, -infinity, infinity).demand(), 1e9) << "a joint";
  EXPECT_EQ(oneRow(2, -5, 0, infinity).demand(), 5) << "a limit that is met";
  EXPECT_EQ(oneRow(2, 1e9, 0, infinity).demand(), 0) << "one that is open";
  EXPECT_EQ(oneRow(2, -1e9, -0.1, 0.3).demand(), 2 * 0.3) << "a motor of little force";
  EXPECT_EQ(oneRow(2, 1e9, -0.1, 0.3).demand(), 2 * 0.1) << "the other way";
  EXPECT_EQ(oneRow(2, 0.05, -0.1, 0.3).demand(), 0.05) << "that it can reach";
  EXPECT_EQ(oneRow(0, -1e9, -0.1, 0.3).demand(), 0) << "where nothing moves";
  EXPECT_EQ(oneRow(2, 0, 3, 3).demand(), 2 * 3) << "a spring presses, whatever it asks for";
  EXPECT_EQ(oneRow(2, 1, -4, -3).demand(), 2 * 3) << "the other way";
  EXPECT_EQ(oneRow(2, -9, 3, 4).demand(), 9) << "asks for more";
  EXPECT_EQ(Problem().demand(), 0);
}

// Blocks that vanish get a step in the unit of the other blocks.
TEST(NaturalResidual, BlocksThatVanishDoNotSetTheUnitOfMass) {
  constexpr double gram = 1024;
  MatrixXd W = MatrixXd::Zero(2, 2);
  W(0, 0) = 0.7;
  const Eigen::Vector2d q(-0.3, 0.2), r(0.1, -0.95), lower(-1, -1), upper(4, 4);
  const VelocityResidual a = naturalResidual(problemOf(W, q, {}, lower, upper), r),
                         b = naturalResidual(problemOf(W / gram, q, {}, gram * lower, gram * upper),
                                             gram * r);
  EXPECT_GT(a.max, 0);
  EXPECT_DOUBLE_EQ(a.max, b.max);
  EXPECT_DOUBLE_EQ(a.rms, b.rms);
}

TEST(NaturalResidual, NamesTheWorstAndNeverHidesANaN) {
  MatrixXd W = MatrixXd::Identity(8, 8);
  VectorXd q = VectorXd::Zero(8), r = VectorXd::Zero(8);
  q[0] = -1;
  q[3] = -4;
  q[6] = -2;
  const Problem problem =
      problemOf(W, q, Eigen::Vector2d(0.5, 0.5), Eigen::Vector2d(0, 0), Eigen::Vector2d(9, 9));
  EXPECT_EQ(naturalResidual(problem, r).worst, 3);
  EXPECT_DOUBLE_EQ(naturalResidual(problem, r).max, 4);
  EXPECT_DOUBLE_EQ(naturalResidual(problem, r).rms, std::sqrt((1 + 16 + 4) / 4.0));
  for (const int at : {0, 4, 7}) {
    VectorXd bad = r;
    bad[at] = std::nan("");
    EXPECT_TRUE(std::isnan(naturalResidual(problem, bad).max)) << at;
    EXPECT_TRUE(std::isnan(naturalResidual(problem, bad).rms)) << at;
    EXPECT_TRUE(std::isnan(fclibMeasures(problem, bad).vel)) << at;
  }
  EXPECT_EQ(naturalResidual(Problem(), VectorXd()).max, 0);
  EXPECT_EQ(naturalResidual(Problem(), VectorXd()).worst, -1);
}

TEST(FclibMeasures, AreTheirFormulas) {
  // At r = 0, |F(1)| = |q| if -q is inside the cone; s = 3 / trace.
  const Mat3 W = Vec3(1, 2, 3).asDiagonal();
  const Vec3 q(-5, 0, 0);
  const Problem problem = oneContact(W, q, 0.5);
  const FclibMeasures rest = fclibMeasures(problem, Vec3::Zero());
  EXPECT_DOUBLE_EQ(rest.rel, 1);
  EXPECT_DOUBLE_EQ(rest.vel, 1);
  // A contact that opens although it is pushed: F(1) = r - P(r - u) = (20,0,0) - (5,0,0),
  // F(s)/s = 2 (20 - (20 - 15/2)) = 15.
  const FclibMeasures pushed = fclibMeasures(problem, Vec3(20, 0, 0));
  EXPECT_DOUBLE_EQ(pushed.rel, 3);
  EXPECT_DOUBLE_EQ(pushed.vel, 3);

  const FclibMeasures row = fclibMeasures(oneRow(4, -2, 0, infinity), one(0.25));
  EXPECT_DOUBLE_EQ(row.rel, 0.5);  // u = -1
  EXPECT_DOUBLE_EQ(row.vel, 0.5);

  EXPECT_EQ(fclibMeasures(oneContact(W, Vec3::Zero(), 0.5), Vec3::Zero()).rel, 0);
  EXPECT_EQ(fclibMeasures(oneContact(W, Vec3::Zero(), 0.5), Vec3(1, 0, 0)).rel, infinity);
}

// A reaction that has grown without end does not tell how well the demand is met.
TEST(NaturalResidual, ALargeReactionHidesNoVelocity) {
  const VectorXd r = VectorXd::Constant(1, 1e20), u = VectorXd::Constant(1, -3);
  for (const double lower : {-infinity, 0.0})
    EXPECT_EQ(naturalResidual(oneRow(0.5, -3, lower, infinity), r, u).max, 3);
}

/// Blocks of all kinds: coupled, as those of balls (arms along the normal, up to rounding), of
/// every size, unsymmetric, and with eigenvalues of both signs.
TEST(ContactSize, IsTheLargestSingularValue) {
  RandomContact random(31);
  for (const double coupling : {1.0, 1e-5, 1e-8, 1e-13, 1e-16, 0.0})
    for (const double unit : {1e-120, 1.0, 1e120})
      for (const double skew : {0.0, 0.3})
        for (int k = 0; k < 20; ++k) {
          Mat3 W = unit * random.W();
          W.row(0).tail<2>() *= coupling;
          W.col(0).tail<2>() *= coupling;
          W(1, 2) *= 1 + skew;
          if (k % 2) W(0, 0) *= 100;  // makes the normal the largest instead of a tangent
          if (k % 3 == 2) W -= W.trace() * Mat3::Identity();
          const double largest = (W / unit).jacobiSvd().singularValues()[0];
          EXPECT_NEAR(contactSize(W) / unit, largest, 1e-13 * largest) << W;
        }
}

}  // namespace
}  // namespace delassus
