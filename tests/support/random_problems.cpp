#include "tests/support/random_problems.h"

#include <Eigen/QR>
#include <cmath>

namespace delassus {

double uniform(Random& random, double from, double to) {
  return std::uniform_real_distribution<double>(from, to)(random);
}

VectorXd normalVector(int n, Random& random) {
  std::normal_distribution<double> normal;
  return VectorXd::NullaryExpr(n, [&] { return normal(random); });
}

MatrixXd normalMatrix(int rows, int columns, Random& random) {
  std::normal_distribution<double> normal;
  return MatrixXd::NullaryExpr(rows, columns, [&] { return normal(random); });
}

MatrixXd randomDelassus(int n, double condition, Random& random) {
  const MatrixXd Q = normalMatrix(n, n, random).householderQr().householderQ();
  VectorXd eigenvalues =
      VectorXd::NullaryExpr(n, [&] { return std::pow(condition, -uniform(random, 0, 1)); });
  eigenvalues[0] = 1;
  if (n > 1) eigenvalues[n - 1] = 1 / condition;
  const MatrixXd W = Q * eigenvalues.asDiagonal() * Q.transpose();
  return (W + W.transpose()) / 2;
}

MatrixXd randomJacobian(int n, int freedoms, Random& random) {
  return normalMatrix(n, freedoms, random);
}

MatrixXd boxStackJacobian(int boxes, double massRatio) {
  MatrixXd J = MatrixXd::Zero(4 * boxes, 3 * boxes);
  for (int box = 0; box < boxes; ++box) {
    const double mass = std::pow(massRatio, box);
    for (int corner = 0; corner < 4; ++corner) {
      const double x = corner & 1 ? 0.5 : -0.5, y = corner & 2 ? 0.5 : -0.5;
      // Rise, and rotation about the two horizontal axes (I = m/6), each divided by the square root
      // of its inertia.
      const Vec3 row(1, y * std::sqrt(6.0), -x * std::sqrt(6.0));
      J.block<1, 3>(4 * box + corner, 3 * box) = row.transpose() / std::sqrt(mass);
      if (box > 0)
        J.block<1, 3>(4 * box + corner, 3 * (box - 1)) =
            -row.transpose() / std::sqrt(mass / massRatio);
    }
  }
  return J;
}

void randomBounds(int n, Random& random, VectorXd& lower, VectorXd& upper) {
  constexpr double unbounded = infinity;
  lower.resize(n);
  upper.resize(n);
  for (int i = 0; i < n; ++i) {
    const double m = uniform(random, 0, 2);
    switch (static_cast<int>(uniform(random, 0, 5))) {
      case 0:
        lower[i] = 0, upper[i] = unbounded;
        break;
      case 1:
        lower[i] = -m, upper[i] = m;
        break;
      case 2:
        lower[i] = -unbounded, upper[i] = unbounded;
        break;
      case 3:
        lower[i] = -unbounded, upper[i] = 0;
        break;
      default:
        lower[i] = upper[i] = m;  // a row that has lost its say
    }
  }
}

}  // namespace delassus
