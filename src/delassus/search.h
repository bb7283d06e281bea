#pragma once

#include <algorithm>
#include <limits>
#include <memory>

#include "delassus/alternation.h"
#include "delassus/coloured_sweeps.h"
#include "delassus/compliance_path.h"
#include "delassus/condensed_newton.h"
#include "delassus/dense_newton.h"
#include "delassus/farkas.h"
#include "delassus/forced_hold.h"
#include "delassus/interior_point.h"
#include "delassus/options.h"
#include "delassus/outcome.h"
#include "delassus/patches.h"
#include "delassus/problem.h"
#include "delassus/proximal_walk.h"
#include "delassus/reaction_steps.h"
#include "delassus/residual.h"
#include "delassus/solution.h"
#include "delassus/sweeps.h"

namespace delassus {

class Hands;

/// What a search is asked for, and what it may cost.
struct Task {
  Options options;        ///< the budgets, of all that `best` counts
  double tolerance;       ///< natural residual to reach, m/s
  const VectorXd* guess;  ///< reactions of a last step; null: there are none
  int reserved = 0;       ///< regions for who comes later
  /// Exactness gives way to time: by what the user has allowed, whatever share of it this is. No
  /// sweep is to be lost on what may gain nothing.
  bool isHurried = false;

  /// Of those that may gain nothing.
  int regionsLeft(const Solution& best, int most = std::numeric_limits<int>::max()) const {
    return std::min(most, options.regionsInVain() - reserved - best.regions);
  }
  int sweepsLeft(const Solution& best, int most = std::numeric_limits<int>::max()) const {
    return std::min(most, options.sweepBudget - best.sweeps);
  }
  Task fromNothing() const {
    Task task = *this;
    task.guess = nullptr;
    return task;
  }
};

/// The search for the reactions of one problem after the other: by sweeps, by patches, from region
/// to region. What has been found so far is `best`; nothing is lost that was better. Storage is
/// used again.
class Search {
 public:
  Search() = default;

  /// Before all else. Keeps a pointer to `problem`, which must outlive the search for its
  /// reactions.
  void setProblem(const Problem& problem) {
    problem_ = &problem;
    map_.setProblem(problem);
  }
  const NaturalMap& map() const { return map_; }
  /// Who helps from now on; null: none.
  void setHands(Hands* hands) { hands_ = hands; }

  /// Takes `r`, moved into the cones and bounds, as the best answer if its residual is smaller.
  void offer(const VectorXd& r, Solution& best);

  /// Starts from no reactions at all if those in `best` are no start. They are compared as a whole:
  /// where few contacts came or went, a guess is far wrong only there, and what was learnt of all
  /// the others is worth more. Nor, with few sweeps, from those of contacts alone that do work on
  /// the bodies, as what stopped a blow does when it comes again: that is not taken back so soon.
  /// (Joints are worse off without what carried them: ragdolls had up to twice the residual.)
  void startBetter(const Options& options, Solution& best);

  /// Rows alone with an explicit W are the paper's own ground: regions of any W, symmetric or not.
  Outcome pivotRows(const Task& task, Solution& best);

  /// By the cheapest way that leads to the tolerance, as far as the budgets go.
  Outcome walk(const Task& task, Solution& best);

  /// Brings reactions that keep the law already towards the tolerance, or leaves them as they are.
  void polish(const Task& task, Solution& best);

  std::size_t bytes() const {
    return map_.bytes() + dense_.bytes() + (own_ ? own_->bytes() : 0) + trial_.bytes() +
           wandering_.bytes() + apart_.bytes() + held_.bytes() + felt_.bytes() + proof_.bytes() +
           patches_.bytes() + patch_.bytes() + patchAnswer_.bytes() +
           bytesOf(residuals_, patchStart_, variedStart_) + varied_.bytes() +
           variedAnswer_.bytes() + (patchSearch_ ? patchSearch_->bytes() : 0) +
           (variedSearch_ ? variedSearch_->bytes() : 0);
  }

 private:
  template <class Motion>
  struct Engines {
    ProximalSpace<Motion> space;
    ProximalWalk<Motion> walk{space};
    ForcedHold<Motion> forced{space};
    Alternation<Motion> alternation{space};
    ReactionSteps<Motion> reactions{space};
    InteriorPoint<Motion> interior;
    std::size_t bytes() const { return space.bytes() + interior.bytes(); }
  };
  struct Machines {
    Sweeps sweeps;
    ColouredSweeps coloured;
    CompliancePath path;
    CondensedNewton condensed;
    Engines<BodyMotion> bodies;
    Engines<FactoredMotion> factored;
    std::size_t bytes() const {
      return sweeps.bytes() + coloured.bytes() + path.bytes() + condensed.bytes() + bodies.bytes() +
             factored.bytes();
    }
  };

  /// Made when they are needed first: a problem that a formula answers needs none.
  Machines& machines() {
    if (!machines_) {
      own_.reset(new Machines);  // make_unique would set all its dense matrices to zero first
      machines_ = own_.get();
    }
    return *machines_;
  }
  /// For the patches of another search, or for what it varies: it takes turns with that one.
  explicit Search(Machines& machines) : isInner_(true), machines_(&machines) {}

  // search.cpp: the order of ways.
  template <class Motion>
  Outcome walkTwice(Engines<Motion>& engines, const Task& task, Solution& best);
  template <class Motion>
  Outcome walkOnce(Engines<Motion>& engines, const Task& task, Solution& best);
  template <class Motion>
  Outcome walkCold(Engines<Motion>& engines, const Task& task, Solution& best);
  void setOutApart(const VectorXd* guess, Solution& best);
  Outcome comeBack(Outcome outcome, Solution& best) const;
  bool isHurried(const Options& options) const;
  bool hasNoWalk(const Task& task, const Solution& best) const;
  template <class Motion>
  void polishWith(Engines<Motion>& engines, const Task& task, Solution& best);
  /// The machines stand at this problem again, whatever they stood at: a patch, a varied problem, a
  /// proof, or a path, which leaves its own factor in their space.
  template <class Motion>
  void takeBack(Engines<Motion>& engines) {
    engines.space.setProblem(*problem_, map_);
  }

  // search_start_out.cpp: before the first walk.
  template <class Motion>
  Outcome startOut(Engines<Motion>& engines, const Task& task, Solution& best);
  bool condense(const Task& task, Solution& best);
  bool mayHold(const Task& task, const Solution& best) const;
  template <class Motion>
  bool hold(Engines<Motion>& engines, const Task& task, Solution& best);
  template <class Motion>
  bool holdApart(Engines<Motion>& engines, const Task& task, Solution& best);
  template <class Motion>
  bool react(Engines<Motion>& engines, const Task& task, Solution& best);
  template <class Motion>
  bool alternate(Engines<Motion>& engines, const Task& task, Solution& best);
  template <class Motion>
  Outcome finish(Engines<Motion>& engines, const Task& task, Solution& best);

  // search_sweeps.cpp: each until `tolerance`, which may be finer than the task's.
  bool sweepAndLearn(const Task& task, double tolerance, Solution& best);
  void sweepAll(const Task& task, double tolerance, Solution& best);
  void sweepWhileItGains(const Task& task, double tolerance, Solution& best);
  void settle(const Task& task, double tolerance, Solution& best);
  bool setSweeps(bool mayGoByColour);
  void findPatches(double tolerance, double outstanding, const Solution& unsettled);
  bool mendPatches(const Task& task, double tolerance, double outstanding, Solution& unsettled,
                   Solution& best);

  // search_find_back.cpp: after a walk that has lost its way.
  template <class Motion>
  Outcome findBack(Engines<Motion>& engines, const Task& task, Solution& best);
  bool proveIncompatible(double tolerance, int regionBudget, Solution& best);
  void compromise(double tolerance, int regionBudget, Solution& best);
  template <class Motion>
  Outcome wander(Engines<Motion>& engines, const Task& task, Solution& best);
  Outcome outlast(const Task& task, Solution& best);

  // search_vary.cpp: answers to easier problems.
  void vary();
  Outcome answerVaried(const Task& task, Solution& best);
  double soften(const Task& task, Solution& best);
  Outcome addFriction(const Task& task, Solution& best);

  // search_path.cpp: the last resort.
  Outcome harden(const Task& task, Solution& best);
  bool setOutOnPath(const Task& task, int budget, Solution& best);

  /// Proximal weights where regions still change, and where the region is known.
  static constexpr double weightUnknown = 1e-1, weightKnown = 1e-6;
  /// The least of a walk that begins with the best answer of quick ways, and of one that others
  /// have not led to an end.
  static constexpr double leastWeightAtFirst = 1e-2, leastWeightAfar = 1e-4;
  /// Regions: of the steps that finish, of a try, of a walk that finds most ways there are, and of
  /// one where nothing else is left.
  static constexpr int fewRegions = 8, shortWalk = 16, fairWalk = 80, longWalk = 400;
  /// The proximal weight of a walk's first step from here, by what is left to correct; at least
  /// `least`.
  double firstWeight(const Solution& from, double least) const;
  /// Regions worth a walk from here: in large heaps few where too much is left to correct.
  int regionsFrom(const Solution& from, const Task& task, int most) const;

  /// Completes u and the residuals of a candidate r.
  void measure(Solution& candidate);
  /// Measures it, and takes it as the best answer if its residual is smaller.
  void consider(Solution& candidate, Solution& best);
  /// Puts the answer of a walk back into the cones and bounds that rounding, or a compromise, left.
  void allow(Solution& best);

  Hands* hands_ = nullptr;
  const Problem* problem_ = nullptr;
  NaturalMap map_;
  DenseNewton<Eigen::Dynamic> dense_;
  bool isInner_ = false;  ///< for patches or a varied problem, with the machines of another search
  std::unique_ptr<Machines> own_;
  Machines* machines_ = nullptr;
  Solution trial_;      ///< a candidate
  Solution wandering_;  ///< where a way is that may lead away from the best
  Solution apart_;      ///< the best of a way of its own
  Solution held_;       ///< what a hold has come to, in a hurry
  VectorXd felt_;
  FarkasProof proof_;

  Patches patches_;
  std::unique_ptr<Search> patchSearch_;  ///< for the problems of patches
  Problem patch_;
  VectorXd patchStart_;
  Solution patchAnswer_;
  VectorXd residuals_;

  std::unique_ptr<Search> variedSearch_;  ///< for compliant bodies, and less friction
  Problem varied_;
  VectorXd variedStart_;
  Solution variedAnswer_;
};

}  // namespace delassus
