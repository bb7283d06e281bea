#pragma once

#include <functional>
#include <string>
#include <vector>

namespace demos {

/// Limits of a piece of work in a process of its own.
struct Limits {
  double seconds;
  double bytes = 6e9;  ///< of address space beyond that of this process
};

enum class Ending {
  Done,
  TimeLimit,
  Crashed,  ///< also: out of memory
};
std::string toString(Ending ending);

struct ApartResult {
  Ending ending = Ending::Crashed;
  double seconds = 0;
  std::vector<double> numbers;  ///< what the work returned, if it is done
};

/// Runs `work` in a copy of this process and brings back the numbers it returns.
///
/// Work that takes too long is ended, and a crash harms only the copy: Bullet's pivoting solvers
/// can do both. Changes to the world stay in the copy. Throws Interrupted when the user asks to
/// stop.
ApartResult runApart(const std::function<std::vector<double>()>& work, const Limits& limits);

}  // namespace demos
