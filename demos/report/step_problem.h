#pragma once

#include <vector>

#include "bullet_ext/gather.h"
#include "delassus/active_set.h"
#include "demos/process/apart.h"
#include "demos/report/captured_step.h"

namespace demos::report {

/// The velocities of the bodies of all groups of a step, in the order in which they were gathered.
using Motion = std::vector<delassus::Vec6>;

/// All groups of one step as a problem in the terms of the law.
class StepProblem {
 public:
  /// `cfm` is the global CFM of the scene.
  StepProblem(const CapturedStep& step, double cfm);

  int contacts() const { return contacts_; }
  int rows() const { return rows_; }
  int bodies() const { return int(freeMotion_.size()); }
  double cfm() const { return cfm_; }

  /// v_f: the motion under forces alone.
  const Motion& freeMotion() const { return freeMotion_; }
  Motion atRest() const { return Motion(freeMotion_.size(), delassus::Vec6::Zero()); }
  /// The present motion of the bodies.
  Motion currentMotion() const;
  /// |v − w|_M = √( (v − w)ᵀ M (v − w) ), √kg m/s; locked axes do not count.
  double distance(const Motion& v, const Motion& w) const;
  /// The modes of all contacts, read from the motion alone, since reactions of redundant contacts
  /// are not unique: open where u_n > ε, else slide where |u_t| > ε, else stick, ε = 1 mm/s. A
  /// contact without friction is open or slides.
  std::vector<delassus::Mode> modes(const Motion& motion) const;

  const std::vector<delassus::bullet::Group>& groups() const { return groups_; }

 private:
  std::vector<delassus::bullet::Group> groups_;
  Motion freeMotion_;
  std::vector<delassus::Vec6> rootMass_;  ///< √ of M's diagonal in principal axes
  std::vector<delassus::Mat3> principal_;
  double cfm_;
  int contacts_ = 0, rows_ = 0;
};

/// v*, the motion that takes place, and how well it is known.
struct Certified {
  Ending ending = Ending::Crashed;
  Motion motion;
  double residual = 0;   ///< natural residual, largest, m/s
  double unsolved = 0;   ///< islands that ended without status solved
  bool refined = false;  ///< certified in extended precision, see RefinedAnswer
  double agreement = 0;  ///< |v* − v°|_M / |v_f − v*|_M of a second solve v° from other reactions
  double size = 0;       ///< |v_f − v*|_M

  bool known() const { return ending == Ending::Done && size > 0; }
};

/// Solves to tolerance 1e-12 twice, from rest and from the stored impulses, and refines the answers
/// of islands of up to `mostRefined` unknowns. v* is the refined one of the two answers, or the one
/// with the smaller residual.
Certified certify(const StepProblem& problem, double secondsLimit, int mostRefined = 0);

}  // namespace demos::report
