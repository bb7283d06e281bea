/// Damaged problem texts, in both formats: each is refused in one line that names its place, or
/// read as a problem that can be written, read again and solved.

#include <iterator>
#include <vector>

#include "delassus/solver.h"
#include "tests/fuzz/target.h"
#include "tests/support/problem_texts.h"

namespace delassus::test {
namespace {

std::string seed(Random& random) { return chance(random, 0.5) ? test::contactText : test::rowText; }

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

/// Splits after every blank and line end, which stay at the end of their word.
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

Outcome ask(const std::string& text) {
  Outcome outcome;
  const auto expect = [&outcome](bool holds, const std::string& fault) {
    if (!holds) outcome.faults.insert(fault);
  };
  try {
    const Problem problem = test::fromText(text);
    const std::string changed = test::difference(problem, test::fromText(test::toText(problem)));
    expect(changed.empty(), "written and read again it differs in " + changed);
    const Solution solution = solve(problem);
    expect(solution.r.size() == problem.size(), "a reaction is missing");
    expect(solution.r.allFinite(), "a reaction is not finite");
    ++outcome.counts["read, " + toString(solution.status)];
  } catch (const ProblemTextError& error) {
    const std::string what = error.what();
    expect(what.rfind("text:", 0) == 0, "no place in: " + what);
    expect(what.find('\n') == std::string::npos, "more than a line: " + what);
    expect(what.size() < 400, "too long: " + what);
    ++outcome.counts["refused"];
  }
  return outcome;
}

}  // namespace

const Target target{"problem_text", ask,  seed,
                    mutated,        4000, {{"refused", 0.25}, {"read, solved", 0.01}}};

}  // namespace delassus::test
