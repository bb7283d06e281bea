#include "delassus/wrench_share.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cassert>

#include "delassus/cone.h"

namespace delassus {
namespace {

using Mat63 = Eigen::Matrix<double, 6, 3>;

/// Jᵀ
Mat63 wrenchPerReaction(const FeltPoint& point) {
  Mat63 g = Mat63::Zero();
  for (int k = 0; k < (point.friction > 0 ? 3 : 1); ++k)
    g.col(k) << point.frame.col(k), point.arm.cross(point.frame.col(k));
  return g;
}

/// The points, their common matrix S, and their reactions while these are shared out.
class Sharing {
 public:
  Sharing(const FeltPoint* points, int count, const Vec6& wanted, Vec3* reactions)
      : points_(points), count_(count), reactions_(reactions), missing_(wanted) {
    assert(count <= mostFeltPoints);
    for (int i = 0; i < count; ++i) {
      wrenches_[i] = wrenchPerReaction(points[i]);
      missing_ -= wrenches_[i] * reactions[i];
      sum_ += wrenches_[i] * wrenches_[i].transpose();
    }
  }

  /// Shares by the least change. False, and nothing is changed, if that leaves a cone.
  bool shareAtOnce() {
    constexpr double negligible = 1e-10;  // two points cannot make every wrench
    constexpr double rounding = 1e-12;    // of sliding reactions that do not change
    const Vec6 share = factor(negligible).solve(missing_);
    std::array<Vec3, mostFeltPoints> shared;
    for (int i = 0; i < count_; ++i) {
      const Vec3 r = reactions_[i] + wrenches_[i].transpose() * share;
      shared[i] = projectOnCone(r, points_[i].friction);
      if ((shared[i] - r).squaredNorm() > rounding * rounding * r.squaredNorm()) return false;
    }
    std::copy_n(shared.begin(), count_, reactions_);
    return true;
  }

  /// Shares in rounds over the points; each point takes what the others leave.
  void shareInRounds() {
    constexpr double soft = 1e-2;
    constexpr int mostRounds = 20;
    constexpr double still = 1e-8;  // (1e-4)², relative to the squares of the reactions
    const Eigen::LDLT<Mat6> metric = factor(soft);
    const Vec6 share = metric.solve(missing_);
    Vec6 left = share;  // S⁻¹ times the missing wrench
    std::array<Mat63, mostFeltPoints> answers;
    for (int i = 0; i < count_; ++i) answers[i] = metric.solve(wrenches_[i]);

    // Changes one reaction. Returns the square of its change.
    const auto add = [&](int i, const Vec6& demand) {
      Vec3& r = reactions_[i];
      const Vec3 before = r;
      r = projectOnCone(r + wrenches_[i].transpose() * demand, points_[i].friction);
      const Vec3 change = r - before;
      left -= answers[i] * change;
      return change.squaredNorm();
    };
    for (int i = 0; i < count_; ++i) add(i, share);
    double moved = 1, size = 0;
    for (int k = 0; k < mostRounds && moved > still * size; ++k) {
      moved = size = 0;
      for (int i = 0; i < count_; ++i) {
        moved += add(i, left);
        size += reactions_[i].squaredNorm();
      }
    }
  }

 private:
  /// Factors S = Σ J_iᵀ J_i with a share of its trace added to its diagonal.
  Eigen::LDLT<Mat6> factor(double share) const {
    Mat6 sum = sum_;
    sum.diagonal().array() += share * sum_.trace();
    return sum.ldlt();
  }

  const FeltPoint* points_;
  int count_;
  Vec3* reactions_;
  Vec6 missing_;  ///< wanted wrench less that of the first reactions
  Mat6 sum_ = Mat6::Zero();
  std::array<Mat63, mostFeltPoints> wrenches_;  ///< Jᵀ
};

}  // namespace

void shareWrench(const FeltPoint* points, int count, const Vec6& wanted, Vec3* reactions) {
  Sharing sharing(points, count, wanted, reactions);
  if (!sharing.shareAtOnce()) sharing.shareInRounds();
}

}  // namespace delassus
