#include "delassus/anderson.h"

#include <Eigen/Cholesky>

namespace delassus {

void Anderson::start(const VectorXd& weights) {
  rootWeights_ = weights.cwiseAbs().cwiseSqrt();
  // All memory is taken now, however few steps there will be.
  for (int j = 0; j < memory; ++j) {
    changeG_[j].resize(weights.size());
    changeF_[j].resize(weights.size());
  }
  steps_ = oldest_ = 0;
  begun_ = false;
}

void Anderson::next(const VectorXd& g, VectorXd& x) {
  constexpr double growth = 2, regularisation = 1e-8, farthest = 1e3;
  x = rootWeights_.cwiseProduct(g - x);  // f
  const double norm = x.norm();
  if (begun_ && norm > growth * last_) {
    steps_ = oldest_ = 0;
  } else if (begun_) {
    const int at = steps_ < memory ? steps_++ : oldest_;
    if (steps_ == memory) oldest_ = (at + 1) % memory;
    changeG_[at] = g - g_;
    changeF_[at] = x - f_;
    for (int j = 0; j < steps_; ++j)
      products_(at, j) = products_(j, at) = changeF_[at].dot(changeF_[j]);
  }
  begun_ = true;
  last_ = norm;
  g_ = g;
  f_ = x;
  x = g;
  if (steps_ == 0) return;

  using Small = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, memory, memory>;
  using SmallVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, memory, 1>;
  Small normal = products_.topLeftCorner(steps_, steps_);
  normal.diagonal().array() += regularisation * (normal.trace() + norm * norm);
  SmallVector gamma(steps_);
  for (int j = 0; j < steps_; ++j) gamma[j] = changeF_[j].dot(f_);
  gamma = normal.ldlt().solve(gamma).eval();
  if (!gamma.allFinite()) return;
  for (int j = 0; j < steps_; ++j) x -= gamma[j] * changeG_[j];
  // Reactions against demands that nothing can meet grow for ever; they are not to grow by powers.
  const double length = rootWeights_.cwiseProduct(x - g).norm();
  if (length > farthest * norm) x = g + (farthest * norm / length) * (x - g);
}

std::size_t Anderson::bytes() const {
  std::size_t sum = bytesOf(rootWeights_, g_, f_);
  for (int j = 0; j < memory; ++j) sum += bytesOf(changeG_[j], changeF_[j]);
  return sum;
}

}  // namespace delassus
