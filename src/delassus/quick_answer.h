#pragma once

#include <vector>

#include "delassus/one_contact.h"
#include "delassus/options.h"
#include "delassus/residual.h"
#include "delassus/solution.h"
#include "delassus/split_problem.h"

namespace delassus {

/// The answer of a problem with explicit W that is small, or whose contacts feel little of each other: few sweeps, and few regions,
/// take less time than making a Solver, or taking W apart. What does not approach is not looked at.
class QuickAnswer {
 public:
  /// Keeps references. The problem must be fit (unfitParts), with entries, contacts and neither rows nor disks.
  QuickAnswer(const Problem& problem, const Options& options);

  /// The answer if the law is kept to within the tolerance: true.
  bool find(Solution& answer);

  /// Else: whether what was found keeps the law in a part.
  bool answers(const ProblemParts& parts, int part) const;
  /// What was found.
  const Solution& best() const { return best_; }
  /// Of a contact in it.
  Mode modeOf(int contact) const;
  double residualOf(int contact) const { return residuals_[contact]; }  ///< m/s

 private:
  /// What a contact that approaches, or has a region, needs.
  struct Approaching {
    OneContact block;
    double size;  ///< ‖W_aa‖, 1/kg
  };

  double toleranceFor(double demand) const;
  bool isReached() const { return best_.residual <= toleranceFor(demand_); }
  bool isSmall() const;
  Vec3 velocityOf(int contact) const;
  const Approaching& approaching(int contact);
  void sweep();
  bool isRocking(int contact, double normalVelocity) const;
  double sweepOnce();
  void measure();
  bool walk();

  const Problem& problem_;
  const Options& options_;
  double demand_;                         ///< the largest |q|
  bool firstGains_ = false;               ///< the first sweep took away most of it
  std::vector<int> place_;                ///< of each contact in approaching_; -1: not in it
  std::vector<Approaching> approaching_;  ///< in the order in which they were found
  Solution best_;
  std::vector<double> residuals_;  ///< of each contact, m/s
};

}  // namespace delassus
