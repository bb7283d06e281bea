#pragma once

#include <algorithm>
#include <cmath>

namespace delassus {

/// The weight α of a proximal method. It shrinks from one center to the next if the residual falls
/// slowly, and grows if no answer around a center is found. After a failure it shrinks in smaller
/// steps, and in larger ones again once two answers in a row came easily.
class ProximalWeight {
 public:
  ProximalWeight(double first, double least, double most)
      : value_(first), least_(least), most_(most) {}

  double value() const { return value_; }
  bool isLeast() const { return value_ <= least_; }
  bool isMost() const { return value_ >= most_; }

  /// Call it if no answer was found.
  void grow() {
    constexpr double growth = 10;
    value_ = std::min(most_, growth * value_);
    shrink_ = std::sqrt(shrink_);
    easyInARow_ = 0;
  }
  /// Call it if an answer was found, and tell how.
  void learn(bool easily) {
    easyInARow_ = easily ? easyInARow_ + 1 : 0;
    if (easyInARow_ > 1) shrink_ = std::max(boldest, shrink_ * std::sqrt(shrink_));
  }
  void shrink() { value_ = std::max(least_, shrink_ * value_); }

 private:
  static constexpr double boldest = 1e-2;
  double value_, least_, most_;
  double shrink_ = boldest;
  int easyInARow_ = 0;
};

}  // namespace delassus
