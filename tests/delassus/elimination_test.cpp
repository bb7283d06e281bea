/// Gauss' elimination of any number of unknowns.
#include "delassus/elimination.h"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "tests/support/random_problems.h"

namespace delassus {
namespace {

using namespace delassus::test;

TEST(Elimination, AgreesWithALibraryAndKeepsItsFactor) {
  Random random(221);
  Elimination<Eigen::Dynamic> elimination;
  KeptMatrix K;
  int refused = 0;
  for (int k = 0; k < 200; ++k) {
    const int n = 1 + k % 45;
    const MatrixXd A = normalMatrix(n, n, random);
    K = A;
    if (!elimination.factorise(K)) {  // one in many draws is nearly singular
      ++refused;
      continue;
    }
    EXPECT_EQ(K, A);
    for (int side = 0; side < 2; ++side) {
      const VectorXd b = normalVector(n, random);
      VectorXd x = b;
      elimination.solve(x);
      EXPECT_LE((A * x - b).norm(), 1e-12 * A.norm() * x.norm());
      const VectorXd truth = A.partialPivLu().solve(b);
      EXPECT_LE((x - truth).norm(), 1e-14 * A.norm() * A.inverse().norm() * n * truth.norm());
    }
  }
  EXPECT_LT(refused, 200 / 20);
}

TEST(Elimination, TellsWhatIsSingular) {
  Random random(222);
  Elimination<Eigen::Dynamic> elimination;
  KeptMatrix K;
  for (int n = 2; n < 20; ++n) {
    const MatrixXd half = normalMatrix(n, n - 1, random);
    K = half * half.transpose();
    EXPECT_FALSE(elimination.factorise(K));
    K = MatrixXd::Zero(n, n);
    EXPECT_FALSE(elimination.factorise(K));
  }
}

}  // namespace
}  // namespace delassus
