#include "delassus/wrench_share.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <array>
#include <cassert>

#include "delassus/cone.h"

namespace delassus {
namespace {

using Mat63 = Eigen::Matrix<double, 6, 3>;
using Mat6 = Eigen::Matrix<double, 6, 6>;

/// Jᵀ
Mat63 wrenchPerReaction(const FeltPoint& point) {
  Mat63 g = Mat63::Zero();
  for (int k = 0; k < (point.friction > 0 ? 3 : 1); ++k)
    g.col(k) << point.frame.col(k), point.arm.cross(point.frame.col(k));
  return g;
}

}  // namespace

void shareWrench(const FeltPoint* points, int count, const Vec6& wanted, Vec3* reactions) {
  assert(count <= mostFeltPoints);
  // A share of what S is in the mean: two points cannot make every wrench.
  constexpr double negligible = 1e-10;
  constexpr int mostRounds = 20;
  constexpr double still = 1e-8;  // (1e-4)², of the squares of the reactions

  Vec6 missing = wanted;
  Mat6 sum = Mat6::Zero();
  std::array<Mat63, mostFeltPoints> wrenches, answers;  // Jᵀ and S⁻¹ Jᵀ
  for (int i = 0; i < count; ++i) {
    wrenches[i] = wrenchPerReaction(points[i]);
    missing -= wrenches[i] * reactions[i];
    sum += wrenches[i] * wrenches[i].transpose();
  }
  sum.diagonal().array() += negligible * sum.trace();
  const Eigen::LDLT<Mat6> factor = sum.ldlt();
  const Vec6 share = factor.solve(missing);
  Vec6 left = share;  // S⁻¹ of what is missing
  for (int i = 0; i < count; ++i) answers[i] = factor.solve(wrenches[i]);

  // How far the reaction moves, squared.
  const auto add = [&](int i, const Vec6& demand) {
    Vec3& r = reactions[i];
    const Vec3 before = r;
    r = projectOnCone(r + wrenches[i].transpose() * demand, points[i].friction);
    const Vec3 change = r - before;
    left -= answers[i] * change;
    return change.squaredNorm();
  };
  for (int i = 0; i < count; ++i) add(i, share);
  double moved = 1, size = 0;
  for (int k = 0; k < mostRounds && moved > still * size; ++k) {
    moved = size = 0;
    for (int i = 0; i < count; ++i) {
      moved += add(i, left);
      size += reactions[i].squaredNorm();
    }
  }
}

}  // namespace delassus
