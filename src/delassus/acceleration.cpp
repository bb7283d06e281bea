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

void Anderson::start(const VectorXd& weights, int memory, double growth) {
  weights_ = &weights;
  memory_ = std::min(memory, longest);
  growth_ = growth;
  // All memory is taken now, even if there will be few steps.
  for (std::vector<float>* changes : {&changeG_, &changeF_})
    changes->resize(std::max<std::size_t>(weights.size() * memory_, changes->size()));
  rough_.resize(std::max<std::size_t>(weights.size(), rough_.size()));
  steps_ = oldest_ = 0;
  begun_ = false;
}

void Anderson::next(const VectorXd& g, VectorXd& x) {
  constexpr double regularisation = 1e-8, farthest = 1e3;
  using Small = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, longest, longest>;
  using SmallVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, longest, 1>;
  using SmallVectorf = Eigen::Matrix<float, Eigen::Dynamic, 1, 0, longest, 1>;
  Columns changeG = columns(changeG_), changeF = columns(changeF_);
  Eigen::Map<Eigen::VectorXf> rough(rough_.data(), g.size());
  x = g - x;  // f
  weighted_ = weights_->cwiseProduct(x);
  const double norm = std::sqrt(x.dot(weighted_));
  if (!begun_) unit_ = norm > 0 ? norm : 1;
  if (begun_ && norm > growth_ * last_) {
    steps_ = oldest_ = 0;
  } else if (begun_) {
    const int at = steps_ < memory_ ? steps_++ : oldest_;
    if (steps_ == memory_) oldest_ = (at + 1) % memory_;
    changeG.col(at) = ((g - g_) / unit_).cast<float>();
    f_ = (x - f_) / unit_;
    changeF.col(at) = f_.cast<float>();
    rough = weights_->cwiseProduct(f_).cast<float>();
    const SmallVectorf products = changeF.leftCols(steps_).transpose() * rough;
    products_.col(at).head(steps_) = products.cast<double>();
    products_.row(at).head(steps_) = products_.col(at).head(steps_).transpose();
  }
  begun_ = true;
  last_ = norm;
  g_ = g;
  f_ = x;
  x = g;
  if (steps_ == 0) return;

  Small normal = products_.topLeftCorner(steps_, steps_);
  const double size = norm / unit_;
  normal.diagonal().array() += regularisation * (normal.trace() + size * size);
  rough = (weighted_ / unit_).cast<float>();
  const SmallVectorf products = changeF.leftCols(steps_).transpose() * rough;
  const SmallVector gamma = normal.ldlt().solve(products.cast<double>());
  if (!gamma.allFinite()) return;
  rough.noalias() = changeG.leftCols(steps_) * gamma.cast<float>();
  x -= unit_ * rough.cast<double>();
  // Reactions against demands that nothing can meet grow for ever, but must not grow exponentially.
  const double length = std::sqrt((x - g).dot(weights_->cwiseProduct(x - g)));
  if (length > farthest * norm) x = g + (farthest * norm / length) * (x - g);
}

std::size_t Anderson::bytes() const {
  return bytesOf(g_, f_, weighted_, changeG_, changeF_, rough_);
}

}  // namespace delassus
