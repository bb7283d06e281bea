#pragma once
/// The natural residual in extended precision, from the problem alone. Certificates are checked
/// against it.

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "delassus/problem.h"

namespace delassus::test {

using Long = long double;
using LongVector = Eigen::Matrix<Long, Eigen::Dynamic, 1>;
using LongMatrix = Eigen::Matrix<Long, Eigen::Dynamic, Eigen::Dynamic>;

/// W with all its digits: the entries as given, or J̃ J̃ᵀ + diag(compliance), multiplied out in
/// extended precision. `sizes` is |W| or |J̃| |J̃|ᵀ + diag(compliance), to which round-off is in
/// proportion.
inline LongMatrix longDense(const Problem& problem, LongMatrix& sizes) {
  const int n = problem.size();
  if (!problem.W.inBodySpace()) {
    const LongMatrix W = MatrixXd(problem.W.entries()).cast<Long>();
    sizes = W.cwiseAbs();
    return W;
  }
  const BodySpace& space = problem.W.bodySpace();
  LongMatrix J = LongMatrix::Zero(n, 6 * space.bodies);
  for (int i = 0; i < problem.contacts(); ++i) {
    const ContactRows& rows = space.contacts[i];
    if (rows.a >= 0) J.block<3, 6>(3 * i, 6 * rows.a) += rows.Ja.cast<Long>();
    if (rows.b >= 0) J.block<3, 6>(3 * i, 6 * rows.b) += rows.Jb.cast<Long>();
  }
  for (int i = 0; i < problem.rows(); ++i) {
    const ScalarRow& row = space.rows[i];
    const int at = 3 * problem.contacts() + i;
    if (row.a >= 0) J.block<1, 6>(at, 6 * row.a) += row.Ja.cast<Long>();
    if (row.b >= 0) J.block<1, 6>(at, 6 * row.b) += row.Jb.cast<Long>();
  }
  LongMatrix W = J * J.transpose();
  W.diagonal() += space.compliance.cast<Long>();
  sizes = J.cwiseAbs() * J.cwiseAbs().transpose();
  sizes.diagonal() += space.compliance.cast<Long>();
  return W;
}

struct LongResidual {
  Long max = 0;  ///< natural residual of the reactions, m/s
  /// Round-off of a residual in double: ε (Σ |W_ij| |r_j| + |q_i| + |W_ii| |r_i|), times the number
  /// of terms of a sum, times 1 + μ for the corrected velocity.
  Long roundOff = 0;
  /// Largest distance of a reaction to its cone or bounds, relative to the largest reaction.
  Long outside = 0;
};

inline LongResidual longResidual(const Problem& problem, const VectorXd& r) {
  using Block = Eigen::Matrix<Long, 3, 3>;
  using Long3 = Eigen::Matrix<Long, 3, 1>;
  LongMatrix sizes;
  const LongMatrix W = longDense(problem, sizes);
  const LongVector x = r.cast<Long>();
  const LongVector u = W * x + problem.q.cast<Long>();
  const LongVector felt = sizes * x.cwiseAbs() + problem.q.cwiseAbs().cast<Long>();
  const int n = problem.contacts(), m = problem.rows();

  std::vector<Long> size;
  for (int i = 0; i < n; ++i) {
    const Block B = W.block<3, 3>(3 * i, 3 * i);
    const Long scale = B.cwiseAbs().maxCoeff();
    if (!(scale > 0)) {
      size.push_back(0);
      continue;
    }
    const Block S = B / scale;
    const Eigen::SelfAdjointEigenSolver<Block> eigen(S.transpose() * S, Eigen::EigenvaluesOnly);
    size.push_back(scale * std::sqrt(std::max<Long>(0, eigen.eigenvalues()[2])));
  }
  for (int i = 0; i < m; ++i) size.push_back(std::abs(W(3 * n + i, 3 * n + i)));
  const Long largest = size.empty() ? 0 : *std::max_element(size.begin(), size.end());
  for (Long& s : size)
    if (s < std::numeric_limits<double>::min()) s = largest > 0 ? largest : 1;

  LongResidual out;
  const Long largestReaction = std::max<Long>(x.cwiseAbs().maxCoeff(), 1e-300L);
  const Long epsilon = std::numeric_limits<double>::epsilon();
  const auto note = [&](Long F, Long s, int first, int unknowns, Long mu, Long distance, Long of) {
    out.max = std::max(out.max, F * s);
    const Long scale = felt.segment(first, unknowns).maxCoeff() + s * of;
    out.roundOff = std::max(out.roundOff, (1 + mu) * Long(4 + problem.size()) * epsilon * scale);
    out.outside = std::max(out.outside, distance / largestReaction);
  };
  const auto onCone = [](const Long3& z, Long mu) -> Long3 {
    const Long t = std::hypot(z[1], z[2]);
    if (mu * t <= -z[0]) return Long3::Zero();
    if (t <= mu * z[0]) return z;
    const Long normal = (z[0] + mu * t) / (1 + mu * mu);
    return {normal, mu * normal * z[1] / t, mu * normal * z[2] / t};
  };
  for (int i = 0; i < n; ++i) {
    const Long mu = problem.friction[i];
    const Long3 ri = x.segment<3>(3 * i);
    Long3 v = u.segment<3>(3 * i);
    v[0] += mu * std::hypot(v[1], v[2]);
    const Long3 F = ri - onCone(ri - v / size[i], mu);
    note(F.norm(), size[i], 3 * i, 3, mu, (ri - onCone(ri, mu)).norm(), ri.norm());
  }
  for (int i = 0; i < m; ++i) {
    const int at = 3 * n + i;
    const auto inBounds = [&](Long z) {
      return std::min<Long>(std::max<Long>(z, problem.lower[i]), problem.upper[i]);
    };
    note(std::abs(x[at] - inBounds(x[at] - u[at] / size[n + i])), size[n + i], at, 1, 0,
         std::abs(x[at] - inBounds(x[at])), std::abs(x[at]));
  }
  return out;
}

}  // namespace delassus::test
