#include "tests/peers/comparison.h"

#include <algorithm>
#include <cmath>

#include "tests/peers/measured.h"

namespace delassus::peers {

namespace {

using demos::Ending;

/// A solver with the settings with which it reached the tolerance.
struct Candidate {
  std::string name;
  Contestant contestant;
  double seconds;
};

/// How a solver fared.
struct Trial {
  std::optional<Candidate> candidate;
  double left = infinity;        ///< the least that a solve left of the larger of rel and vel
  Ending ending = Ending::Done;  ///< of the last solve
};

/// Finds the coarsest own tolerance with which a solver meets that of the comparison. A finer one
/// walks the same way, only further.
Trial findTolerance(const Problem& problem, const std::string& name,
                    const std::function<Contestant(double ownTolerance)>& with, double tolerance,
                    double secondsLimit) {
  constexpr int coarsest = 4, finest = 14;  // decades
  constexpr double glance = 2e-3;           // seconds of repeats: this only chooses who takes turns
  Trial trial;
  for (int decade = coarsest; decade <= finest; ++decade) {
    const Contestant contestant = with(std::pow(10.0, -decade));
    const Measured measured = measure(problem, contestant, secondsLimit, glance);
    trial.ending = measured.ending;
    if (measured.ending == Ending::Done)
      trial.left = std::min(trial.left, std::max(measured.rel, measured.vel));
    if (measured.meets(tolerance)) {
      trial.candidate = Candidate{name, contestant, median(measured.seconds)};
      break;
    }
    // What the solver cannot reach, or not in time, it cannot exceed with a finer tolerance.
    if (measured.ending != Ending::Done || !measured.satisfied) break;
  }
  return trial;
}

/// The solver in the storage in which it is fastest.
Trial findStorage(const Problem& problem, const Peer& peer, const Conditions& conditions) {
  Trial all;
  std::optional<Candidate>& best = all.candidate;
  for (const std::string& storage : peer.storages(problem)) {
    // From here on a storage is of use only if it is faster. A process apart takes some time of its
    // own.
    constexpr double overhead = 0.5;  // seconds
    const double secondsLimit = best ? std::min(conditions.secondsLimit, best->seconds + overhead)
                                     : conditions.secondsLimit;
    const Trial trial = findTolerance(
        problem, peer.name + ", " + storage,
        [&](double ownTolerance) { return peer.with(storage, ownTolerance); }, conditions.tolerance,
        secondsLimit);
    const std::optional<Candidate>& found = trial.candidate;
    all.left = std::min(all.left, trial.left);
    if (found && (!best || found->seconds < best->seconds)) best = found;
    // The solver loses its way in any storage, and not because a few seconds are missing.
    if (!best && trial.ending == Ending::TimeLimit) break;
  }
  return all;
}

/// The solvers that may turn out to be the fastest when they take turns with us.
std::vector<Candidate> chooseFinalists(std::vector<Candidate> candidates) {
  constexpr double nearlyAsFast = 1.5;
  constexpr std::size_t most = 3;
  std::sort(candidates.begin(), candidates.end(),
            [](const Candidate& a, const Candidate& b) { return a.seconds < b.seconds; });
  while (candidates.size() > most ||
         (!candidates.empty() &&
          candidates.back().seconds > nearlyAsFast * candidates.front().seconds))
    candidates.pop_back();
  return candidates;
}

/// Median seconds of each; none for one that missed the tolerance in any of its turns. They take
/// turns, so that other work on the machine hits them alike.
std::vector<std::optional<double>> takeTurns(const Problem& problem,
                                             const std::vector<Contestant>& contestants,
                                             const Conditions& conditions) {
  constexpr double turn = 0.02, enough = 2;  // seconds
  constexpr int mostRounds = 15;
  std::vector<std::vector<double>> seconds(contestants.size());
  std::vector<bool> missed(contestants.size());
  double spent = 0;
  for (int round = 0; round < mostRounds && spent < enough; ++round)
    for (std::size_t i = 0; i < contestants.size(); ++i) {
      if (missed[i]) continue;
      const Measured measured = measure(problem, contestants[i], conditions.secondsLimit, turn);
      missed[i] = !measured.meets(conditions.tolerance);
      spent += measured.secondsInAll;
      if (!missed[i]) seconds[i].push_back(median(measured.seconds));
    }
  std::vector<std::optional<double>> medians(contestants.size());
  for (std::size_t i = 0; i < contestants.size(); ++i)
    if (!missed[i]) medians[i] = median(seconds[i]);
  return medians;
}

}  // namespace

Comparison compare(const Problem& problem,
                   const std::function<Contestant(double ownTolerance)>& with,
                   const std::vector<Peer>& peers, const Conditions& conditions) {
  Comparison comparison;
  std::vector<Candidate> candidates;
  for (const Peer& peer : peers) {
    const Trial trial = findStorage(problem, peer, conditions);
    comparison.leftByPeers = std::min(comparison.leftByPeers, trial.left);
    if (trial.candidate) candidates.push_back(*trial.candidate);
  }
  comparison.problem = problem.name;
  comparison.contacts = problem.contacts();
  comparison.peersThatReach = int(candidates.size());

  const std::vector<Candidate> finalists = chooseFinalists(std::move(candidates));
  const Trial ownTrial =
      findTolerance(problem, "delassus", with, conditions.tolerance, conditions.secondsLimit);
  const std::optional<Candidate>& own = ownTrial.candidate;
  comparison.leftByUs = ownTrial.left;
  std::vector<Contestant> contestants;
  if (own) contestants.push_back(own->contestant);
  for (const Candidate& finalist : finalists) contestants.push_back(finalist.contestant);
  const auto medians = takeTurns(problem, contestants, conditions);

  if (own) comparison.ours = medians.front();
  for (std::size_t i = 0; i < finalists.size(); ++i) {
    const auto& seconds = medians[own ? i + 1 : i];
    if (seconds && (!comparison.best || *seconds < comparison.best->seconds))
      comparison.best = BestPeer{finalists[i].name, *seconds};
  }
  return comparison;
}

}  // namespace delassus::peers
