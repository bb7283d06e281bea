#include "delassus/region.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "delassus/principal_cholesky.h"

namespace delassus {
namespace {

/// Cofactors are used only if every pivot of the scaled matrix exceeds this. At a condition number
/// of 1e10 they left a residual of 1e-2 |q|, the recursion 1e-6 |q| (algorithms 3.3).
constexpr double cofactorPivot = 1e-4;

/// For three contacts the error is ε over the determinant, which is the product of the pivots:
/// measured 2e-8 |q| with two pivots just above 1e-4, and 3e-14 |q| above this determinant.
constexpr double cofactorDeterminant = 1e-2;

/// Round-off of sums of q's, in units of the largest |q| (algorithms 3.6).
constexpr double signTolerance = 64 * std::numeric_limits<double>::epsilon();

using Rest = Eigen::Matrix<int, Eigen::Dynamic, 1, 0, smallRegionSize, 1>;

/// All indices below n but p.
Rest allBut(int p, int n) {
  Rest rest(n - 1);
  for (int i = 0, k = 0; i < n; ++i)
    if (i != p) rest[k++] = i;
  return rest;
}

/// False if it meets a dependent contact.
bool recurse(const SmallMatrix& W, const SmallVector& q, Recursion& answer) {
  const int n = static_cast<int>(q.size());
  answer.r.resize(n);
  if (n == 0) return true;

  // The largest remaining pivot first: Cholesky with diagonal pivoting in disguise.
  int p = 0;
  const double pivot = W.diagonal().maxCoeff(&p);
  if (pivot <= dependentPivot) return false;
  if (n == 1) {
    ++answer.regionsTried;
    answer.r[0] = oneContact(pivot, q[0]);
    return true;
  }

  // Contact p held: the others see the Schur complement.
  const Rest rest = allBut(p, n);
  const SmallVector column = W(rest, p);
  const SmallMatrix schur = W(rest, rest) - column * column.transpose() / pivot;
  const SmallVector reduced = q(rest) - column * (q[p] / pivot);
  Recursion others{{}, answer.regionsTried};
  if (!recurse(schur, reduced, others)) return false;

  double held = -(q[p] + column.dot(others.r)) / pivot;
  if (held < 0) {
    held = 0;
    if (!recurse(W(rest, rest), q(rest), others)) return false;
  }
  answer.regionsTried = others.regionsTried;
  answer.r[p] = held;
  for (int k = 0; k < n - 1; ++k) answer.r[rest[k]] = others.r[k];
  return true;
}

/// Solves two contacts of which one repeats or opposes the other (algorithms 3.5), unit diagonal.
Redundancy redundantPair(bool opposed, const SmallVector& q, SmallVector& r) {
  const double tolerance = signTolerance * q.cwiseAbs().maxCoeff();
  r.setZero(2);
  if (!opposed) {
    // The same constraint twice: the more demanding one decides; if they are equal, they share.
    if (std::abs(q[0] - q[1]) <= tolerance) {
      r.setConstant(std::max(0.0, -(q[0] + q[1]) / 4));
    } else {
      const int first = q[0] < q[1] ? 0 : 1;
      r[first] = std::max(0.0, -q[first]);
    }
    return Redundancy::Shared;
  }
  // Squeezed between two walls: u0 + u1 = q0 + q1 whatever the reactions. One wall pushes, the
  // other carries nothing.
  const double shortfall = std::max(0.0, -(q[0] + q[1]) / 2);
  const int pushing = q[0] < q[1] ? 0 : 1;
  r[pushing] = std::max(0.0, -q[pushing] - shortfall);
  return 2 * shortfall > tolerance ? Redundancy::Squeezed : Redundancy::Shared;
}

}  // namespace

double oneContact(double W, double q) { return std::max(0.0, -q / W); }

std::optional<Eigen::Vector2d> twoContacts(const Eigen::Matrix2d& W, const Eigen::Vector2d& q) {
  const double a = W(0, 0), c = W(0, 1), d = W(1, 1);
  const double D = a * d - c * c;
  if (!(D > cofactorPivot * a * d)) return std::nullopt;

  const double N0 = c * q[1] - d * q[0];  // D f0
  const double N1 = c * q[0] - a * q[1];  // D f1
  if (N0 > 0 && N1 > 0) return Eigen::Vector2d(N0, N1) / D;
  if (q[0] < 0 && N1 <= 0) return Eigen::Vector2d(-q[0] / a, 0);
  if (q[1] < 0 && N0 <= 0) return Eigen::Vector2d(0, -q[1] / d);
  return Eigen::Vector2d::Zero();
}

std::optional<Eigen::Vector3d> threeContacts(const Eigen::Matrix3d& W, const Eigen::Vector3d& q) {
  const auto minor = [&W](int i, int j) { return W(i, i) * W(j, j) - W(i, j) * W(i, j); };
  const auto scaled = [&](int i, int j) { return minor(i, j) / (W(i, i) * W(j, j)); };

  // K = adj(W), M = −K q = det(W) f.
  Eigen::Matrix3d K;
  K(0, 0) = minor(1, 2);
  K(1, 1) = minor(0, 2);
  K(2, 2) = minor(0, 1);
  K(0, 1) = K(1, 0) = W(0, 2) * W(1, 2) - W(0, 1) * W(2, 2);
  K(0, 2) = K(2, 0) = W(0, 1) * W(1, 2) - W(0, 2) * W(1, 1);
  K(1, 2) = K(2, 1) = W(0, 1) * W(0, 2) - W(1, 2) * W(0, 0);
  const Eigen::Vector3d M = -K * q;
  const double determinant = W.row(0).dot(K.row(0));

  // Scaled pivots of a Cholesky factorisation that starts with contact 0 and takes the larger of
  // the others next.
  const double second = std::max(scaled(0, 1), scaled(0, 2));
  const double scaledDeterminant = determinant / W.diagonal().prod();
  const bool pivotsSafe = second > cofactorPivot && scaledDeterminant > cofactorPivot * second;
  if (!pivotsSafe || !(scaledDeterminant > cofactorDeterminant)) return std::nullopt;

  if ((M.array() > 0).all()) return M / determinant;

  // One released: the face of the other two.
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    const double Ni = W(i, j) * q[j] - W(j, j) * q[i];
    const double Nj = W(i, j) * q[i] - W(i, i) * q[j];
    if (Ni > 0 && Nj > 0 && M[k] <= 0) {
      Eigen::Vector3d r = Eigen::Vector3d::Zero();
      r[i] = Ni / minor(i, j);
      r[j] = Nj / minor(i, j);
      return r;
    }
  }

  // Two released: the edge of the third.
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    if (q[i] < 0 && W(i, i) * q[j] - W(i, j) * q[i] >= 0 && W(i, i) * q[k] - W(i, k) * q[i] >= 0) {
      Eigen::Vector3d r = Eigen::Vector3d::Zero();
      r[i] = -q[i] / W(i, i);
      return r;
    }
  }
  if ((q.array() >= 0).all()) return Eigen::Vector3d::Zero();
  return std::nullopt;  // on an edge, where rounding failed every test
}

std::optional<Recursion> releaseRecursion(const SmallMatrix& W, const SmallVector& q) {
  Recursion answer;
  if (!recurse(W, q, answer)) return std::nullopt;
  return answer;
}

RegionAnswer solveRegion(const SmallMatrix& W, const SmallVector& q) {
  const int n = static_cast<int>(q.size());
  assert(W.rows() == n && W.cols() == n && "solveRegion: W and q must have the same size");
  RegionAnswer answer;
  if (n > 0 && !(W.diagonal().minCoeff() > 0)) {
    answer.redundancy = Redundancy::Dependent;
    return answer;
  }

  // Unit diagonal: reactions and velocities all become square roots of joules.
  const SmallVector scale = W.diagonal().cwiseSqrt();
  const SmallVector inverse = scale.cwiseInverse();
  SmallMatrix unit = inverse.asDiagonal() * W * inverse.asDiagonal();
  unit.diagonal().setOnes();
  const SmallVector free = q.cwiseProduct(inverse);

  SmallVector r;
  answer.regionsTried = 1;
  if (n == 1) {
    r = SmallVector::Constant(1, oneContact(1, free[0]));
  } else if (n == 2 && std::abs(1 - unit(0, 1) * unit(0, 1)) <= dependentPivot) {
    answer.redundancy = redundantPair(unit(0, 1) < 0, free, r);
  } else if (n == 2) {
    if (const auto closed = twoContacts(unit, free)) r = *closed;
  } else if (n == 3) {
    if (const auto closed = threeContacts(unit, free)) r = *closed;
  }
  if (r.size() != n) {
    if (const auto recursion = releaseRecursion(unit, free)) {
      r = recursion->r;
      answer.regionsTried = recursion->regionsTried;
    } else {
      answer.redundancy = Redundancy::Dependent;
      return answer;
    }
  }
  answer.r = r.cwiseProduct(inverse);
  answer.u = W * answer.r + q;
  return answer;
}

}  // namespace delassus
