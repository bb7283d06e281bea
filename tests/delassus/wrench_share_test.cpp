#include "delassus/wrench_share.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <vector>

#include "delassus/cone.h"
#include "tests/support/random_problems.h"

namespace delassus {
namespace {

/// Four points under a body, at the corners of a tilted square, with reactions inside their cones.
struct Touched {
  std::vector<FeltPoint> points;
  std::vector<Vec3> reactions;

  explicit Touched(Random& random, double friction = 0.5) {
    const Mat3 turn = Eigen::Quaterniond(Eigen::Vector4d(normalVector(4, random)).normalized())
                          .toRotationMatrix();
    for (int k = 0; k < 4; ++k) {
      const Vec3 corner(-0.6, k & 1 ? 0.5 : -0.5, k & 2 ? 0.5 : -0.5);
      points.push_back({turn, turn * corner, friction});
      const double push = uniform(random, 1, 2), slip = 0.5 * friction * push;
      reactions.emplace_back(push, uniform(random, -slip, slip), uniform(random, -slip, slip));
    }
  }
  Vec6 wrench(const std::vector<Vec3>& r) const {
    Vec6 sum = Vec6::Zero();
    for (std::size_t i = 0; i < r.size(); ++i) {
      const Vec3 force = points[i].frame * r[i];
      sum.head<3>() += force;
      sum.tail<3>() += points[i].arm.cross(force);
    }
    return sum;
  }
  void share(const Vec6& wanted, std::vector<Vec3>& r) const {
    shareWrench(points.data(), static_cast<int>(points.size()), wanted, r.data());
  }
};

TEST(WrenchShare, ReactionsThatMakeTheWrenchStay) {
  Random random(1);
  for (int k = 0; k < 50; ++k) {
    const Touched body(random);
    std::vector<Vec3> r = body.reactions;
    body.share(body.wrench(r), r);
    for (int i = 0; i < 4; ++i) EXPECT_LT((r[i] - body.reactions[i]).norm(), 1e-12) << k;
  }
}

// No cone is left, so by the normal equations of least change the change is Jᵀ of one wrench.
TEST(WrenchShare, MakesTheWrenchByTheLeastChange) {
  Random random(2);
  for (int k = 0; k < 50; ++k) {
    const Touched body(random);
    std::vector<Vec3> r = body.reactions;
    const Vec6 wanted = body.wrench(r) + 0.02 * normalVector(6, random);
    body.share(wanted, r);
    EXPECT_LT((body.wrench(r) - wanted).norm(), 1e-8) << k;

    Eigen::Matrix<double, 12, 6> J;
    VectorXd change(12);
    for (int i = 0; i < 4; ++i) {
      change.segment<3>(3 * i) = r[i] - body.reactions[i];
      for (int a = 0; a < 3; ++a) {
        const Vec3 axis = body.points[i].frame.col(a);
        J.row(3 * i + a) << axis.transpose(), body.points[i].arm.cross(axis).transpose();
      }
    }
    const Vec6 wrench = J.colPivHouseholderQr().solve(change);
    EXPECT_LT((J * wrench - change).norm(), 1e-8) << k;
  }
}

TEST(WrenchShare, StaysInTheConesAndComesAsNearAsTheyAllow) {
  Random random(3);
  for (int k = 0; k < 50; ++k) {
    const Touched body(random);
    // From shares that are far off to a wrench that some reactions inside the cones make.
    std::vector<Vec3> r(4, Vec3::Zero());
    r[k % 4] = Vec3(8, 0, 0);
    const Vec6 wanted = body.wrench(body.reactions);
    const double before = (body.wrench(r) - wanted).norm();
    body.share(wanted, r);
    for (const Vec3& reaction : r)
      EXPECT_LT((projectOnCone(reaction, 0.5) - reaction).norm(), 1e-12) << k;
    EXPECT_LT((body.wrench(r) - wanted).norm(), 0.05 * before) << k;
  }
}

// Points that lie nearly on a line, as on the rim of a barrel, have hardly a moment about it.
TEST(WrenchShare, ForcesDoNotGrowForMomentsThatPointsHardlyMake) {
  Random random(6);
  for (int k = 0; k < 50; ++k) {
    Touched body(random);
    const Mat3 frame = body.points[0].frame;
    for (int i = 0; i < 4; ++i)
      body.points[i].arm = frame * Vec3(-0.6, 0.3 * i - 0.45, 0.001 * uniform(random, -1, 1));
    std::vector<Vec3> r = body.reactions;
    Vec6 wanted = body.wrench(r);
    wanted.tail<3>() += 0.1 * uniform(random, -1, 1) * wanted.norm() * frame.col(1);
    body.share(wanted, r);
    double sum = 0;
    for (const Vec3& reaction : r) sum += reaction.norm();
    EXPECT_LT(sum, 2 * wanted.norm()) << k;
  }
}

TEST(WrenchShare, NobodyPulls) {
  Random random(4);
  const Touched body(random);
  std::vector<Vec3> r = body.reactions;
  body.share(-body.wrench(r), r);
  for (const Vec3& reaction : r) EXPECT_EQ(reaction, Vec3::Zero());
}

TEST(WrenchShare, WithoutFrictionNormalsAlonePush) {
  Random random(5);
  const Touched body(random, 0);
  std::vector<Vec3> r(4, Vec3::Zero());
  body.share(body.wrench(body.reactions), r);
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(r[i].tail<2>().norm(), 0);
    EXPECT_GT(r[i][0], 0);
  }
}

}  // namespace
}  // namespace delassus
