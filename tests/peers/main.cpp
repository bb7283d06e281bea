/// Compares `delassus solve` with the best general friction solvers of others, on problem files, or
/// (with `--piles`) on piles of light and heavy boxes. From the root of the project:
///
///     bash .ci/setup.sh peers && cmake --preset peers && cmake --build --preset peers
///     taskset -c 1 build-peers/tests/peers/delassus_peers ../shared/problems
///         --out renders/report/peers.md   (one line)
///
/// Every solve is cold: reactions are zero, and only W, q and μ are known of the problem. The time
/// is that of the solve with all that is derived from these, without reading the file, in
/// milliseconds of the processor. Our measures judge all solvers. Each runs with that tolerance of
/// its own, and the peers with that storage of W, that make it fastest; these are tried out
/// beforehand and not counted. Quote the ratios: both sides of one were measured in turn. One
/// thread each; twenty minutes for the forty problems.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "delassus/problem_text.h"
#include "demos/command.h"
#include "demos/number_checks.h"
#include "demos/process/interrupt.h"
#include "tests/peers/mixed_piles.h"
#include "tests/peers/ours.h"
#include "tests/peers/page.h"
#include "tests/peers/siconos.h"
#include "tests/support/random_piles.h"

namespace delassus::peers {

namespace {

struct Arguments {
  bool piles = false;
  std::string folder = "../shared/problems";
  Conditions conditions;
  std::string out;
};

/// The smallest come first, so that most of the table is there soon.
std::vector<Problem> readProblems(const std::string& folder) {
  std::vector<Problem> problems;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".fc3d") continue;
    problems.push_back(readProblem(entry.path().string()));
    if (problems.back().rows() > 0)
      throw std::runtime_error(entry.path().string() + ": rows, where peers know contacts alone");
  }
  if (problems.empty()) throw std::runtime_error(folder + ": no .fc3d files in this folder");
  std::sort(problems.begin(), problems.end(), [](const Problem& a, const Problem& b) {
    return std::make_pair(a.contacts(), a.name) < std::make_pair(b.contacts(), b.name);
  });
  return problems;
}

/// A problem, with our solver for it.
struct Subject {
  Problem problem;
  std::function<Contestant(double ownTolerance)> ours;
};

std::vector<Subject> subjectsOf(const Arguments& arguments) {
  std::vector<Subject> subjects;
  if (arguments.piles)
    for (const Problem& pile : mixedPiles())
      subjects.push_back(
          {test::withEntries(pile), [pile](double own) { return oursOn(pile, own); }});
  else
    for (Problem& problem : readProblems(arguments.folder))
      subjects.push_back({std::move(problem), ours});
  return subjects;
}

/// Writes to standard output, and to a file if one is named.
class Page {
 public:
  explicit Page(const std::string& path) {
    if (path.empty()) return;
    file_.open(path);
    if (!file_) throw std::runtime_error(path + ": cannot be written");
  }

  void say(const std::string& words) {
    std::fputs(words.c_str(), stdout);
    std::fflush(stdout);
    if (file_.is_open()) file_ << words << std::flush;
  }

 private:
  std::ofstream file_;
};

void comparePeers(const Arguments& arguments) {
  const std::vector<Subject> subjects = subjectsOf(arguments);
  const std::vector<Peer> peers = siconosSolvers();
  Page page(arguments.out);
  const demos::InterruptWatch watch;
  useOneThread();

  page.say(arguments.piles ? prefaceOfPiles() : prefaceOfFiles());
  page.say(tableHeading(int(peers.size())));
  std::vector<Comparison> comparisons;
  for (const auto& [problem, with] : subjects) {
    comparisons.push_back(compare(problem, with, peers, arguments.conditions));
    page.say(tableRow(comparisons.back()));
  }
  page.say("\n" + summary(comparisons, arguments.conditions));
}

int run(int argc, char** argv) {
  Arguments arguments;
  CLI::App app("delassus beside Siconos' friction solvers on problem files: a table of Markdown",
               "delassus_peers");
  app.add_option("folder", arguments.folder, "where the .fc3d files are")
      ->check(CLI::ExistingDirectory)
      ->type_name("PROBLEMS_DIR")
      ->capture_default_str();
  app.add_flag("--piles", arguments.piles,
               "piles of light and heavy boxes, and no files (quarter of an hour)");
  app.add_option("--tolerance", arguments.conditions.tolerance,
                 "what both rel and vel have to reach")
      ->check(demos::greaterThanZero)
      ->capture_default_str();
  app.add_option("--seconds", arguments.conditions.secondsLimit, "most that one solve may take")
      ->check(demos::greaterThanZero)
      ->type_name("LIMIT")
      ->capture_default_str();
  app.add_option("--out", arguments.out, "writes the table there too")->type_name("FILE.md");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? demos::exitDone : demos::exitBadUsage;
  }
  comparePeers(arguments);
  return demos::exitDone;
}

}  // namespace

}  // namespace delassus::peers

int main(int argc, char** argv) {
  try {
    return delassus::peers::run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "delassus_peers: %s\n", error.what());
    return demos::exitFailed;
  }
}
