#pragma once
/// What random drivers share. Every round has its own seed: a failure names it, and it alone
/// reproduces the case.

#include <cmath>
#include <cstdlib>
#include <random>

#include "tests/support/random_problems.h"

namespace delassus::test {

/// Rounds of a run: `usual`, times the number in the environment variable DELASSUS_FUZZ where it is
/// set.
inline int fuzzRounds(int usual) {
  const char* factor = std::getenv("DELASSUS_FUZZ");
  return factor ? static_cast<int>(usual * std::strtod(factor, nullptr)) : usual;
}

/// True in a long run, where the shares are worth printing.
inline bool isLongFuzz() { return std::getenv("DELASSUS_FUZZ") != nullptr; }

/// Each round has another seed; DELASSUS_FUZZ_FROM shifts the numbers of the rounds.
inline Random fuzzRandom(int round) {
  const char* from = std::getenv("DELASSUS_FUZZ_FROM");
  return Random(1000003u * (from ? std::strtoull(from, nullptr, 10) : 0) + round);
}

inline int pick(Random& random, int from, int to) {
  return std::uniform_int_distribution<int>(from, to)(random);
}
inline bool chance(Random& random, double p) { return uniform(random, 0, 1) < p; }
/// 10^x, x uniform.
inline double decades(Random& random, double from, double to) {
  return std::pow(10.0, uniform(random, from, to));
}

}  // namespace delassus::test
