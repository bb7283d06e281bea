#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "tests/peers/contestant.h"

namespace delassus::peers {

struct Conditions {
  double tolerance = 1e-8;   ///< which both published measures must reach
  double secondsLimit = 20;  ///< of a single solve, by the clock
};

/// The fastest of the peers that reach the tolerance.
struct BestPeer {
  std::string name;  ///< with its storage: "PROX, dense"
  double seconds;
};

/// The comparison of our solver and the peers, in turn, on one problem.
struct Comparison {
  std::string problem;
  int contacts = 0;
  std::optional<double> ours;    ///< seconds; none if we miss the tolerance
  std::optional<BestPeer> best;  ///< none if all of them miss it
  int peersThatReach = 0;
  /// The least value of the larger of rel and vel in any try, of us and of the best of the peers.
  double leftByUs = infinity, leftByPeers = infinity;

  bool faster() const { return ours && (!best || *ours < best->seconds); }
};

/// `with` makes our solver with a tolerance of its own.
Comparison compare(const Problem& problem,
                   const std::function<Contestant(double ownTolerance)>& with,
                   const std::vector<Peer>& peers, const Conditions& conditions);

}  // namespace delassus::peers
