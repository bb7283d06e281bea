#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <vector>

#include "delassus/problem_text.h"
#include "delassus/residual.h"
#include "delassus/solver.h"
#include "delassus/split_problem.h"
#include "demos/command.h"
#include "demos/json_line.h"
#include "demos/number_checks.h"
#include "demos/scenes/statistics.h"
#include "demos/standard_output.h"
#include "demos/table.h"

namespace demos {

using namespace delassus;

namespace {

struct SolveArguments {
  std::string file;
  double tolerance = 1e-8;
  bool json = false;
  std::string solutionFile;
};

struct Answer {
  Solution solution;
  FclibMeasures measures;
  bool within;  ///< it is within the tolerance in both published measures, and nothing approaches
  double ms;    ///< the solves alone
};

double milliseconds() {
  return std::chrono::duration<double, std::milli>(
             std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

/// Whether no contact approaches. In a wide cone the published measures hardly show it: an approach
/// counts 1/√(1 + μ²) of its speed there.
bool nothingApproaches(const Problem& problem, const VectorXd& r, double tolerance) {
  constexpr double times = 3;
  const VectorXd u = problem.W * r + problem.q;
  const double most = times * tolerance * problem.q.norm();
  for (int i = 0; i < problem.contacts(); ++i)
    if (!(u[3 * i] >= -most)) return false;
  return true;
}

/// The solver measures its error in another way than the file format does. If it stops too early by
/// the format's measures, it is asked for a smaller tolerance.
Answer solveWithin(const Problem& problem, double tolerance) {
  constexpr int most = 2;          // decades
  constexpr double loosest = 0.1;  // that makes the solver look for an answer
  Options options;
  options.tolerance = std::min(tolerance, loosest);
  int regions = 0;  // of all attempts
  double ms = 0;
  for (int decade = 0;; ++decade, options.tolerance *= 0.1) {
    const double begin = milliseconds();
    Solution solution = delassus::solve(problem, options);
    ms += milliseconds() - begin;
    regions += solution.regions;
    solution.regions = regions;
    const FclibMeasures measures = fclibMeasures(problem, solution.r);
    const bool within = solution.status != Status::NonFinite && measures.rel <= tolerance &&
                        measures.vel <= tolerance &&
                        nothingApproaches(problem, solution.r, tolerance);
    if (within || solution.status != Status::Solved || decade == most)
      return {std::move(solution), measures, within, ms};
  }
}

/// The median time of a solve: first solves wait for code and memory, which takes longer than a
/// small problem.
double usualMs(const Problem& problem, double tolerance, double first) {
  constexpr double enough = 20;  // ms of repeats
  constexpr std::size_t most = 1000;
  std::vector<double> all{first};
  for (const double end = milliseconds() + enough - first;
       all.size() < most && milliseconds() < end;)
    all.push_back(solveWithin(problem, tolerance).ms);
  return median(all);
}

int solveFile(const SolveArguments& arguments) {
  std::error_code ignored;  // set if one of the files does not exist
  if (std::filesystem::equivalent(arguments.file, arguments.solutionFile, ignored))
    throw BadUsage("--solution " + arguments.solutionFile + " is the problem itself");
  ProblemFormat format{};
  const Problem problem = readProblem(arguments.file, &format);
  auto [solution, measures, within, first] = solveWithin(problem, arguments.tolerance);
  const double ms = usualMs(problem, arguments.tolerance, first);

  // The status is Solved exactly if the published measures say so, and nothing approaches.
  if (within)
    solution.status = Status::Solved;
  else if (solution.status == Status::Solved)
    solution.status = Status::OutOfBudget;
  if (!arguments.solutionFile.empty())
    writeTo(arguments.solutionFile,
            [&, &answer = solution](auto& out) { writeSolution(out, problem, answer); });

  std::FILE* words = wordsAbout(arguments.solutionFile);
  const bool contacts = format == ProblemFormat::Contacts;
  const std::string kind = contacts ? "fc3d" : "lcp";
  const int size = contacts ? problem.contacts() : problem.rows();
  const int islands = ProblemParts(problem).count();
  if (arguments.json) {
    nlohmann::ordered_json json;
    json["name"] = problem.name;
    json["kind"] = kind;
    json["size"] = size;
    json["status"] = toString(solution.status);
    json["rel"] = measures.rel;
    json["vel"] = measures.vel;
    json["ms"] = ms;
    json["regions"] = solution.regions;
    json["islands"] = islands;
    std::fprintf(words, "%s\n", jsonLine(json).c_str());
  } else {
    std::fprintf(words, "%s: %s, %d %s in %d %s\n", problem.name.c_str(), kind.c_str(), size,
                 contacts ? "contacts" : "rows", islands, islands == 1 ? "island" : "islands");
    std::fprintf(words, "%s  rel %s  vel %s  (tolerance %g)  %.3g ms  %d regions\n",
                 toString(solution.status).c_str(), shortNumber(measures.rel).c_str(),
                 shortNumber(measures.vel).c_str(), arguments.tolerance, ms, solution.regions);
  }
  return within ? exitDone : exitAboveTolerance;
}

}  // namespace

void addSolveCommand(CLI::App& app, Action& chosen) {
  auto arguments = std::make_shared<SolveArguments>();
  CLI::App* command =
      app.add_subcommand("solve", "solves one problem file: status, residuals, time");
  command
      ->add_option("file", arguments->file,
                   "delassus-problem v1 (contacts with friction) or lcp v1 (rows with bounds)")
      ->required()
      ->type_name("FILE.fc3d|FILE.lcp");
  command
      ->add_option("--tolerance", arguments->tolerance,
                   "largest rel and vel allowed; exit status 3 if one of them is larger")
      ->check(greaterThanZero)
      ->capture_default_str();
  command->add_flag("--json", arguments->json, "one JSON object");
  command
      ->add_option("--solution", arguments->solutionFile,
                   "writes reactions and velocities (solution v1)")
      ->type_name("FILE")
      ->check(notEmpty);
  command->footer(
      "rel: |F| / |q|, F = r - P(r - v) with P the projection on the cones or bounds and v the\n"
      "velocities u = W r + q (of contacts, those that De Saxce corrects: u + mu |u_t| n);\n"
      "vel: |(F_i(s_i) / s_i)_i| / |q|, the same in velocities, with steps s_i =\n"
      "3 / trace(W_ii) of contacts and 1 / |W_ii| of rows. Solved: both are within the tolerance,\n"
      "and no contact approaches at more than 3 tolerance |q| (which matters where mu > 3).\n"
      "ms: of the solve alone, from no reactions; the median of repeats where it is short.\n"
      "Exit status: 0 solved, 3 not solved, 1 a file cannot be read or written, 2 bad usage.");
  command->callback(
      [&chosen, arguments] { chosen = [arguments] { return solveFile(*arguments); }; });
}

}  // namespace demos
