#pragma once

#include <vector>

#include "delassus/acceleration.h"
#include "delassus/one_contact.h"
#include "delassus/problem.h"
#include "delassus/residual.h"

namespace delassus {

/// Block Gauss-Seidel: each contact, row and disk in turn is solved exactly with the others held
/// (algorithms §6.3).
class Sweeps {
 public:
  /// `map` belongs to the problem; both must outlive the sweeps.
  void setProblem(const Problem& problem, const NaturalMap& map);

  /// Makes `count` sweeps over all contacts and rows, each except the last followed by a step of
  /// the conjugate gradient. The reactions end in their cones and bounds.
  void sweep(int count, VectorXd& r);

  /// Makes `count` sweeps without acceleration. In body space only.
  void sweepPlainly(int count, VectorXd& r);

  /// As `sweep`, with Anderson's acceleration, which remembers `memory` steps. If r is what its
  /// last sweeps of this problem returned, it also goes on with the steps that they remember.
  void sweepOn(int count, int memory, VectorXd& r);

  std::size_t bytes() const {
    return bytesOf(blocks_, diskBlocks_, y_, yBefore_, swept_, coupling_, coupled_,
                   couplingBegin_) +
           conjugate_.bytes() + anderson_.bytes();
  }

 private:
  template <class Acceleration>
  void hurry(Acceleration& acceleration, int count, VectorXd& r);
  /// Updates y_ after an accelerated step has led to r.
  void follow(ConjugateGradient& acceleration, const VectorXd& r);
  void follow(Anderson& acceleration, const VectorXd& r);
  void sweepOnce(VectorXd& r);
  void sweepBodies(VectorXd& r);
  void sweepDisk(int k, VectorXd& r);
  /// The u of an unknown of a disk; `react` changes its reaction to `next`.
  double velocityOf(int unknown, const VectorXd& r) const;
  void react(int unknown, double next, VectorXd& r);
  void sweepEntries(VectorXd& r);
  void readEntries();
  bool readContactBlocks(int contact);
  void readContactRows(int contact, std::vector<int>& slot);
  /// The reaction of disk `k` with the others held; u is its velocity with r.
  Vec2 nextOnDisk(int k, const VectorXd& r, const Vec2& u) const;

  const Problem* problem_ = nullptr;
  std::vector<OneContact> blocks_;
  std::vector<Mat2> diskBlocks_;
  const VectorXd* diagonal_ = nullptr;  ///< of W
  VectorXd y_;                          ///< J̃ᵀ r, in body space
  VectorXd yBefore_;                    ///< y_ before the last sweep
  // Explicit W between different contacts, in blocks: those of a contact begin at
  // couplingBegin_[contact].
  std::vector<Mat3> coupling_;
  std::vector<int> coupled_;  ///< the other contact of each block
  std::vector<int> couplingBegin_;
  VectorXd swept_;       ///< reactions after the last sweep
  bool learnt_ = false;  ///< whether anderson_ knows how swept_ came about
  ConjugateGradient conjugate_;
  Anderson anderson_;
};

}  // namespace delassus
