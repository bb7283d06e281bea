#include "delassus/release.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <stdexcept>

#include "tests/support/brute_force.h"
#include "tests/support/random_problems.h"

namespace delassus {
namespace {

double normW(const MatrixXd& W, const VectorXd& f) {
  return std::sqrt(std::max(0.0, f.dot(W * f)));
}

std::vector<bool> regionAt(const MatrixXd& W, const VectorXd& f) {
  return analyseRelease(W, -W * f).persisting;
}

MatrixXd diagonal(std::initializer_list<double> entries) {
  return Eigen::VectorXd::Map(entries.begin(), static_cast<int>(entries.size())).asDiagonal();
}

VectorXd vector(std::initializer_list<double> entries) {
  return Eigen::VectorXd::Map(entries.begin(), static_cast<int>(entries.size()));
}

// §4: let p be the difference of the free and the forced motion. Its kinetic energy is the form in
// the forced reactions.
TEST(Release, TheEnergyOfTheDifferenceIsTheFormInTheForcedReactions) {
  Random random(41);
  for (int k = 0; k < 500; ++k) {
    const int n = 1 + k % 6, freedoms = n + k % 5;
    const MatrixXd M = randomDelassus(freedoms, 100, random);
    const MatrixXd J = randomJacobian(n, freedoms, random);
    const MatrixXd product = J * M.llt().solve(J.transpose());
    const MatrixXd W = (product + product.transpose()) / 2;
    const VectorXd q = J * normalVector(freedoms, random);
    const VectorXd f = analyseRelease(W, q).forced;
    ASSERT_LT((W * f + q).norm(), 1e-9 * q.norm());  // the forced motion keeps all contacts
    const VectorXd p = -M.llt().solve(J.transpose() * f);
    const double roundOff = 1e-13 * W.norm() * f.squaredNorm();
    ASSERT_NEAR(p.dot(M * p), f.dot(W * f), roundOff);
  }
}

TEST(Release, SizesThatDoNotFitAreRefused) {
  EXPECT_THROW(analyseRelease(MatrixXd::Identity(1, 1), VectorXd::Ones(2)), std::invalid_argument);
  EXPECT_THROW(analyseRelease(MatrixXd::Ones(2, 3), VectorXd::Ones(2)), std::invalid_argument);
  EXPECT_EQ(analyseRelease(MatrixXd(0, 0), VectorXd()).status, Status::Solved);
}

TEST(Release, AnswersAgreeWithEnumeration) {
  Random random(42);
  for (int k = 0; k < 2000; ++k) {
    const int n = 1 + k % 8;
    const MatrixXd W = randomDelassus(n, std::pow(10.0, k % 6), random);
    const VectorXd q = -W * normalVector(n, random);
    const ReleaseAnalysis analysis = analyseRelease(W, q);
    const BruteForce truth = enumerateRegions(W, q);
    ASSERT_EQ(analysis.status, Status::Solved);
    ASSERT_LT(normW(W, analysis.r - truth.r), 1e-9);
    ASSERT_LT((analysis.u - truth.u).cwiseAbs().maxCoeff(), 1e-9);
    for (int i = 0; i < n; ++i) {
      ASSERT_EQ(analysis.persisting[i], bool(truth.persisting >> i & 1)) << "sample " << k;
      ASSERT_EQ(analysis.persisting[i] ? analysis.u[i] : analysis.r[i], 0);
    }
  }
}

// Theory §2: r_S = f_S + W_SS⁻¹ W_SR f_R and u_R = −(W/W_SS) f_R.
TEST(Release, ReducedReactionsFollowFromTheForcedOnes) {
  Random random(43);
  int tried = 0;
  for (int k = 0; k < 500; ++k) {
    const int n = 2 + k % 6;
    const MatrixXd W = randomDelassus(n, 100, random);
    const ReleaseAnalysis analysis = analyseRelease(W, normalVector(n, random));
    std::vector<int> S, R;
    for (int i = 0; i < n; ++i) (analysis.persisting[i] ? S : R).push_back(i);
    if (S.empty() || R.empty()) continue;
    ++tried;
    const VectorXd f = analysis.forced;
    const MatrixXd coupling = MatrixXd(W(S, S)).llt().solve(MatrixXd(W(S, R)));
    ASSERT_LT((analysis.r(S) - f(S) - coupling * f(R)).norm(), 1e-10);
    ASSERT_LT((analysis.u(R) + (W(R, R) - W(R, S) * coupling) * f(R)).norm(), 1e-10);
  }
  EXPECT_GT(tried, 400);
}

TEST(Release, NoForcedMotionNearerThanTheWallHasAnotherRegion) {
  Random random(44);
  for (int k = 0; k < 200; ++k) {
    const int n = 1 + k % 5;
    const MatrixXd W = randomDelassus(n, 100, random);
    const VectorXd f = normalVector(n, random);
    const ReleaseAnalysis analysis = analyseRelease(W, -W * f);
    for (int direction = 0; direction < 20; ++direction) {
      VectorXd step = normalVector(n, random);
      step *= 0.999 * analysis.distance / normW(W, step);
      ASSERT_EQ(regionAt(W, f + step), analysis.persisting) << "sample " << k;
    }
  }
}

// §11: leaving through a face always changes exactly the one contact that vanishes there.
TEST(Release, BehindAFaceExactlyOneContactChanges) {
  Random random(45);
  int faces = 0;
  for (int k = 0; k < 500; ++k) {
    const int n = 2 + k % 5;
    const MatrixXd W = randomDelassus(n, 100, random);
    const VectorXd f = normalVector(n, random);
    const ReleaseAnalysis analysis = analyseRelease(W, -W * f);
    ASSERT_EQ(analysis.wall, Wall::Face);  // almost surely
    ASSERT_EQ(analysis.changing.size(), 1u);
    const int contact = analysis.changing[0];

    // The shortest way to the wall goes along W⁻¹ times the gradient of r_i or u_i in q, which is
    // estimated by differences.
    const auto vanishing = [&](const VectorXd& forced) {
      const ReleaseAnalysis there = analyseRelease(W, -W * forced);
      return analysis.persisting[contact] ? there.r[contact] : there.u[contact];
    };
    const double h = 1e-3 * analysis.distance / std::sqrt(W.diagonal().maxCoeff());
    VectorXd gradient(n);
    for (int i = 0; i < n; ++i)
      gradient[i] = (vanishing(f + h * VectorXd::Unit(n, i)) - vanishing(f)) / h;
    const VectorXd toWall = W.llt().solve(gradient);
    const VectorXd foot = f - toWall * (vanishing(f) / gradient.dot(toWall));
    ASSERT_NEAR(normW(W, foot - f), analysis.distance, 1e-6 * analysis.distance);

    std::vector<bool> expected = analysis.persisting;
    expected[contact] = !expected[contact];
    const VectorXd behind = f + 1.0001 * (foot - f);
    if (analyseRelease(W, -W * behind).distance < 1e-6 * analysis.distance)
      continue;  // grazes an edge
    ASSERT_EQ(regionAt(W, behind), expected) << "sample " << k;
    ++faces;
  }
  EXPECT_GT(faces, 450);
}

// The regions of one contact are two half-lines, and zero lies between them.
TEST(Release, OneContact) {
  const ReleaseAnalysis kept = analyseRelease(diagonal({4}), vector({-8}));
  EXPECT_DOUBLE_EQ(kept.forced[0], 2);
  EXPECT_TRUE(kept.persisting[0]);
  EXPECT_DOUBLE_EQ(kept.distance, 4);  // √(f W f)
  EXPECT_EQ(kept.wall, Wall::Face);
  const ReleaseAnalysis released = analyseRelease(diagonal({4}), vector({8}));
  EXPECT_FALSE(released.persisting[0]);
  EXPECT_DOUBLE_EQ(released.distance, 4);
  EXPECT_EQ(released.changing, std::vector<int>{0});
}

// Independent contacts: the regions are the octants, and the number of reactions that vanish tells
// the kind of wall.
TEST(Release, FaceEdgeAndVertexOfTheOctant) {
  const MatrixXd W = MatrixXd::Identity(3, 3);
  const ReleaseAnalysis face = analyseRelease(W, -vector({0.5, 2, 3}));
  EXPECT_EQ(face.wall, Wall::Face);
  EXPECT_EQ(face.changing, std::vector<int>{0});
  EXPECT_DOUBLE_EQ(face.distance, 0.5);

  const ReleaseAnalysis edge = analyseRelease(W, -vector({0, 2, 0}));
  EXPECT_EQ(edge.wall, Wall::Edge);
  EXPECT_EQ(edge.changing, (std::vector<int>{0, 2}));
  EXPECT_EQ(edge.distance, 0);

  const ReleaseAnalysis vertex = analyseRelease(W, vector({0, 0, 0}));
  EXPECT_EQ(vertex.wall, Wall::Vertex);
  EXPECT_EQ(vertex.changing, (std::vector<int>{0, 1, 2}));

  // Two faces at the same distance are still two faces; the first one is named.
  const ReleaseAnalysis corner = analyseRelease(W, -vector({1, 1, 5}));
  EXPECT_EQ(corner.wall, Wall::Face);
  EXPECT_EQ(corner.changing, std::vector<int>{0});
}

// §10-§11: two reactions vanish at the same time. One contact may persist, the other may not: the
// edge does not tell.
TEST(Release, BehindAnEdgeTheRegionMustBeComputed) {
  MatrixXd W(2, 2);
  W << 1, -0.9, -0.9, 1;
  const ReleaseAnalysis edge = analyseRelease(W, vector({0, 0}));
  EXPECT_EQ(edge.wall, Wall::Vertex);  // of two contacts, both

  // The ways out of the vertex with both forced reactions negative: neither contact persists, or
  // the first, or the second.
  EXPECT_EQ(regionAt(W, vector({-1, -1})), (std::vector<bool>{false, false}));
  EXPECT_EQ(regionAt(W, vector({-0.1, -1})), (std::vector<bool>{true, false}));
  EXPECT_EQ(regionAt(W, vector({-1, -0.1})), (std::vector<bool>{false, true}));
}

// §9, ball in an angle: planes with inward normals n1, n2, c = n1·n2, W = [1 c; c 1]/m, F = −(f1 n1
// + f2 n2) per unit time.
TEST(Release, BallInAnAngleFollowsThePlane) {
  for (const double c : {-0.9999, -0.99, -0.5, 0.5, 0.9}) {
    const double half = std::acos(c) / 2;
    const Eigen::Vector2d n1(std::sin(half), std::cos(half)), n2(-std::sin(half), std::cos(half));
    MatrixXd W(2, 2);
    W << 1, c, c, 1;
    for (int degree = 0; degree < 360; ++degree) {
      const double angle = (degree + 0.5) * 3.14159265358979 / 180;
      const Eigen::Vector2d F(std::cos(angle), std::sin(angle));
      const std::vector<bool> persisting =
          analyseRelease(W, vector({n1.dot(F), n2.dot(F)})).persisting;

      // The ball moves by F projected on the wedge { v : n1·v ≥ 0, n2·v ≥ 0 }.
      const auto along = [&](const Eigen::Vector2d& n) {
        return Eigen::Vector2d(F - n.dot(F) * n);
      };
      const bool off = n1.dot(F) > 0 && n2.dot(F) > 0;
      const bool onFirst = !off && n1.dot(F) < 0 && n2.dot(along(n1)) > 0;
      const bool onSecond = !off && n2.dot(F) < 0 && n1.dot(along(n2)) > 0;
      const bool still = !off && !onFirst && !onSecond;
      EXPECT_EQ(persisting, (std::vector<bool>{onFirst || still, onSecond || still}))
          << "c = " << c << ", " << degree << " degrees";
    }
  }
}

// Theory §4, a rod on two supports that is pulled up at one end: supports wider apart than the
// radius of gyration lose that end.
TEST(Release, RodOnTwoSupports) {
  const double m = 1, I = 1.0 / 12;
  for (const double a : {0.2, 0.4}) {  // radius of gyration √(1/12) = 0.289
    const double A = 1 / m + a * a / I, B = 1 / m - a * a / I;
    MatrixXd W(2, 2);
    W << A, B, B, A;
    // An upward impulse 2 at the right support, against weight 1.
    const VectorXd q = vector({-1 + 2 * B, -1 + 2 * A});
    const ReleaseAnalysis analysis = analyseRelease(W, q);
    EXPECT_EQ(analysis.persisting, (std::vector<bool>{q[0] < 0, false}));
    EXPECT_EQ(q[0]<0, a> 0.289 || B < 0.5);
  }
}

TEST(Release, RedundantContactsHaveOneMotionAndAShare) {
  const MatrixXd J = boxStackJacobian(1);
  const MatrixXd W = J * J.transpose();
  const ReleaseAnalysis resting = analyseRelease(W, VectorXd::Constant(4, -1));
  EXPECT_EQ(resting.status, Status::Solved);
  EXPECT_EQ(resting.persisting, std::vector<bool>(4, true));
  EXPECT_LT((resting.r - VectorXd::Constant(4, 0.25)).norm(), 1e-8);
  EXPECT_LT((resting.forced - resting.r).norm(), 1e-8);
  EXPECT_TRUE(std::isfinite(resting.distance));
  EXPECT_GT(resting.distance, 0);
}

// Contacts that are released at rest have u equal to rounding, of either sign.
TEST(Release, NoWallIsNearerThanHere) {
  Random random(49);
  int here = 0;
  for (int k = 0; k < 200; ++k) {
    const int n = 2 + k % 4;
    const MatrixXd W = randomDelassus(n, 100, random);
    VectorXd r = normalVector(n, random).cwiseAbs();
    r[k % n] = 0;
    const ReleaseAnalysis analysis = analyseRelease(W, -W * r);
    EXPECT_LT(analysis.distance, 1e-6 * normW(W, r));
    here += analysis.distance == 0;
  }
  EXPECT_GT(here, 20);
}

TEST(Release, IncompatibleDemandsAreNamed) {
  MatrixXd W(2, 2);
  W << 1, -1, -1, 1;
  const ReleaseAnalysis jammed = analyseRelease(W, vector({-1, 0.5}));
  EXPECT_EQ(jammed.status, Status::Incompatible);
  EXPECT_EQ(jammed.blamed, (std::vector<int>{0, 1}));
}

TEST(Release, NoContactsNoWalls) {
  const ReleaseAnalysis nothing = analyseRelease(MatrixXd(0, 0), VectorXd(0));
  EXPECT_EQ(nothing.status, Status::Solved);
  EXPECT_TRUE(std::isinf(nothing.distance));
  EXPECT_TRUE(nothing.changing.empty());
}

}  // namespace
}  // namespace delassus
