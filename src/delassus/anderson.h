#pragma once

#include <array>

#include "delassus/bytes.h"
#include "delassus/types.h"

namespace delassus {

/// Anderson's acceleration of a fixed-point iteration x ← g(x), from its last steps (type II: Anderson 1965; Walker and Ni 2011):
///
///     x⁺ = g(x) − Σ γ_j Δg_j,    γ = argmin ‖f − Σ γ_j Δf_j‖,    f = g(x) − x,   ‖v‖² = Σ |weight_i| v_i²
///
/// On a fixed region block Gauss-Seidel is affine, and this is a Krylov method for it. Where the region changes the past tells
/// wrong: when f doubles, it is forgotten.
class Anderson {
 public:
  /// No past. One weight an unknown.
  void start(const VectorXd& weights);

  /// Given g = g(x), x becomes the next point.
  void next(const VectorXd& g, VectorXd& x);

  std::size_t bytes() const;

 private:
  static constexpr int memory = 4;

  VectorXd rootWeights_;
  VectorXd g_, f_;  ///< of the last step, f weighted
  std::array<VectorXd, memory> changeG_, changeF_;
  Eigen::Matrix<double, memory, memory> products_;  ///< of the changeF_
  double last_ = 0;                                 ///< ‖f‖ of the last step
  int steps_ = 0;                                   ///< that are remembered
  int oldest_ = 0;                                  ///< the one that is forgotten next
  bool begun_ = false;
};

}  // namespace delassus
