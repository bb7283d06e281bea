#include "tests/support/brute_force.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <vector>

namespace delassus {

BruteForce enumerateRegions(const MatrixXd& W, const VectorXd& q) {
  using Real = long double;
  using Vector = Eigen::Matrix<Real, Eigen::Dynamic, 1, 0, 16, 1>;
  using Matrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic, 0, 16, 16>;
  const int n = static_cast<int>(q.size());
  const Matrix exactW = W.cast<Real>();
  const Vector exactQ = q.cast<Real>();
  const Vector scale = exactW.diagonal().cwiseSqrt();

  BruteForce best;
  for (unsigned region = 0; region < (1u << n) && best.violation > 0; ++region) {
    Eigen::Matrix<int, Eigen::Dynamic, 1, 0, 16, 1> S(n);
    int s = 0;
    for (int i = 0; i < n; ++i)
      if (region >> i & 1) S[s++] = i;
    S.conservativeResize(s);

    Vector r = Vector::Zero(n);
    if (s > 0) {
      const Matrix block = exactW(S, S);
      r(S) = -block.llt().solve(Vector(exactQ(S)));
    }
    Vector u = exactW * r + exactQ;
    for (int k = 0; k < s; ++k) u[S[k]] = 0;
    const Real violation = std::max<Real>(
        0, std::max(-(r.cwiseProduct(scale)).minCoeff(), -(u.cwiseQuotient(scale)).minCoeff()));
    if (static_cast<double>(violation) < best.violation)
      best = {region, r.cast<double>(), u.cast<double>(), static_cast<double>(violation)};
  }
  return best;
}

VectorXd enumerateBoundedRegions(const MatrixXd& W, const VectorXd& q, const VectorXd& lower,
                                 const VectorXd& upper) {
  const int n = static_cast<int>(q.size());
  int regions = 1;
  for (int i = 0; i < n; ++i) regions *= 3;

  VectorXd best;
  double least = infinity;
  for (int region = 0; region < regions; ++region) {
    VectorXd r(n);
    std::vector<int> free;
    for (int i = 0, code = region; i < n; ++i, code /= 3) {
      r[i] = code % 3 == 0 ? lower[i] : code % 3 == 1 ? upper[i] : 0;
      if (code % 3 == 2) free.push_back(i);
    }
    if (!r.allFinite()) continue;
    if (!free.empty()) {
      const MatrixXd block = W(free, free);
      r(free) = -block.llt().solve(VectorXd((W * r + q)(free)));
    }
    const VectorXd u = W * r + q;
    const VectorXd projected = (r - u).cwiseMax(lower).cwiseMin(upper);
    const double violation = (r - projected).cwiseAbs().maxCoeff();
    if (violation < least) {
      least = violation;
      best = r;
    }
  }
  return best;
}

}  // namespace delassus
