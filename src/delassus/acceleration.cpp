#include "delassus/acceleration.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace delassus {
namespace {

void goOn(double beta, const VectorXd& g, VectorXd& direction, VectorXd& x) {
  if (beta > 0) {
    direction = beta * direction + (g - x);
    x += direction;
  } else {
    direction = g - x;
    x = g;
  }
}

}  // namespace

void ConjugateGradient::start(const VectorXd& weights) {
  weights_ = &weights;
  last_ = 0;
}

void ConjugateGradient::next(const VectorXd& g, VectorXd& x) {
  const double energy = (g - x).cwiseAbs2().dot(*weights_);
  beta_ = last_ > 0 && energy <= last_ ? energy / last_ : 0;
  last_ = energy;
  goOn(beta_, g, direction_, x);
}

void ConjugateGradient::nextImage(const VectorXd& imageOfG, VectorXd& image) {
  goOn(beta_, imageOfG, imageOfDirection_, image);
}

void Anderson::start(const VectorXd& weights, int memory) {
  weights_ = &weights;
  memory_ = std::min(memory, longest);
  // All memory is taken now, however few steps there will be.
  changeG_.resize(weights.size() * memory_);
  changeF_.resize(weights.size() * memory_);
  steps_ = oldest_ = 0;
  begun_ = false;
}

void Anderson::next(const VectorXd& g, VectorXd& x) {
  constexpr double growth = 2, regularisation = 1e-8, farthest = 1e3;
  using Small = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, longest, longest>;
  using SmallVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, longest, 1>;
  Columns changeG = columns(changeG_), changeF = columns(changeF_);
  x = g - x;  // f
  weighted_ = weights_->cwiseProduct(x);
  const double norm = std::sqrt(x.dot(weighted_));
  if (begun_ && norm > growth * last_) {
    steps_ = oldest_ = 0;
  } else if (begun_) {
    const int at = steps_ < memory_ ? steps_++ : oldest_;
    if (steps_ == memory_) oldest_ = (at + 1) % memory_;
    changeG.col(at) = g - g_;
    changeF.col(at) = x - f_;
    f_ = weights_->cwiseProduct(changeF.col(at));
    const SmallVector products = changeF.leftCols(steps_).transpose() * f_;
    products_.col(at).head(steps_) = products;
    products_.row(at).head(steps_) = products.transpose();
  }
  begun_ = true;
  last_ = norm;
  g_ = g;
  f_ = x;
  x = g;
  if (steps_ == 0) return;

  Small normal = products_.topLeftCorner(steps_, steps_);
  normal.diagonal().array() += regularisation * (normal.trace() + norm * norm);
  SmallVector gamma = changeF.leftCols(steps_).transpose() * weighted_;
  gamma = normal.ldlt().solve(gamma).eval();
  if (!gamma.allFinite()) return;
  x.noalias() -= changeG.leftCols(steps_) * gamma;
  // Reactions against demands that nothing can meet grow for ever; they are not to grow by powers.
  const double length = std::sqrt((x - g).dot(weights_->cwiseProduct(x - g)));
  if (length > farthest * norm) x = g + (farthest * norm / length) * (x - g);
}

std::size_t Anderson::bytes() const { return bytesOf(g_, f_, weighted_, changeG_, changeF_); }

}  // namespace delassus
