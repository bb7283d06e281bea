#include "delassus/release.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "delassus/pivoting.h"
#include "delassus/quiet_arithmetic.h"

namespace delassus {
namespace {

/// Eigenvalues, for a unit diagonal, at or below this part of the largest belong to redundant
/// contacts.
constexpr double redundantEigenvalue = 1e-10;

/// Distances below this part of ‖f‖ are round-off.
constexpr double zeroDistance = 1e-9;

/// (D W D)⁺ between scalings D that give a unit diagonal: the inverse if W is regular.
MatrixXd generalisedInverse(const MatrixXd& W) {
  if (W.rows() == 0) return W;
  const VectorXd D = (W.diagonal().array() > 0).select(W.diagonal().cwiseSqrt().cwiseInverse(), 0);
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(D.asDiagonal() * W * D.asDiagonal());
  const VectorXd& values = eigen.eigenvalues();
  const double smallest = redundantEigenvalue * values.maxCoeff();
  const VectorXd inverse = (values.array() > smallest).select(values.cwiseInverse(), 0);
  const MatrixXd V = D.asDiagonal() * eigen.eigenvectors();
  return V * inverse.asDiagonal() * V.transpose();
}

/// The walls of one kind, r_i = 0 or u_j = 0. `value` is the r_i or u_j of each contact. A change
/// of the forced motion by norm 1 changes it by at most √gram_ii.
struct Walls {
  std::vector<int> contacts;
  VectorXd value;
  MatrixXd gram;

  double distance(int i) const {
    return gram(i, i) > 0 ? std::max(0.0, value[i]) / std::sqrt(gram(i, i)) : infinity;
  }
};

/// Takes the nearest of these walls if it is nearer than those known so far.
void lookAtWalls(const Walls& walls, const Walls& others, double zero, ReleaseAnalysis& analysis) {
  int nearest = -1;
  for (int i = 0; i < static_cast<int>(walls.contacts.size()); ++i) {
    if (walls.distance(i) >= analysis.distance) continue;
    analysis.distance = walls.distance(i);
    nearest = i;
  }
  if (nearest < 0) return;

  // At the foot of the perpendicular the values of its own kind have changed along the Gram matrix,
  // those of the other kind not at all.
  Walls foot = walls;
  foot.value -= walls.gram.col(nearest) * (walls.value[nearest] / walls.gram(nearest, nearest));
  analysis.changing.clear();
  for (const Walls& kind : {foot, others})
    for (int i = 0; i < static_cast<int>(kind.contacts.size()); ++i)
      if (kind.distance(i) <= zero) analysis.changing.push_back(kind.contacts[i]);
}

}  // namespace

ReleaseAnalysis analyseRelease(const MatrixXd& W, const VectorXd& q) {
  const auto n = q.size();
  if (W.rows() != n || W.cols() != n)
    throw std::invalid_argument("analyseRelease: W is " + std::to_string(W.rows()) + " x " +
                                std::to_string(W.cols()) + ", and q has " + std::to_string(n) +
                                " entries: they must be n x n and n");
  const QuietArithmetic quiet;
  const VectorXd infinite = VectorXd::Constant(n, infinity);
  const PivotResult motion = pivot(W, q, VectorXd::Zero(n), infinite);

  ReleaseAnalysis analysis;
  analysis.forced = pivot(W, q, -infinite, infinite).r;
  analysis.r = motion.r;
  analysis.u = motion.u;
  analysis.status = motion.status;
  analysis.blamed = motion.blamed;
  analysis.persisting.resize(n);
  Walls kept, released;
  for (int i = 0; i < n; ++i) {
    analysis.persisting[i] = motion.rows[i] == RowState::Free;
    (analysis.persisting[i] ? kept : released).contacts.push_back(i);
  }
  if (motion.status == Status::Solved)
    for (const int i : kept.contacts) analysis.u[i] = 0;

  // W_SS⁻¹ and the Schur complement W/W_SS.
  const std::vector<int>&S = kept.contacts, &R = released.contacts;
  const MatrixXd coupling = W(S, R);
  kept.value = analysis.r(S);
  kept.gram = generalisedInverse(W(S, S));
  released.value = analysis.u(R);
  released.gram = W(R, R) - coupling.transpose() * kept.gram * coupling;
  for (int j = 0; j < static_cast<int>(R.size()); ++j)
    if (released.gram(j, j) <= redundantEigenvalue * W(R[j], R[j])) released.gram(j, j) = 0;

  const double size = std::sqrt(std::max(0.0, analysis.forced.dot(W * analysis.forced)));
  lookAtWalls(kept, released, zeroDistance * size, analysis);
  lookAtWalls(released, kept, zeroDistance * size, analysis);
  const auto vanishing = static_cast<Eigen::Index>(analysis.changing.size());
  if (vanishing > 1) analysis.wall = vanishing == n ? Wall::Vertex : Wall::Edge;
  std::sort(analysis.changing.begin(), analysis.changing.end());
  return analysis;
}

}  // namespace delassus
