// Two contacts press on one body: the installed core finds the region in which both persist.
#include <cstdlib>

#include "delassus/release.h"

int main() {
  Eigen::Matrix2d W;
  W << 2, 1, 1, 2;
  const Eigen::Vector2d q(-1, -1);
  const auto release = delassus::analyseRelease(W, q);
  const bool closed = (W * release.r + q).norm() < 1e-12;
  return closed ? EXIT_SUCCESS : EXIT_FAILURE;
}
