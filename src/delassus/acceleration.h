#pragma once

#include <vector>

#include "delassus/bytes.h"
#include "delassus/types.h"

namespace delassus {

/// Two ways to accelerate a fixed-point iteration x ← g(x). Both give the next x once g = g(x) is
/// known. Their norm is ‖v‖² = Σ weight_i v_i², weights ≥ 0. `start` keeps a pointer to the
/// weights, which must outlive the steps.
///
/// Anderson's acceleration settles heaps of spheres ten times sooner. But if there are many more
/// contacts than motions of their bodies, it finds the answer that is nearest in residual, far away
/// along the self-stress. The conjugate gradient stays near the reactions that it starts from, and
/// a pile at rest stays at rest (pyramid_50: 2 regions a step, after Anderson's sweeps 119).

/// Nonlinear conjugate gradient of the iteration (Silcowitz-Hansen, Niebe, Erleben 2010; algorithms
/// §7.3):
///
///     p⁺ = f + β p,    x⁺ = x + p⁺,    f = g(x) − x,    β = ‖f‖² / ‖f_before‖²,
///     restarted (β = 0) where β is above 1
class ConjugateGradient {
 public:
  void start(const VectorXd& weights);
  void next(const VectorXd& g, VectorXd& x);
  /// Repeats the last `next` for a linear image of all vectors: from the images of g and of the
  /// last x it makes that of x. Call it after every step from the start on, or never.
  void nextImage(const VectorXd& imageOfG, VectorXd& image);
  std::size_t bytes() const { return bytesOf(direction_, imageOfDirection_); }

 private:
  const VectorXd* weights_ = nullptr;
  VectorXd direction_, imageOfDirection_;
  double last_ = 0;  ///< ‖f‖² of the last step
  double beta_ = 0;  ///< of the last step
};

/// Anderson's acceleration from its last steps (type II: Anderson 1965; Walker and Ni 2011):
///
///     x⁺ = g(x) − Σ γ_j Δg_j,    γ = argmin ‖f − Σ γ_j Δf_j‖,    f = g(x) − x
///
/// In a fixed region block Gauss-Seidel is affine, and this is a Krylov method for it. Once the
/// region changes, the past misleads: when f grows to more than `growth` times its length, all
/// steps are forgotten. (With growth = 2 heaps of spheres go round for ever. With 1 a few contacts
/// forget too much, and need regions where sweeps alone would have reached the answer.)
class Anderson {
 public:
  static constexpr int longest = 16;

  /// `memory`: number of remembered steps, at most `longest`.
  void start(const VectorXd& weights, int memory, double growth = 1);
  void next(const VectorXd& g, VectorXd& x);
  std::size_t bytes() const;

 private:
  using Columns = Eigen::Map<Eigen::MatrixXf>;
  Columns columns(std::vector<float>& changes) const {
    return {changes.data(), weights_->size(), memory_};
  }

  const VectorXd* weights_ = nullptr;
  VectorXd g_, f_;     ///< of the last step
  VectorXd weighted_;  ///< scratch
  // In single precision, since they only tell where to look next. This halves the memory traffic,
  // which takes most of the time.
  std::vector<float> changeG_, changeF_;              ///< one after the other, in units of unit_
  std::vector<float> rough_;                          ///< scratch
  double growth_ = 1;                                 ///< of ‖f‖, beyond which all is forgotten
  double unit_ = 1;                                   ///< ‖f‖ of the first step
  Eigen::Matrix<double, longest, longest> products_;  ///< of the changeF_
  double last_ = 0;                                   ///< ‖f‖ of the last step
  int memory_ = 0;
  int steps_ = 0;   ///< remembered steps
  int oldest_ = 0;  ///< the step that is forgotten next
  bool begun_ = false;
};

}  // namespace delassus
