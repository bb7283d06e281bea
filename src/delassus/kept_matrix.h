#pragma once

#include <Eigen/Core>

#include "delassus/kept_vector.h"

namespace delassus {

/// A row-major matrix that keeps its storage when its size changes, as KeptVector does. Rows begin
/// a multiple of `atATime` numbers apart: a loop along a row may read and write up to that
/// multiple, beyond the columns, where nothing else is stored.
class KeptMatrix
    : public Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>,
                        Eigen::Aligned16, Eigen::OuterStride<>> {
 public:
  using Index = Eigen::Index;
  using Map = Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>,
                         Eigen::Aligned16, Eigen::OuterStride<>>;
  static constexpr Index atATime = 4;

  KeptMatrix() : Map(nullptr, 0, 0, Eigen::OuterStride<>(0)) {}
  KeptMatrix(const KeptMatrix&) = delete;
  KeptMatrix& operator=(const KeptMatrix&) = delete;
  template <class Expression>
  KeptMatrix& operator=(const Eigen::EigenBase<Expression>& expression) {
    resize(expression.rows(), expression.cols());
    Map::operator=(expression.derived());
    return *this;
  }

  /// The entries are undefined afterwards.
  void resize(Index rows, Index columns) {
    const Index stride = (columns + atATime - 1) / atATime * atATime;
    storage_.resize(rows * stride);
    // Eigen's way to give a map another place.
    new (static_cast<Map*>(this)) Map(storage_.data(), rows, columns, Eigen::OuterStride<>(stride));
  }

  std::size_t bytes() const { return storage_.bytes(); }

 private:
  KeptVector storage_;
};

}  // namespace delassus
