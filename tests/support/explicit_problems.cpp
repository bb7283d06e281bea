#include "tests/support/explicit_problems.h"

namespace delassus::test {

DelassusMatrix matrix(const MatrixXd& W) {
  return DelassusMatrix(DelassusMatrix::Sparse(W.sparseView()));
}

Problem loneContacts(int n, Random& random) {
  Problem problem;
  MatrixXd W = MatrixXd::Zero(3 * n, 3 * n);
  problem.q.resize(3 * n);
  problem.friction.resize(n);
  for (int i = 0; i < n; ++i) {
    W.block<3, 3>(3 * i, 3 * i) = randomDelassus(3, 100, random);
    for (int k = 0; k < 3; ++k) problem.q[3 * i + k] = uniform(random, -1, 1);
    problem.friction[i] = i % 7 == 0 ? 0 : uniform(random, 0, 1.5);
  }
  problem.W = matrix(W);
  return problem;
}

}  // namespace delassus::test
