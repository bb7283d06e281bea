/// Damaged problem texts: each is refused in one line that names its place, or read as a problem that can be written,
/// read again and solved.

#include <cstdio>
#include <map>

#include "delassus/solver.h"
#include "tests/fuzz/fuzz.h"
#include "tests/support/problem_samples.h"

namespace delassus::testing {
namespace {

std::string anyWord(Random& random) {
  static const char* const words[] = {"nan",
                                      "inf",
                                      "-inf",
                                      "1e308",
                                      "-1e308",
                                      "1e-320",
                                      "1e400",
                                      "0x10",
                                      "-0",
                                      "2147483647",
                                      "-1",
                                      "999999999999999999999",
                                      "",
                                      "#",
                                      "# x",
                                      "end",
                                      "W",
                                      "M",
                                      "q",
                                      "mu",
                                      "bounds",
                                      "0.5.5",
                                      "1,5",
                                      "+1",
                                      "1e",
                                      "\xff\xfe",
                                      "delassus-problem v1",
                                      "lcp v1",
                                      "contacts 400000000"};
  return words[pick(random, 0, int(std::size(words)) - 1)];
}

/// Splits at every blank and line end, which stay at the end of their word.
std::vector<std::string> wordsOf(const std::string& text) {
  std::vector<std::string> words(1);
  for (const char c : text) {
    words.back() += c;
    if (c == ' ' || c == '\n') words.emplace_back();
  }
  return words;
}

std::string mutated(std::string text, Random& random) {
  for (int change = pick(random, 1, 3); change > 0 && !text.empty(); --change) {
    const auto at = std::size_t(pick(random, 0, int(text.size()) - 1));
    std::vector<std::string> words = wordsOf(text);
    std::string& word = words[std::size_t(pick(random, 0, int(words.size()) - 1))];
    std::string& other = words[std::size_t(pick(random, 0, int(words.size()) - 1))];
    const char end = word.empty() ? '\n' : word.back();
    switch (pick(random, 0, 7)) {
      case 0:
        text[at] = char(pick(random, 0, 255));
        continue;
      case 1:
        text.resize(at);
        continue;
      case 2:
        text.insert(at, text.substr(std::size_t(pick(random, 0, int(text.size()) - 1)), 40));
        continue;
      case 3:
        word = anyWord(random) + end;
        break;
      case 4:
        word.clear();
        break;
      case 5:
        std::swap(word, other);
        break;
      case 6:
        word += other;
        break;
      case 7:
        word = std::to_string(uniform(random, -1, 1) * decades(random, -300, 300)) + end;
        break;
    }
    text.clear();
    for (const std::string& w : words) text += w;
  }
  return text;
}

TEST(ProblemTextFuzz, IsRefusedInOneLineOrReadAndSolved) {
  std::map<std::string, int> shares;
  const int rounds = fuzzRounds(4000);
  for (int round = 0; round < rounds; ++round) {
    Random random = fuzzRandom(round);
    const std::string text =
        mutated(chance(random, 0.5) ? test::contactText : test::rowText, random);
    SCOPED_TRACE(::testing::Message() << "round " << round << ":\n" << text);
    try {
      const Problem problem = test::fromText(text);
      test::expectSame(problem, test::fromText(test::toText(problem)));
      const Solution solution = solve(problem);
      EXPECT_EQ(solution.r.size(), problem.size());
      EXPECT_TRUE(solution.r.allFinite());
      ++shares["read, " + toString(solution.status)];
    } catch (const ProblemTextError& error) {
      const std::string what = error.what();
      EXPECT_EQ(what.rfind("text:", 0), 0u) << what;
      EXPECT_EQ(what.find('\n'), std::string::npos) << what;
      EXPECT_LT(what.size(), 400u) << what;
      ++shares["refused"];
    }
    if (::testing::Test::HasFailure()) return;
  }
  EXPECT_GT(shares["refused"], rounds / 4);
  EXPECT_GT(shares["read, solved"], rounds / 100) << "not all are refused";
  if (!isLongFuzz()) return;
  for (const auto& [what, count] : shares) std::printf("%s %d\n", what.c_str(), count);
}

}  // namespace
}  // namespace delassus::testing
