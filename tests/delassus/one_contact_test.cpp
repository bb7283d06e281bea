/// One contact with friction:  K_μ ∋ r ⟂ u + μ‖u_t‖ n ∈ K_μ*,  u = W r + q.
#include "delassus/one_contact.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/random_problems.h"
#include "tests/support/reference_contact.h"

namespace delassus {
namespace {

/// How far r is from the law: Signorini's, then Coulomb's. ‖W‖ brings m/s and N·s to one measure.
double lawViolation(const Mat3& W, const Vec3& q, double mu, const Vec3& r) {
  const Vec3 u = W * r + q;
  const double w = W.norm(), t = std::hypot(r[1], r[2]), speed = std::hypot(u[1], u[2]);
  const double apart = std::max(-u[0], -w * r[0]);  // u_n ≥ 0, r_n ≥ 0
  const double both = std::min(w * r[0], u[0]);     // one of them 0
  const double cone = w * (t - mu * r[0]);          // ‖r_t‖ ≤ μ r_n
  const double inside = w * (mu * r[0] - t);        // and equal where it slides,
  const double slack = std::min(std::max(inside, 0.0), speed);
  // with friction against the slip: u_t ‖r_t‖ = −‖u_t‖ r_t, in units of the smaller of the two.
  const double turned = std::hypot(u[1] * t + speed * r[1], u[2] * t + speed * r[2]) /
                        std::max({t, speed / w, 1e-300});
  return std::max({apart, both, cone, slack, turned});
}

/// Condition numbers 1 to 1e3 (arms of up to thirty radii of gyration), in units that differ.
Mat3 randomBlock(int k, Random& random) {
  return std::pow(10.0, uniform(random, -3, 3)) *
         Mat3(randomDelassus(3, std::pow(10.0, k % 4), random));
}

double randomFriction(int k, Random& random) { return k % 5 == 0 ? 0 : uniform(random, 0, 2); }

TEST(OneContact, ObeysTheLawOnRandomBlocks) {
  Random random(21);
  int modes[3] = {};
  for (int k = 0; k < 100000; ++k) {
    const Mat3 W = randomBlock(k, random);
    const double mu = randomFriction(k, random);
    const Vec3 q = normalVector(3, random);
    const Vec3 r = solveOneContact(W, q, mu);
    ASSERT_TRUE(r.allFinite()) << "sample " << k;
    if (mu > 0)
      ASSERT_LT(lawViolation(W, q, mu, r), 1e-10 * q.norm()) << "sample " << k;
    else
      ASSERT_EQ(r, Vec3(std::max(0.0, -q[0] / W(0, 0)), 0, 0)) << "sample " << k;
    ++modes[r[0] == 0 ? 0 : (W * r + q).norm() < 1e-9 ? 1 : 2];
  }
  for (const int count : modes) EXPECT_GT(count, 1000);
}

TEST(OneContact, IsOneOfAllSolutionsFoundByLookingEverywhere) {
  Random random(22);
  for (int k = 0; k < 3000; ++k) {
    const Mat3 W = randomDelassus(3, std::pow(10.0, k % 4), random);
    const double mu = randomFriction(k, random);
    const Vec3 q = normalVector(3, random);
    const Vec3 r = solveOneContact(W, q, mu);
    double nearest = 1e300, size = 0;
    for (const test::ReferenceContact& reference : test::allContactSolutions(W, q, mu)) {
      nearest = std::min(nearest, (r - reference.r).norm());
      size = std::max(size, reference.r.norm());
    }
    EXPECT_LE(nearest, 1e-9 * size) << "sample " << k;
  }
}

// Algorithms 13d, e.
TEST(OneContact, PublishedVectors) {
  Mat3 W;
  W << 2, 0.5, 0, 0.5, 1, 0, 0, 0, 1;
  const auto expectNear = [](const Vec3& r, const Vec3& truth) {
    EXPECT_LT((r - truth).norm(), 2e-12) << r.transpose();
  };
  expectNear(solveOneContact(W, {-1, 2, -1}, 0.5),
             {0.564647845166, -0.258591380665, 0.113301787755});
  expectNear(solveOneContact(W, {-1, 0.2, -0.1}, 0.5),
             {0.569750906328, -0.279003625313, 0.0575412971501});
  W << 2, 0.5, -0.3, 0.5, 1, 0.2, -0.3, 0.2, 1.5;
  expectNear(solveOneContact(W, {-1, 2, -1}, 0.8),
             {0.651442442405, -0.467126218802, 0.231072584697});
}

// A particle, W = I/m. Inside the cone it rests; outside it slides with the rest of its velocity.
TEST(OneContact, AParticleInClosedForm) {
  const double m = 3, mu = 0.5;
  const Mat3 W = Mat3::Identity() / m;
  EXPECT_EQ(solveOneContact(W, {0.1, 5, 5}, mu), Vec3::Zero());
  EXPECT_EQ(solveOneContact(W, {0, 5, 5}, mu), Vec3::Zero());
  EXPECT_LT((solveOneContact(W, {-2, 0.6, -0.8}, mu) - m * Vec3(2, -0.6, 0.8)).norm(), 1e-14);
  EXPECT_LT((solveOneContact(W, {-2, 6, -8}, mu) - m * Vec3(2, -0.6, 0.8)).norm(), 1e-14);
}

// Tangents are a convention: turning them turns the reaction as well.
TEST(OneContact, DoesNotDependOnTheTangents) {
  Random random(23);
  for (int k = 0; k < 1000; ++k) {
    const Mat3 W = randomDelassus(3, 100, random);
    const Vec3 q = normalVector(3, random);
    const double mu = uniform(random, 0, 0.3), angle = uniform(random, 0, 7);
    Mat3 T = Mat3::Identity();
    T.bottomRightCorner<2, 2>() << std::cos(angle), -std::sin(angle), std::sin(angle),
        std::cos(angle);
    const Vec3 r = solveOneContact(W, q, mu);
    const Vec3 turned = solveOneContact(T * W * T.transpose(), T * q, mu);
    EXPECT_LT((turned - T * r).norm(), 1e-9 * (1 + r.norm())) << "sample " << k;
  }
}

// The reaction from which the search begins may be any, even one that has all but vanished or has
// nothing to do with the answer.
TEST(OneContact, WhereTheSearchBeginsDoesNotMatter) {
  Random random(23);
  for (int k = 0; k < 3000; ++k) {
    const Mat3 W = randomBlock(k, random);
    const Vec3 q = normalVector(3, random);
    const double mu = uniform(random, 0.1, 2);
    const OneContact contact(W);
    const Vec3 expected = contact.solve(q, mu);
    const Vec3 direction = normalVector(3, random);
    for (const double size : {1e-320, 1e-200, 1e-160, 1e-30, 1.0, 1e30, 1e200}) {
      const Vec3 r = contact.solve(q, mu, size * direction);
      ASSERT_LT(lawViolation(W, q, mu, r), 1e-10 * q.norm()) << size;
      ASSERT_LE((r - expected).norm(), 1e-8 * expected.norm()) << size;
    }
  }
}

// Bodies that can only rise, or move in a plane: the tangential block is zero or singular.
TEST(OneContact, SingularTangentialBlocks) {
  for (const double mu : {0.0, 0.3, 2.0}) {
    const Mat3 rises = Vec3(2, 0, 0).asDiagonal();
    const Mat3 inPlane = Vec3(2, 1, 0).asDiagonal();
    for (const Vec3& q :
         {Vec3(-1, 0, 0), Vec3(-1, 3, 0), Vec3(-1, 3, -4), Vec3(-1, 0.1, 0.2), Vec3(-1, 0.1, 0)}) {
      for (const Mat3& W : {rises, inPlane}) {
        const Vec3 r = solveOneContact(W, q, mu);
        ASSERT_TRUE(r.allFinite());
        EXPECT_NEAR(r[0], 0.5, 1e-15);
        if (mu > 0) {
          EXPECT_LT(lawViolation(W, q, mu, r), 1e-12) << "q " << q.transpose() << " mu " << mu;
        }
      }
    }
  }
}

// In worlds that move in a plane nothing moves along the third axis.
TEST(OneContact, SticksInAPlane) {
  const Mat3 W = Vec3(2, 1, 0).asDiagonal();
  EXPECT_EQ(solveOneContact(W, {-1, 0.1, 0}, 0.3), Vec3(0.5, -0.1, 0));
  Random random(31);
  for (int k = 0; k < 1000; ++k) {
    Mat3 rotation = Mat3::Identity();
    rotation.bottomRightCorner<2, 2>() = Eigen::Rotation2Dd(uniform(random, 0, 3)).matrix();
    Mat3 inPlane = Mat3::Zero();
    inPlane.topLeftCorner<2, 2>() = randomDelassus(2, 100, random);
    const Mat3 turned = rotation * inPlane * rotation.transpose();
    const double mu = uniform(random, 0, 1);
    const Vec3 q = rotation * Vec3(-1, uniform(random, -1, 1), 0);
    const Vec3 r = solveOneContact(turned, q, mu);
    EXPECT_LT(lawViolation(turned, q, mu, r), 1e-12 * inPlane.norm());
  }
}

// Powers of two, so that the bits are the same.
TEST(OneContact, UnitsOnlyScale) {
  Random random(24);
  for (int k = 0; k < 1000; ++k) {
    const Mat3 W = randomDelassus(3, 1000, random);
    const Vec3 q = normalVector(3, random);
    const double mu = uniform(random, 0, 1);
    const Vec3 r = solveOneContact(W, q, mu);
    EXPECT_EQ(solveOneContact(W / 1024, q, mu), 1024 * r);
    EXPECT_EQ(solveOneContact(W, 64 * q, mu), 64 * r);
  }
}

}  // namespace
}  // namespace delassus
