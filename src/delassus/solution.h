#pragma once

#include <string>
#include <vector>

#include "delassus/active_set.h"
#include "delassus/bytes.h"
#include "delassus/residual.h"
#include "delassus/types.h"

namespace delassus {

/// From good to grave: the status of a problem is the gravest of its parts.
enum class Status : unsigned char {
  Solved,        ///< the natural residual is within the tolerance, or within rounding
  OutOfBudget,   ///< best answer found within the budget; see its residual
  Incompatible,  ///< no motion meets all demands: a compromise was taken; see `blamed`
  /// The problem holds numbers that are not finite or that overflow, or parts for which no law can
  /// be stated (μ < 0, crossed bounds): there are no reactions, and these parts are blamed.
  NonFinite,
};

/// solved, out_of_budget, incompatible or non_finite.
std::string toString(Status status);

/// The way by which the reactions were found, the cheapest first.
enum class Tier : unsigned char {
  Free,        ///< there are no reactions: nothing approaches
  Kept,        ///< the guess keeps the law
  ClosedForm,  ///< one contact or one row
  Pivoting,    ///< rows alone, explicit W
  Walk,        ///< sweeps, patches, regions
};

/// The work done for an answer. Work in a patch counts by its cost relative to the island's.
struct WorkDone {
  int regions = 0;  ///< visited by walks, without those at the ends of paths of compliance
  int factorisations = 0;
  int sweeps = 0;   ///< over the whole island; alternations and steps on few contacts count too
  int patches = 0;  ///< parts of the island that were solved apart, on the way

  void takeWork(const WorkDone& other) { *this = other; }
  void addWork(const WorkDone& other) {
    regions += other.regions;
    factorisations += other.factorisations;
    sweeps += other.sweeps;
    patches += other.patches;
  }
};

/// The reactions of one island, and how good they are.
struct Solution : WorkDone {
  VectorXd r;  ///< reactions, N·s
  VectorXd u;  ///< relative velocities u = W r + q, m/s
  ActiveSet activeSet;
  Status status = Status::Solved;
  Tier tier = Tier::Free;
  // In a search, errors stand in the place of residuals (NaturalMap::error).
  /// Of the guess, m/s; infinite without one. Where friction is above 2, its error.
  double startResidual = 0;
  /// Natural residual, largest over contacts, rows and disks, m/s; infinite where the problem has
  /// numbers for which no law can be stated.
  double residual = 0;
  double residualRms = 0;  ///< its root mean square, m/s
  /// First unknowns of the contacts and rows that keep the problem from being solved: those with
  /// incompatible demands or non-finite numbers; if out of budget, the one with the largest
  /// residual.
  std::vector<int> blamed;

  /// Starts with no reactions and u = q; residuals are not known yet, no work is done. Storage is
  /// kept.
  void start(const VectorXd& q) {
    r.setZero(q.size());
    u = q;
    startResidual = residual = residualRms = infinity;
    takeWork({});
    tier = Tier::Free;
    blamed.clear();
  }

  /// Takes the reactions of another solution, with their velocities and residuals.
  void takeReactions(const Solution& other) {
    r = other.r;
    u = other.u;
    residual = other.residual;
    residualRms = other.residualRms;
  }

  /// Takes these reactions and their velocities if their residual is smaller.
  void takeIfBetter(const VectorXd& candidate, const VectorXd& velocity,
                    const VelocityResidual& measured) {
    if (!(measured.max < residual)) return;
    r = candidate;
    u = velocity;
    setResidual(measured);
  }

  void setResidual(const VelocityResidual& measured) {
    residual = measured.max;
    residualRms = measured.rms;
  }

  std::size_t bytes() const {
    return bytesOf(r, u, activeSet.contacts, activeSet.rows, activeSet.disks, blamed);
  }
};

}  // namespace delassus
