#include "delassus/pivoting.h"

#include <Eigen/QR>
#include <algorithm>
#include <cassert>
#include <cmath>

#include "delassus/disjoint_sets.h"
#include "delassus/lemke.h"
#include "delassus/proximal_point.h"
#include "delassus/region.h"
#include "delassus/region_walk.h"

namespace delassus {
namespace {

/// Natural residual that counts as solved, relative to the largest |q|, both scaled to unit
/// diagonal of W. If it lies below the rounding floor ε‖r‖ of the reactions, the floor counts
/// instead.
constexpr double pivotTolerance = 1e-10;

/// Largest |W_ij − W_ji|, for a unit diagonal, that counts as round-off.
constexpr double roundOffAsymmetry = 1e-12;

/// Most unknowns for Lemke's dense tableau.
constexpr int largestTableau = 400;

/// Disagreement of redundant demands, relative to the largest q, that counts as round-off: of the
/// data, and of a shift that was computed from reactions of size shift/alpha.
constexpr double consistentData = 1e-12, consistentShift = 1e-9;

/// How often demands may be found incompatible and shifted: the first shift is exact up to
/// round-off.
constexpr int shiftBudget = 3;

/// Rows linked through W, in ascending order.
std::vector<std::vector<int>> linkedRows(const MatrixXd& W) {
  const int n = static_cast<int>(W.rows());
  DisjointSets linked(n);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < i; ++j)
      if (W(i, j) != 0 || W(j, i) != 0) linked.join(i, j);
  std::vector<std::vector<int>> groups;
  std::vector<int> groupOf(n);
  for (int i = 0; i < n; ++i) {
    const int root = linked.root(i);  // the first of its group
    if (root == i) {
      groupOf[i] = static_cast<int>(groups.size());
      groups.emplace_back();
    }
    groups[groupOf[root]].push_back(i);
  }
  return groups;
}

/// The problem in units that give W a unit diagonal or, where not all of that is positive, entries
/// up to 1; r = r~ / scale, u = scale u~.
struct ScaledRows {
  BoundedRows rows;
  VectorXd scale;
};

ScaledRows scaleRows(const MatrixXd& W, const VectorXd& q, const VectorXd& lower,
                     const VectorXd& upper) {
  ScaledRows scaled;
  const bool definiteDiagonal = W.diagonal().minCoeff() > 0;
  const double largest = W.cwiseAbs().maxCoeff();
  scaled.scale = definiteDiagonal
                     ? VectorXd(W.diagonal().cwiseSqrt())
                     : VectorXd::Constant(q.size(), largest > 0 ? std::sqrt(largest) : 1);
  const VectorXd inverse = scaled.scale.cwiseInverse();
  BoundedRows& rows = scaled.rows;
  rows.W = inverse.asDiagonal() * W * inverse.asDiagonal();
  rows.q = q.cwiseProduct(inverse);
  rows.lower = lower.cwiseProduct(scaled.scale);
  rows.upper = upper.cwiseProduct(scaled.scale);
  rows.symmetric =
      definiteDiagonal && (rows.W - rows.W.transpose()).cwiseAbs().maxCoeff() <= roundOffAsymmetry;
  return scaled;
}

bool unilateral(const VectorXd& lower, const VectorXd& upper) {
  return (lower.array() == 0).all() && (upper.array() == infinity).all();
}

/// Solves a row that no reaction moves: W_ii = 0. Its u = q_i alone decides its state; where a
/// reaction would have to make u = 0, a |q| up to `wanted` counts as 0.
PivotResult immovableRow(double q, double lower, double upper, double wanted) {
  PivotResult result;
  const bool atLower = q > 0 || lower == upper || (q == 0 && lower >= 0);
  const double bound = atLower ? lower : upper;
  const bool inBetween = (q == 0 && lower < 0 && upper > 0) || std::isinf(bound);
  const double rest = std::clamp(0.0, lower, upper);
  result.r = VectorXd::Constant(1, inBetween ? rest : bound);
  result.u = VectorXd::Constant(1, q);
  result.rows = {inBetween ? RowState::Free : atLower ? RowState::AtLower : RowState::AtUpper};
  if (inBetween && std::abs(q) > wanted) {
    result.status = Status::Incompatible;
    result.blamed = {0};
  }
  return result;
}

/// Solves a handful of contacts by the paper's regions. False if they are redundant beyond a pair.
bool pivotByRegion(const MatrixXd& W, const VectorXd& q, PivotResult& result) {
  const RegionAnswer answer = solveRegion(W, q);
  if (answer.redundancy == Redundancy::Dependent) return false;
  const int n = static_cast<int>(q.size());
  result.r = answer.r;
  result.u = answer.u;
  result.rows.resize(n);
  for (int i = 0; i < n; ++i)
    result.rows[i] = answer.persists(i) ? RowState::Free : RowState::AtLower;
  result.regions = result.factorisations = answer.regionsTried;
  if (answer.redundancy == Redundancy::Squeezed) {
    result.status = Status::Incompatible;
    result.blamed = {0, 1};
  }
  return true;
}

std::vector<RowState> statesAt(const BoundedRows& rows, const VectorXd& r) {
  const VectorXd u = rows.W * r + rows.q;
  std::vector<RowState> states(rows.size(), RowState::Free);
  for (int i = 0; i < rows.size(); ++i) {
    if (r[i] - u[i] <= rows.lower[i]) states[i] = RowState::AtLower;
    if (r[i] - u[i] >= rows.upper[i]) states[i] = RowState::AtUpper;
    states[i] = rows.possible(i, states[i]);
  }
  return states;
}

/// A compromise leaves the reactions of redundant rows open: takes those of least norm. Proximal
/// steps find these only as exactly as the demands have become compatible.
void takeLeastNorm(const BoundedRows& rows, RowAnswer& best) {
  constexpr size_t most = 400;
  constexpr double dependent = 1e-10;
  std::vector<int> free;
  for (int i = 0; i < rows.size(); ++i)
    if (best.states[i] == RowState::Free) free.push_back(i);
  if (!rows.symmetric || free.empty() || free.size() > most) return;
  Eigen::CompleteOrthogonalDecomposition<MatrixXd> W;
  W.setThreshold(dependent);
  W.compute(rows.W(free, free));
  RowAnswer least = best;
  least.r(free).setZero();
  const VectorXd demand = (rows.W * least.r + rows.q)(free);
  least.r(free) = -W.solve(demand);
  least.residual = rows.naturalResidual(least.r);
  const bool isAllowed = least.r == rows.clamp(least.r);
  // Both leave the rest by which the demands disagree, but share it out in another way.
  const double allowed = std::max(2 * best.residual, rows.roundOff(least.r));
  if (isAllowed && least.residual <= allowed) best = least;
}

/// Solves linked rows by pivoting: directly; by proximal steps if W is singular; by Lemke's method
/// if all else fails.
PivotResult pivotLinked(const MatrixXd& W, const VectorXd& q, const VectorXd& lower,
                        const VectorXd& upper, int regionBudget) {
  PivotResult result;
  ScaledRows scaled = scaleRows(W, q, lower, upper);
  BoundedRows& rows = scaled.rows;
  if (rows.symmetric && rows.size() <= smallRegionSize && unilateral(lower, upper) &&
      pivotByRegion(W, q, result))
    return result;

  const VectorXd rest = VectorXd::Zero(rows.size());
  const double largest = rows.q.cwiseAbs().maxCoeff();
  const double wanted = pivotTolerance * largest;
  RegionWalk walk(rows, rows.firstStates());
  RowAnswer best;
  best.r = rows.clamp(rest);
  best.states = statesAt(rows, best.r);
  best.residual = rows.naturalResidual(best.r);

  bool unique = false;
  if (walk.settle(rest, 0, regionBudget / 2) == RegionWalk::End::Settled) {
    best.offer(rows, walk);
    unique = best.residual <= wanted && !walk.redundantTies();
  }
  for (int k = 0; k < shiftBudget && !unique; ++k) {
    const double goodEnough = (k == 0 ? consistentData : consistentShift) * largest;
    ProximalAnswer proximal = proximalPoint(rows, walk, goodEnough, regionBudget);
    if (proximal.blamed.empty()) {
      if (proximal.best.residual < std::max(best.residual, wanted)) best = std::move(proximal.best);
      break;
    }
    result.status = Status::Incompatible;
    if (result.blamed.empty()) result.blamed = proximal.blamed;
    rows.q += proximal.shift;
    best.residual = rows.naturalResidual(best.r);
  }

  const auto left = [&] { return regionBudget - walk.regions() - result.regions; };
  const auto solved = [&] { return best.residual <= std::max(wanted, rows.roundOff(best.r)); };
  if (!solved() && rows.size() <= largestTableau) {
    if (const auto r = lemke(rows, left(), result.regions)) {
      const VectorXd clamped = rows.clamp(*r);
      const double residual = rows.naturalResidual(clamped);
      RegionWalk polish(rows, statesAt(rows, *r));
      if (residual < best.residual) best = {clamped, statesAt(rows, clamped), residual};
      if (polish.settle(rest, 0, left()) == RegionWalk::End::Settled) best.offer(rows, polish);
      result.regions += polish.regions();
      result.factorisations += polish.factorisations();
    }
  }
  if (!solved() && result.status == Status::Solved) result.status = Status::OutOfBudget;
  if (result.status == Status::Incompatible) takeLeastNorm(rows, best);

  result.r = best.r.cwiseQuotient(scaled.scale);
  result.u = W * result.r + q;
  result.rows = std::move(best.states);
  result.regions += walk.regions();
  result.factorisations += walk.factorisations();
  return result;
}

}  // namespace

PivotResult pivot(const MatrixXd& W, const VectorXd& q, const VectorXd& lower,
                  const VectorXd& upper, int regionBudget) {
  const int n = static_cast<int>(q.size());
  assert(W.rows() == n && W.cols() == n && "pivot: W must be square, of q's size");
  assert(lower.size() == n && upper.size() == n && "pivot: one pair of bounds a row");
  assert((lower.array() <= upper.array()).all() && "pivot: lower must not exceed upper");

  PivotResult result;
  result.r = VectorXd::Zero(n).cwiseMax(lower).cwiseMin(upper);
  result.u = q;
  result.rows.assign(n, RowState::Free);
  if (!W.allFinite() || !q.allFinite()) {
    result.u = VectorXd::Zero(n);
    result.status = Status::NonFinite;
    return result;
  }

  const int budget = std::max(0, regionBudget);
  const double wanted = n > 0 ? pivotTolerance * q.cwiseAbs().maxCoeff() : 0;
  int counted = 0;  // regions, but for small groups
  for (const std::vector<int>& group : linkedRows(W)) {
    const int first = group.front();
    const int left = std::max(0, budget - counted);
    const PivotResult part =
        group.size() == 1 && W(first, first) == 0
            ? immovableRow(q[first], lower[first], upper[first], wanted)
            : pivotLinked(W(group, group), q(group), lower(group), upper(group), left);
    result.r(group) = part.r;
    result.u(group) = part.u;
    for (size_t k = 0; k < group.size(); ++k) result.rows[group[k]] = part.rows[k];
    for (const int k : part.blamed) result.blamed.push_back(group[k]);
    result.status = std::max(result.status, part.status);
    result.regions += part.regions;
    const bool isSmall =
        static_cast<int>(group.size()) <= smallRegionSize && unilateral(lower(group), upper(group));
    if (!isSmall) counted += part.regions;
    result.factorisations += part.factorisations;
  }
  std::sort(result.blamed.begin(), result.blamed.end());
  if (!result.r.allFinite() || !result.u.allFinite()) {
    result.r = VectorXd::Zero(n).cwiseMax(lower).cwiseMin(upper);
    result.u = VectorXd::Zero(n);
    result.status = Status::NonFinite;
  }
  return result;
}

}  // namespace delassus
