#pragma once

#include <functional>
#include <string>
#include <vector>

#include "delassus/problem.h"

namespace delassus::peers {

/// One solve from rest, made ready: it works only on a copy of its own.
struct Attempt {
  /// The part that is timed; call it once. False if the solver says that it missed its tolerance.
  std::function<bool()> run;
  std::function<VectorXd()> reactions;
};

/// A solver with all its settings. It makes ready what is to be timed.
using Contestant = std::function<Attempt(const Problem&)>;

/// A solver that stops on a measure of its own and takes W in several forms.
struct Peer {
  std::string name;
  /// Names of the storages of W, those likely to be fast first.
  std::function<std::vector<std::string>(const Problem&)> storages;
  std::function<Contestant(const std::string& storage, double ownTolerance)> with;
};

}  // namespace delassus::peers
