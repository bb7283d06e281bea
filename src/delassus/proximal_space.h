#pragma once

#include <array>

#include "delassus/motion_space.h"
#include "delassus/residual.h"
#include "delassus/solution.h"

namespace delassus {

/// What the proximal methods have in common, which work on one problem in turn (ProximalWalk,
/// ForcedHold, Alternation, ReactionSteps): its motion space, the weights A = α W_aa with which
/// they tie reactions to where they were, and the Newton matrix I + J̃ᵀ G J̃ of a region, whose
/// factor one may find from the other.
template <class Motion>
class ProximalSpace {
 public:
  /// `map` is that of the problem; both must outlive the methods' work.
  void setProblem(const Problem& problem, const NaturalMap& map);
  const Problem& problem() const { return *problem_; }
  const NaturalMap& map() const { return *map_; }
  Motion& motion() { return motion_; }

  /// The motion space, for a method that factors in it on its own; what was factored here is
  /// forgotten.
  Motion& lendMotion() {
    forgetFactor();
    return motion_;
  }
  /// Who borrows the space for longer says so when he has factored in it again.
  void forgetFactor() { hasFactor_ = false; }
  /// Whether a region whose factor is there is not factored again.
  void keepFactors(bool keep) { keepsFactors_ = keep; }

  /// l = 1/(compliance + α W_aa).
  void setWeights(double alpha);
  /// Factors the Newton matrix of G, unless that very region is factored already. False where it is
  /// singular.
  bool factorise(WorkDone& count);
  /// −dr/du of a disk, into `G`: of one that slides along `direction`, its own part is across,
  /// where it may turn, and its governor moves the rim along, if the disk still grows with it.
  void answerOfDisk(const Disk& disk, int k, Mode mode, const Vec2& direction, double turn,
                    bool grows, Stiffness& G) const;
  /// The natural residual of r, whose u it works out.
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
  /// What the methods work in, each giving names to its own part: nothing outlives a call. By size:
  /// one entry for each unknown, and for each direction of the motion space.
  std::array<VectorXd, 7> ofUnknowns;
  std::array<VectorXd, 5> ofMotion;
  /// Of ofUnknowns, those of ProximalWalk that it needs only where a step is cut short.
  static constexpr std::array<int, 2> seldomUsed = {5, 6};

 private:
  const Problem* problem_ = nullptr;
  const NaturalMap* map_ = nullptr;
  Motion motion_;
  Stiffness factored_;
  bool hasFactor_ = false;  ///< that of factored_
  bool keepsFactors_ = true;
};

}  // namespace delassus
