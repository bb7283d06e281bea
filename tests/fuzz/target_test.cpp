/// The short run of a target: its seed, mutated in each round, and the inputs that once broke it.

#include "tests/fuzz/target.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace delassus::test {
namespace {

TEST(Fuzz, ChangedSeedsBreakNoLaw) {
  std::map<std::string, long> counts;
  const int rounds = fuzzRounds(target.usualRounds);
  for (int round = 0; round < rounds; ++round) {
    Random random = fuzzRandom(round);
    const std::string seed = target.seed(random);
    const Outcome outcome = target.ask(round == 0 ? seed : target.mutated(seed, random));
    for (const std::string& fault : outcome.faults)
      ADD_FAILURE() << "round " << round << ": " << fault;
    for (const auto& [what, count] : outcome.counts) counts[what] += count;
  }
  for (const auto& [what, least] : target.least)
    EXPECT_GE(double(counts[what]), least * rounds) << what;
  if (!isLongFuzz()) return;
  for (const auto& [what, count] : counts) std::printf("%s %ld\n", what.c_str(), count);
}

TEST(Fuzz, FoundCasesStayMended) {
  const std::filesystem::path folder = std::filesystem::path(DELASSUS_FUZZ_CASES) / target.name;
  if (!std::filesystem::is_directory(folder)) GTEST_SKIP() << "none was found yet";
  EXPECT_FALSE(std::filesystem::is_empty(folder));
  for (const auto& file : std::filesystem::directory_iterator(folder)) {
    std::ifstream in(file.path(), std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    for (const std::string& fault : target.ask(bytes).faults)
      ADD_FAILURE() << file.path().filename() << ": " << fault;
  }
}

}  // namespace
}  // namespace delassus::test
