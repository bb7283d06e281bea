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

/// The request to a search, with its budgets.
struct Task {
  Options options;        ///< the budgets, of all that `best` counts
  double tolerance;       ///< natural residual to reach, m/s
  const VectorXd* guess;  ///< reactions of a last step; null: there are none
  int reserved = 0;       ///< regions that are kept for later ways
  /// Whether exactness gives way to time, by the budget with which Search::walk was called,
  /// whatever share of it this task has. Then no sweep is spent on ways that may gain nothing.
  bool isHurried = false;

  /// Regions left of those that may gain nothing (regionsInVain).
  int regionsLeft(const Solution& best, int most = std::numeric_limits<int>::max()) const {
    return std::max(0, std::min(most, options.regionsInVain() - reserved - best.regions));
  }
  int sweepsLeft(const Solution& best, int most = std::numeric_limits<int>::max()) const {
    return std::max(0, std::min(most, std::max(0, options.sweepBudget) - best.sweeps));
  }
  Task fromNothing() const {
    Task task = *this;
    task.guess = nullptr;
    return task;
  }
};

/// Searches for the reactions of one problem after the other: by sweeps, by patches, from region to
/// region. `best` is the best answer so far; only a better one takes its place. Storage is used
/// again.
class Search {
 public:
  Search() = default;

  /// Call it first. Keeps a pointer to `problem`, which must outlive the search for its reactions.
  /// The residual is to be brought within the tolerance, m/s.
  void setProblem(const Problem& problem, double tolerance) {
    problem_ = &problem;
    mostForEnergy_ = 0;
    map_.setProblem(problem);
    map_.aimAt(tolerance);
    patchWork_ = {};
  }
  const NaturalMap& map() const { return map_; }
  /// The threads that help from now on; null: none.
  void setHands(Hands* hands) {
    hands_ = hands;
    if (machines_) machines_->setHands(hands);
  }

  /// Takes `r`, moved into the cones and bounds, as the best answer if its residual is smaller.
  void offer(const VectorXd& r, Solution& best);

  /// Drops the reactions in `best` if no reactions at all are a better start. The two are compared
  /// as a whole: where few contacts came or went, a guess is far off only there, and what was
  /// learnt of all the others is worth more. With few sweeps, reactions of contacts alone are also
  /// dropped if they do work on the bodies, as those that stopped a blow do when they act again: a
  /// few sweeps would not take that back. (With joints they are kept. Without the reactions that
  /// carried them, ragdolls had up to twice the residual. They are also kept if they slid nowhere:
  /// holding all that touches, from them, is exact. From nothing it often fails.)
  void startBetter(const Options& options, Solution& best);

  /// For rows alone with an explicit W, the paper's own ground: regions of any W, symmetric or not.
  Outcome pivotRows(const Task& task, Solution& best);

  /// Searches by the cheapest way that leads to the tolerance, as far as the budgets go.
  Outcome walk(const Task& task, Solution& best);

  /// Brings reactions that already keep the law nearer to the tolerance, or leaves them as they
  /// are.
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
    void setHands(Hands* hands) {
      coloured.setHands(hands);
      condensed.setHands(hands);
      bodies.space.motion().setHands(hands);
    }
    std::size_t bytes() const {
      return sweeps.bytes() + coloured.bytes() + path.bytes() + condensed.bytes() + bodies.bytes() +
             factored.bytes();
    }
  };

  /// Made when first needed: a problem that a formula answers needs none.
  Machines& machines() {
    if (!machines_) {
      own_.reset(new Machines);  // make_unique would set all its dense matrices to zero first
      machines_ = own_.get();
      machines_->setHands(hands_);
    }
    return *machines_;
  }
  /// A search for patches of another one, or for its varied problems: it takes turns with that one.
  explicit Search(Machines& machines) : isInner_(true), machines_(&machines) {}

  // search.cpp: the order of ways.
  template <class Motion>
  Outcome walkTwice(Engines<Motion>& engines, const Task& task, Solution& best);
  template <class Motion>
  Outcome walkOnce(Engines<Motion>& engines, const Task& task, Solution& best);
  template <class Motion>
  Outcome walkFromHere(Engines<Motion>& engines, const Task& task, Solution& best);
  template <class Motion>
  Outcome walkCold(Engines<Motion>& engines, const Task& task, Solution& best);
  void setOutApart(const VectorXd* guess, Solution& best);
  Outcome comeBack(Outcome outcome, Solution& best) const;
  bool isHurried(const Options& options) const;
  bool hasNoWalk(const Task& task, const Solution& best) const;
  template <class Motion>
  void polishWith(Engines<Motion>& engines, const Task& task, Solution& best);
  /// Sets the machines to this problem again after another one: a patch, a varied problem, a proof,
  /// or a path, which leaves its own factor in their space.
  template <class Motion>
  void takeBack(Engines<Motion>& engines) {
    engines.space.setProblem(*problem_, map_);
  }

  // search_start_out.cpp: before the first walk.
  template <class Motion>
  Outcome startOut(Engines<Motion>& engines, const Task& task, Solution& best);
  bool condense(const Task& task, Solution& best);
  bool slidesNowhere(const VectorXd& r) const;
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
  bool sweepAndLearn(const Task& task, double tolerance, Solution& best,
                     int most = std::numeric_limits<int>::max());
  void sweepAll(const Task& task, double tolerance, Solution& best);
  void sweepWhileItGains(const Task& task, double tolerance, Solution& best);
  void settle(const Task& task, double tolerance, Solution& best);
  bool setSweeps(bool mayGoByColour);

  // search_patches.cpp.
  /// What is to be mended by patches.
  struct PatchesAbout {
    double above;         ///< parts whose residual is larger, m/s
    int rings;            ///< of neighbours around the bodies of these parts
    double largestShare;  ///< of the island in one patch
    double accuracy;      ///< residual of a patch that will do, m/s
  };
  void findPatches(const PatchesAbout& about, const Solution& unsettled);
  bool mendPatches(const Task& task, const PatchesAbout& about, Solution& unsettled,
                   Solution& best);
  bool isDisturbedInPlaces(const Task& task, const Solution& best);
  bool mendPlaces(const Task& task, Solution& best);

  // search_find_back.cpp: after a walk that has lost its way.
  template <class Motion>
  Outcome findBack(Engines<Motion>& engines, const Task& task, Solution& best);
  bool proveIncompatible(double tolerance, int regionBudget, Solution& best);
  void compromise(double tolerance, int regionBudget, Solution& best);
  template <class Motion>
  Outcome wander(Engines<Motion>& engines, const Task& task, Solution& best);
  Outcome outlast(const Task& task, Solution& best);
  Outcome sweepAndWalk(const Task& task);

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
  /// Least weight of a walk that begins with the best answer of quick ways, and of one that comes
  /// after other walks were lost.
  static constexpr double leastWeightAtFirst = 1e-2, leastWeightAfar = 1e-4;
  /// Numbers of regions: of the steps that finish; of a try; of a walk that is long enough for most
  /// cases; of one where nothing else is left; and the patience of one that goes on.
  static constexpr int fewRegions = 8, shortWalk = 16, fairWalk = 80, longWalk = 400,
                       patientWalk = 300;
  /// The proximal weight of a walk's first step from here, by how much is left to correct; at least
  /// `least`.
  double firstWeight(const Solution& from, double least) const;
  /// Whether a large heap has too much left to correct for a walk to be likely to end soon.
  bool isFar(const Solution& from) const;

  /// r·(q + u)/2, J: what reactions add to the energy of a motion, where nothing is asked for.
  double workOf(const Solution& s) const;
  /// Completes u and the residuals of a candidate r.
  void measure(Solution& candidate);
  /// Measures it, and takes it as the best answer if its residual is smaller. With few sweeps from
  /// nothing, also if it takes more energy and its residual is no more than some times that at the
  /// start: where bodies lie deep in each other, few sweeps may raise the residual, and yet are
  /// all that moves the bodies apart.
  void consider(Solution& candidate, Solution& best);
  /// Puts the answer of a walk back into cones and bounds, if rounding or a compromise has left
  /// them; only then measures it again.
  void allow(Solution& best);

  Hands* hands_ = nullptr;
  const Problem* problem_ = nullptr;
  NaturalMap map_;
  DenseNewton<Eigen::Dynamic> dense_;
  bool isInner_ = false;  ///< for patches or a varied problem, with the machines of another search
  double mostForEnergy_ = 0;  ///< up to this residual, m/s, `consider` judges by energy, too
  std::unique_ptr<Machines> own_;
  Machines* machines_ = nullptr;
  Solution trial_;      ///< a candidate
  Solution wandering_;  ///< the place of a way that may lead away from the best
  Solution apart_;      ///< the best of a search apart
  Solution held_;       ///< the result of a hold, in a hurry
  VectorXd felt_;
  FarkasProof proof_;

  Patches patches_;
  std::unique_ptr<Search> patchSearch_;  ///< for the problems of patches
  Problem patch_;
  VectorXd patchStart_;
  Solution patchAnswer_;
  /// Work in patches that makes no whole region or sweep yet.
  struct {
    double regions = 0, factorisations = 0, sweeps = 0;
  } patchWork_;
  VectorXd residuals_;

  std::unique_ptr<Search> variedSearch_;  ///< for compliant bodies, and less friction
  Problem varied_;
  VectorXd variedStart_;
  Solution variedAnswer_;
};

}  // namespace delassus
