#pragma once

#include <vector>

#include "demos/process/apart.h"
#include "tests/peers/contestant.h"

namespace delassus::peers {

/// One contestant on one problem, as the common judge saw it.
struct Measured {
  demos::Ending ending = demos::Ending::Crashed;
  double rel = 0, vel = 0;      ///< as `delassus solve` measures them
  bool satisfied = false;       ///< the solver says that it reached what it was asked for
  std::vector<double> seconds;  ///< processor time of single solves
  double secondsInAll = 0;      ///< clock time, with all that is around them

  bool meets(double tolerance) const;
};

double median(std::vector<double> numbers);

/// Solves in a process apart, where a crash or an endless loop does no other harm. Then solves
/// again and again from rest for `repeatFor` seconds.
Measured measure(const Problem& problem, const Contestant& contestant, double secondsLimit,
                 double repeatFor);

}  // namespace delassus::peers
