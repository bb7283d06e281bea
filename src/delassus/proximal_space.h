#pragma once

#include <array>

#include "delassus/motion_space.h"
#include "delassus/residual.h"
#include "delassus/solution.h"

namespace delassus {

/// Shared by the proximal methods that take turns on one problem (ProximalWalk, ForcedHold,
/// Alternation, ReactionSteps): its motion space, the weights A = α W_aa that tie reactions to
/// their last values, and the Newton matrix I + J̃ᵀ G J̃ of a region. One method may use the factor
/// that another has left.
template <class Motion>
class ProximalSpace {
 public:
  /// `map` belongs to the problem; both must outlive the methods' work.
  void setProblem(const Problem& problem, const NaturalMap& map);
  const Problem& problem() const { return *problem_; }
  const NaturalMap& map() const { return *map_; }
  Motion& motion() { return motion_; }

  /// Lends the motion space to a method that factors in it on its own, and forgets the factor.
  Motion& lendMotion() {
    forgetFactor();
    return motion_;
  }
  /// A method that keeps the motion space, and factors in it on its own, calls this.
  void forgetFactor() { hasFactor_ = false; }
  /// Whether a region that is already factored is not factored again.
  void keepFactors(bool keep) { keepsFactors_ = keep; }

  /// l = 1/(compliance + α W_aa).
  void setWeights(double alpha);
  /// Factors the Newton matrix of G, unless the same G is factored already. False if it is
  /// singular.
  bool factorise(WorkDone& count);
  /// Writes −dr/du of a disk to `G`. If it slides along `direction`, its own part is across this
  /// direction, where the reaction may turn. Along it the governor moves the rim, if the disk still
  /// grows with the governor.
  void answerOfDisk(const Disk& disk, int k, Mode mode, const Vec2& direction, double turn,
                    bool grows, Stiffness& G) const;
  /// The error of r; also computes u.
  VelocityResidual measure(const VectorXd& r, VectorXd& u) { return map_->measure(r, felt, u); }

  std::size_t bytes() const {
    std::size_t sum = motion_.bytes() + G.bytes() + factored_.bytes();
    for (const VectorXd& vector : ofUnknowns) sum += bytesOf(vector);
    for (const VectorXd& vector : ofMotion) sum += bytesOf(vector);
    return sum + bytesOf(scale, compliance, l, felt);
  }

  VectorXd scale;       ///< mean diagonal of W_aa per unknown, 1/kg
  VectorXd compliance;  ///< 1/kg
  VectorXd l;           ///< the weights, kg
  Stiffness G;          ///< of a region, −dr/du
  VectorXd felt;        ///< J̃ᵀ of some reactions
  /// Work vectors, to which each method gives its own names; their contents do not outlive a call.
  /// The first have one entry per unknown, the second one per direction of the motion space.
  std::array<VectorXd, 7> ofUnknowns;
  std::array<VectorXd, 5> ofMotion;
  /// The ofUnknowns that ProximalWalk needs only where a step is cut short.
  static constexpr std::array<int, 2> seldomUsed = {5, 6};

 private:
  const Problem* problem_ = nullptr;
  const NaturalMap* map_ = nullptr;
  Motion motion_;
  Stiffness factored_;
  bool hasFactor_ = false;  ///< whether motion_ has the factor of factored_
  bool keepsFactors_ = true;
};

}  // namespace delassus
