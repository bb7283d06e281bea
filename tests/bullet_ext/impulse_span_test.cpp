/// Coordinates in the basis that impulses make measure what these do together.
#include "bullet_ext/impulse_span.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <numeric>
#include <vector>

#include "tests/support/random_problems.h"

namespace delassus::test {
namespace {

using bullet::ImpulseSpan;

class ImpulseSpans : public testing::Test {
 protected:
  static constexpr int bodyCount = 4;
  ImpulseSpans() {
    for (int i = 0; i < bodyCount; ++i) {
      Body& body = bodies_.emplace_back();
      body.inverseMass.setConstant(uniform(random_, 0.1, 2));
      const Mat3 A = normalMatrix(3, 3, random_);
      body.inverseInertia = A * A.transpose();
    }
  }
  /// On one body or two.
  ImpulseSpan::Impulse randomImpulse() {
    ImpulseSpan::Impulse p;
    p.a = static_cast<int>(random_() % bodyCount);
    p.b = static_cast<int>(random_() % (bodyCount + 1)) - 1;
    if (p.b == p.a) p.b = -1;
    p.onA = normalVector(6, random_);
    if (p.b >= 0) p.onB = normalVector(6, random_);
    p.wanted = {uniform(random_, -1, 1), uniform(random_, -1, 1), uniform(random_, -1, 1)};
    return p;
  }
  double product(const ImpulseSpan::Impulse& p, const ImpulseSpan::Impulse& q) const {
    return ImpulseSpan::product(bodies_, p, q);
  }
  std::vector<double> coordinates(const ImpulseSpan::Impulse& p) const {
    std::vector<double> of;
    span_.coordinates(bodies_, p, of);
    return of;
  }
  void add(const ImpulseSpan::Impulse& p) {
    const std::vector<double> of = coordinates(p);
    span_.add(p, of, product(p, p) - dot(of, of));
  }
  static double dot(const std::vector<double>& a, const std::vector<double>& b) {
    return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
  }

  Random random_{61};
  std::vector<Body> bodies_;
  ImpulseSpan span_;
};

// Of impulses in the span, the coordinates tell all products.
TEST_F(ImpulseSpans, KeepProducts) {
  std::vector<ImpulseSpan::Impulse> impulses;
  for (int i = 0; i < 12; ++i) add(impulses.emplace_back(randomImpulse()));
  for (const auto& p : impulses)
    for (const auto& q : impulses)
      EXPECT_NEAR(dot(coordinates(p), coordinates(q)), product(p, q), 1e-10);
}

// What an impulse has outside of the span is missing in its coordinates.
TEST_F(ImpulseSpans, AnImpulseIsNoShorterThanItsPartInTheSpan) {
  for (int i = 0; i < 8; ++i) add(randomImpulse());
  for (int i = 0; i < 20; ++i) {
    const ImpulseSpan::Impulse p = randomImpulse();
    const std::vector<double> of = coordinates(p);
    EXPECT_LE(dot(of, of), product(p, p) * (1 + 1e-12));
  }
}

TEST_F(ImpulseSpans, WhatIsTruncatedIsAsIfItHadNeverBeenAdded) {
  for (int i = 0; i < 5; ++i) add(randomImpulse());
  const ImpulseSpan::Impulse probe = randomImpulse();
  const std::vector<double> before = coordinates(probe);
  for (int i = 0; i < 5; ++i) add(randomImpulse());
  EXPECT_EQ(coordinates(probe).size(), 10u);
  span_.truncate(5);
  EXPECT_EQ(coordinates(probe), before);
}

// The motion of least energy that gives each row the velocity that it asks for is in their span.
TEST_F(ImpulseSpans, TellWhatRowsAskForAlongAnother) {
  std::vector<ImpulseSpan::Impulse> rows;
  for (int i = 0; i < 6; ++i) add(rows.emplace_back(randomImpulse()));
  MatrixXd W(6, 6), wanted(6, 3);
  VectorXd along(6);
  const ImpulseSpan::Impulse probe = randomImpulse();
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 6; ++j) W(i, j) = product(rows[i], rows[j]);
    wanted.row(i) << rows[i].wanted.ofErrors, rows[i].wanted.ofDrives, rows[i].wanted.ofMovers;
    along[i] = product(rows[i], probe);
  }
  const Vec3 expected = W.fullPivLu().solve(wanted).transpose() * along;
  const ImpulseSpan::Wanted told = span_.wantedAlong(coordinates(probe));
  const Vec3 got(told.ofErrors, told.ofDrives, told.ofMovers);
  EXPECT_LT((got - expected).cwiseAbs().maxCoeff(), 1e-9 * (1 + expected.cwiseAbs().maxCoeff()));
}

}  // namespace
}  // namespace delassus::test
