#include "delassus/acceleration.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace delassus {

void ConjugateGradient::start(const VectorXd& weights) {
  weights_ = &weights;
  direction_.setZero(weights.size());
  last_ = 0;
}

void ConjugateGradient::next(const VectorXd& g, VectorXd& x) {
  const double energy = (g - x).cwiseAbs2().dot(*weights_);
  const double beta = last_ > 0 ? energy / last_ : 2;
  last_ = energy;
  if (beta > 1) {
    direction_ = g - x;
    x = g;
  } else {
    direction_ = beta * direction_ + (g - x);
    x += direction_;
  }
}

void Anderson::start(const VectorXd& weights, int memory) {
  weights_ = &weights;
  memory_ = std::min(memory, longest);
  // All memory is taken now, however few steps there will be.
  for (int j = 0; j < memory_; ++j) {
    changeG_[j].resize(weights.size());
    changeF_[j].resize(weights.size());
  }
  steps_ = oldest_ = 0;
  begun_ = false;
}

void Anderson::next(const VectorXd& g, VectorXd& x) {
  constexpr double growth = 2, regularisation = 1e-8, farthest = 1e3;
  x = g - x;  // f
  const double norm = std::sqrt(dot(x, x));
  if (begun_ && norm > growth * last_) {
    steps_ = oldest_ = 0;
  } else if (begun_) {
    const int at = steps_ < memory_ ? steps_++ : oldest_;
    if (steps_ == memory_) oldest_ = (at + 1) % memory_;
    changeG_[at] = g - g_;
    changeF_[at] = x - f_;
    for (int j = 0; j < steps_; ++j)
      products_(at, j) = products_(j, at) = dot(changeF_[at], changeF_[j]);
  }
  begun_ = true;
  last_ = norm;
  g_ = g;
  f_ = x;
  x = g;
  if (steps_ == 0) return;

  using Small = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, longest, longest>;
  using SmallVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, longest, 1>;
  Small normal = products_.topLeftCorner(steps_, steps_);
  normal.diagonal().array() += regularisation * (normal.trace() + norm * norm);
  SmallVector gamma(steps_);
  for (int j = 0; j < steps_; ++j) gamma[j] = dot(changeF_[j], f_);
  gamma = normal.ldlt().solve(gamma).eval();
  if (!gamma.allFinite()) return;
  for (int j = 0; j < steps_; ++j) x -= gamma[j] * changeG_[j];
  // Reactions against demands that nothing can meet grow for ever; they are not to grow by powers.
  const double length = std::sqrt((x - g).dot(weights_->cwiseProduct(x - g)));
  if (length > farthest * norm) x = g + (farthest * norm / length) * (x - g);
}

std::size_t Anderson::bytes() const {
  std::size_t sum = bytesOf(g_, f_);
  for (int j = 0; j < longest; ++j) sum += bytesOf(changeG_[j], changeF_[j]);
  return sum;
}

}  // namespace delassus
