#pragma once
/// What is fuzzed, and how. Each fuzz program is one target and one of two drivers:
/// target_test.cpp, a short run that needs no special compiler, or libfuzzer.cpp, which searches
/// for as long as it may.

#include <map>
#include <set>
#include <string>

#include "tests/fuzz/fuzz.h"

namespace delassus::test {

/// What became of one input.
struct Outcome {
  std::set<std::string> faults;        ///< broken laws, in words; empty if nothing is wrong
  std::map<std::string, long> counts;  ///< what happened, for the shares
};

struct Target {
  const char* name;
  Outcome (*ask)(const std::string& bytes);
  std::string (*seed)(Random& random);
  /// A few changes that are likelier to hurt than changes of single bytes.
  std::string (*mutated)(std::string bytes, Random& random);
  int usualRounds;  ///< in the short run
  /// Least counts of a run, each per round on average. A target that refuses everything tests
  /// nothing.
  std::map<std::string, double> least;
};

/// The target of this program.
extern const Target target;

}  // namespace delassus::test
