#pragma once

#include <functional>
#include <string>
#include <vector>

#include "delassus/problem.h"

namespace delassus::peers {

/// One solve from rest, made ready: all it works on is a copy of its own.
struct Attempt {
  /// What is timed; once. False if the solver says that it did not reach what it was asked for.
  std::function<bool()> run;
  std::function<VectorXd()> reactions;
};

/// A solver with all its settings: makes ready what is to be timed.
using Contestant = std::function<Attempt(const Problem&)>;

/// A solver that stops on a measure of its own and takes W in several forms.
struct Peer {
  std::string name;
  /// Of W, in the order of what is likely to be fast.
  std::function<std::vector<std::string>(const Problem&)> storages;
  std::function<Contestant(const std::string& storage, double ownTolerance)> with;
};

}  // namespace delassus::peers
