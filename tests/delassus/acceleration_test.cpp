#include "delassus/acceleration.h"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "tests/support/random_problems.h"

namespace delassus {
namespace {

// The image stays L x whatever the iteration does, also where it begins anew.
TEST(ConjugateGradient, TakesALinearImageAlong) {
  Random random(72);
  constexpr int dimension = 6, imageDimension = 4, steps = 30;
  const MatrixXd L = MatrixXd::Random(imageDimension, dimension);
  const VectorXd weights = VectorXd::Constant(dimension, 2);
  ConjugateGradient accelerator;
  accelerator.start(weights);
  VectorXd x = normalVector(dimension, random);
  VectorXd image = L * x;
  int begunAnew = 0;
  for (int step = 0; step < steps; ++step) {
    const VectorXd g = x + uniform(random, 0.1, 1) * normalVector(dimension, random);
    accelerator.next(g, x);
    accelerator.nextImage(L * g, image);
    EXPECT_LT((image - L * x).norm(), 1e-12 * (1 + x.norm()));
    begunAnew += x == g;
  }
  EXPECT_GT(begunAnew, 5);
  EXPECT_LT(begunAnew, steps - 5);
}

// Affine maps with as many dimensions as steps are remembered: then Krylov's subspace is the whole
// space.
TEST(Anderson, SolvesSmallAffineMaps) {
  Random random(71);
  constexpr int dimension = 4;
  for (int k = 0; k < 50; ++k) {
    const MatrixXd B = MatrixXd::Random(dimension, dimension);
    const MatrixXd A = 0.9 / B.norm() * B;
    const VectorXd b = normalVector(dimension, random);
    const VectorXd exact = (MatrixXd::Identity(dimension, dimension) - A).fullPivLu().solve(b);
    const VectorXd weights = VectorXd::Constant(dimension, uniform(random, 0.1, 10));
    Anderson accelerator;
    accelerator.start(weights, dimension);
    VectorXd x = VectorXd::Zero(dimension), plain = x;
    for (int step = 0; step < 12; ++step) {
      accelerator.next(A * x + b, x);
      plain = A * plain + b;
    }
    EXPECT_LT((x - exact).norm(), 1e-6 * exact.norm()) << k;
    EXPECT_LT((x - exact).norm(), 0.1 * (plain - exact).norm() + 1e-12) << k;
  }
}

// Iterates may go on for ever, as reactions do against demands that nothing can meet. They are
// hurried, but not without bound.
TEST(Anderson, ADriftStaysADrift) {
  const VectorXd drift = VectorXd::Constant(3, 0.5), weights = VectorXd::Ones(3);
  Anderson accelerator;
  accelerator.start(weights, 4);
  VectorXd x = VectorXd::Zero(3);
  constexpr int steps = 100;
  for (int step = 0; step < steps; ++step) accelerator.next(x + drift, x);
  EXPECT_GE(x.norm(), 0.99 * steps * drift.norm());
  EXPECT_LE(x.norm(), 1e4 * steps * drift.norm());
}

}  // namespace
}  // namespace delassus
