#include "tests/peers/ours.h"

#include <memory>

#include "delassus/solver.h"

namespace delassus::peers {

namespace {

struct Work {
  Problem problem;
  Solution solution;
};

}  // namespace

Contestant ours(double ownTolerance) {
  Options options;
  options.tolerance = ownTolerance;
  return [options](const Problem& problem) {
    const auto work = std::make_shared<Work>(Work{problem, {}});
    const auto run = [work, options] {
      work->solution = solve(work->problem, options);
      return work->solution.status == Status::Solved;
    };
    return Attempt{run, [work] { return work->solution.r; }};
  };
}

Contestant oursOn(const Problem& own, double ownTolerance) {
  return [own, with = ours(ownTolerance)](const Problem&) { return with(own); };
}

}  // namespace delassus::peers
