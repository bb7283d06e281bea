#pragma once

#include <vector>

#include "delassus/anderson.h"
#include "delassus/one_contact.h"
#include "delassus/problem.h"

namespace delassus {

/// Block Gauss-Seidel: each contact, row and disk in turn is solved exactly with the others held (algorithms §6.3).
class Sweeps {
 public:
  void setProblem(const Problem& problem);

  /// `count` sweeps over all contacts and rows, each but the last followed by Anderson's acceleration. The reactions end in
  /// their cones and bounds. What the last sweeps of this problem returned is gone on from with what they learnt.
  void sweep(const Problem& problem, int count, VectorXd& r);

  std::size_t bytes() const {
    return bytesOf(blocks_, diskBlocks_, diagonal_, y_, swept_) + accelerator_.bytes();
  }

 private:
  void sweepOnce(const Problem& problem, VectorXd& r);
  void sweepBodies(const Problem& problem, VectorXd& r);
  void sweepEntries(const Problem& problem, VectorXd& r);
  /// The reaction of disk `k` with the others held: u is what it sees with r.
  Vec2 nextOnDisk(const Problem& problem, int k, const VectorXd& r, const Vec2& u) const;

  /// The next reaction of a contact, the others held: u is what it sees with r.
  Vec3 nextOnCone(const Problem& problem, int contact, const Vec3& r, const Vec3& u) const;

  std::vector<OneContact> blocks_;
  std::vector<Mat2> diskBlocks_;
  VectorXd diagonal_;
  VectorXd y_;
  VectorXd swept_;  ///< by the last sweep
  Anderson accelerator_;
};

}  // namespace delassus
