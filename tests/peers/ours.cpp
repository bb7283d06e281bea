#include "tests/peers/ours.h"

#include <algorithm>
#include <memory>

#include "delassus/solver.h"

namespace delassus::peers {

namespace {

struct Work {
  Problem problem;
  Solution solution;
};

}  // namespace

Contestant ours(double tolerance) {
  Options options;
  // As the command does: one setting for all problems, with room between the solver's measure and those of the files.
  options.tolerance = std::min(options.tolerance, 0.01 * tolerance);
  return [options](const Problem& problem) {
    const auto work = std::make_shared<Work>(Work{problem, {}});
    const auto run = [work, options] {
      work->solution = solve(work->problem, options);
      return work->solution.status == Status::Solved;
    };
    return Attempt{run, [work] { return work->solution.r; }};
  };
}

}  // namespace delassus::peers
