#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "demos/command.h"
#include "demos/explain.h"
#include "demos/json_line.h"
#include "demos/number_checks.h"
#include "demos/progress_bar.h"
#include "demos/scenes/simulate.h"
#include "demos/subject.h"
#include "demos/table.h"

namespace demos {

namespace {

struct RunArguments {
  std::string subject;
  std::string solvers = "delassus";
  double seconds = 0;  ///< 0: the scene's own
  double hz = 0;       ///< 0: the scene's own
  int threads = 1;
  bool noGeometricStiffness = false;
  bool json = false;
  bool explain = false;
};

nlohmann::ordered_json toJson(const std::string& scene, const RunSummary& run) {
  nlohmann::ordered_json json;
  json["scene"] = scene;
  json["solver"] = run.solver;
  json["precision"] = precisionName();
  json["steps"] = run.steps;
  json["hz"] = run.hz;
  json["bodies"] = run.bodies;
  json["contacts_max"] = run.contactsMax;
  json["ms_first"] = run.msFirst;
  json["ms_mean"] = run.msMean;
  json["ms_median"] = run.msMedian;
  json["ms_p95"] = run.msP95;
  json["residual_rms"] = run.residualRms;
  json["residual_max"] = run.residualMax;
  json["steps_above_1e-6"] = run.stepsAbove;
  // JSON has null for values that are not numbers.
  json["finite"] = run.stepsLost == 0;
  json["steps_lost"] = run.stepsLost;
  json["penetration_max_m"] = run.penetrationMax;
  json["kinetic_energy_j"] = run.kineticEnergy;
  json["tunnelled"] = run.tunnelled;
  json["drift_max_m"] = run.driftMax;
  json["joint_error_max_m"] = run.jointErrorMax;
  json["reaction_over_weight"] = run.reactionOverWeight;
  json["modes"] = {
      {"open", run.modes.open}, {"stick", run.modes.stick}, {"slide", run.modes.slide}};
  // Bullet's solvers have neither regions nor statuses: null and empty, not zero.
  json["regions_per_step"] = nullptr;
  json["factorisations_per_step"] = nullptr;
  json["statuses"] = nlohmann::ordered_json::object();
  if (run.regions) {
    json["regions_per_step"] = run.regions->perStep;
    json["factorisations_per_step"] = run.regions->factorisationsPerStep;
    json["statuses"] = {{"solved", run.regions->solved},
                        {"out_of_budget", run.regions->outOfBudget},
                        {"incompatible", run.regions->incompatible},
                        {"non_finite", run.regions->nonFinite}};
  }
  json["fallbacks"] = run.fallbacks;
  if (run.lawError) json["law_error"] = *run.lawError;
  if (run.regions) {
    json["left_out"] = run.regions->leftOut;
    json["push_unsolved"] = run.regions->pushUnsolved;
    json["stiffened"] = run.regions->stiffened;
    json["messages"] = nlohmann::ordered_json::array();
    for (const RunSummary::Message& message : run.regions->messages)
      json["messages"].push_back({{"text", message.text}, {"steps", message.steps}});
  }
  return json;
}

std::string counted(int count, const char* one, const char* many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

void printMessages(std::FILE* out, const std::vector<RunSummary::Message>& messages) {
  constexpr std::size_t most = 10;
  for (std::size_t i = 0; i < std::min(most, messages.size()); ++i)
    std::fprintf(out, "  %s (%s)\n", messages[i].text.c_str(),
                 counted(messages[i].steps, "step", "steps").c_str());
  if (messages.size() > most)
    std::fprintf(out, "  and %zu more; --json has them\n", messages.size() - most);
}

/// The same words as in `explain`, by key; regions and factorisations are keys of the run.
nlohmann::ordered_json explanation(const StepTotals& totals) {
  nlohmann::ordered_json json;
  for (const Need& need : needsOf(totals)) json["asked_for"][need.key] = need.aStep;
  for (const Cost& cost : costsOf(totals)) json["microseconds"][cost.key] = cost.microseconds;
  const delassus::StepReport& sum = totals.sum;
  const std::pair<const char*, int> islands[] = {{"free", sum.freeIslands},
                                                 {"kept", sum.keptIslands},
                                                 {"closed_form", sum.closedForms},
                                                 {"walked", sum.walks}};
  for (const auto& [key, count] : islands) json["islands"][key] = totals.aStep(count);
  const std::pair<const char*, int> counts[] = {{"stiffened", sum.stiffened},
                                                {"opposed", sum.opposed},
                                                {"held", sum.held},
                                                {"matrices", sum.matrices},
                                                {"sweeps", sum.sweeps},
                                                {"patches", sum.patches},
                                                {"softened", sum.softened},
                                                {"push_islands", sum.pushIslands},
                                                {"push_softened", sum.pushSoftened},
                                                {"events", sum.events}};
  for (const auto& [key, count] : counts) json[key] = totals.aStep(count);
  return json;
}

void printTable(std::FILE* out, const std::vector<RunSummary>& runs) {
  Table table({"solver", "ms median", "ms p95", "residual max", "rms m/s", "above 1e-6",
               "overlap m", "through", "drift m", "joints m", "kinetic J", "reaction/weight",
               "open/stick/slide", "fallbacks"});
  const auto word = [](double value, int digits = 3) {
    return std::isnan(value) ? "lost" : shortNumber(value, digits);
  };
  for (const RunSummary& run : runs) {
    const ModeCounts& modes = run.modes;
    table.add({run.solver, shortNumber(run.msMedian), shortNumber(run.msP95), word(run.residualMax),
               word(run.residualRms), shortNumber(100.0 * run.stepsAbove / run.steps) + " %",
               word(run.penetrationMax), std::to_string(run.tunnelled), word(run.driftMax),
               word(run.jointErrorMax), word(run.kineticEnergy), word(run.reactionOverWeight, 7),
               std::to_string(modes.open) + "/" + std::to_string(modes.stick) + "/" +
                   std::to_string(modes.slide),
               std::to_string(run.fallbacks)});
  }
  std::fputs(table.text().c_str(), out);
  for (const RunSummary& run : runs)
    if (run.stepsLost > 0)
      std::fprintf(
          out,
          "%s: the world is lost: %d of %d steps end with a body that is nowhere, its place "
          "or velocity not a number\n",
          run.solver.c_str(), run.stepsLost, run.steps);
  for (const RunSummary& run : runs) {
    if (!run.regions) continue;
    std::fprintf(
        out,
        "%s: %.3g regions and %.3g factorisations a step; islands: %ld solved, %ld out of budget, "
        "%ld incompatible, %ld non-finite; %ld parts left out",
        run.solver.c_str(), run.regions->perStep, run.regions->factorisationsPerStep,
        run.regions->solved, run.regions->outOfBudget, run.regions->incompatible,
        run.regions->nonFinite, run.regions->leftOut);
    if (const long count = run.regions->pushUnsolved; count > 0)
      std::fprintf(out, "; %ld push problems not solved", count);
    if (const int most = run.regions->stiffened; most > 0)
      std::fprintf(out, "; %s stiffened in a step at most",
                   counted(most, "body", "bodies").c_str());
    std::fprintf(out, "\n");
    printMessages(out, run.regions->messages);
  }
}

void printLawErrors(std::FILE* out, const Law& law, const std::vector<RunSummary>& runs) {
  std::fprintf(out, "%s:", law.name.c_str());
  for (const RunSummary& run : runs)
    std::fprintf(out, "  %s %s", run.solver.c_str(), shortNumber(*run.lawError).c_str());
  std::fprintf(out, "\n");
}

/// Prints everything about the solvers that are done.
void printRuns(std::FILE* out, const RunArguments& arguments, const std::optional<Law>& law,
               const std::vector<RunSummary>& runs) {
  if (runs.empty()) return;
  std::fprintf(out, "%s: %s at %g Hz, %s, up to %s, %s precision\n", arguments.subject.c_str(),
               counted(runs[0].steps, "step", "steps").c_str(), runs[0].hz,
               counted(runs[0].bodies, "body", "bodies").c_str(),
               counted(runs[0].contactsMax, "contact", "contacts").c_str(), precisionName());
  printTable(out, runs);
  if (law) printLawErrors(out, *law, runs);
  for (const RunSummary& run : runs)
    if (arguments.explain && run.regions)
      std::fprintf(out, "\n%s, means of %d steps\n\n%s", run.solver.c_str(), run.steps,
                   explain(run.regions->totals).c_str());
}

/// The same as text, in case the next solver crashes.
std::string textOfRuns(const RunArguments& arguments, const std::optional<Law>& law,
                       const std::vector<RunSummary>& runs) {
  char* text = nullptr;
  std::size_t size = 0;
  std::FILE* out = open_memstream(&text, &size);
  if (out == nullptr) return "";
  printRuns(out, arguments, law, runs);
  std::fclose(out);
  std::string copy(text, size);
  std::free(text);
  return copy;
}

/// Tells which options change nothing, since none of the solvers is ours.
void tellWhatIsIdle(const RunArguments& arguments, const std::vector<NamedSolver>& solvers) {
  if (std::any_of(solvers.begin(), solvers.end(),
                  [](const NamedSolver& solver) { return solver.delassus() != nullptr; }))
    return;
  const auto tell = [](bool given, const char* option) {
    if (given)
      std::fprintf(stderr, "%s is for delassus alone, and changes nothing: add it to --solver\n",
                   option);
  };
  tell(arguments.threads > 1, "--threads");
  tell(arguments.noGeometricStiffness, "--no-geometric-stiffness");
  tell(arguments.explain, "--explain");
}

int runSubject(const RunArguments& arguments) {
  // A wrong name is reported before the first solver, which may run for minutes.
  std::vector<NamedSolver> solvers;
  for (const std::string& name : splitNames(arguments.solvers)) solvers.emplace_back(name);
  tellWhatIsIdle(arguments, solvers);

  std::vector<RunSummary> runs;
  std::optional<Law> law;
  for (NamedSolver& solver : solvers) {
    solver.setThreads(arguments.threads);
    solver.setGeometricStiffness(!arguments.noGeometricStiffness);
    Subject subject = openSubject(arguments.subject);
    RunSettings settings{arguments.seconds > 0 ? arguments.seconds : subject.seconds,
                         arguments.hz > 0 ? arguments.hz : subject.hz, subject.law};
    law = subject.law;
    if (runs.empty()) {
      std::FILE* notesTo = arguments.json ? stderr : stdout;
      for (const std::string& note : subject.notes)
        std::fprintf(notesTo, "%s: %s\n", subject.name.c_str(), note.c_str());
    }
    {
      ProgressBar bar(subject.name + " " + solver.name());
      const auto blame =
          blameBullet(subject.name, solver, arguments.json ? "" : textOfRuns(arguments, law, runs));
      runs.push_back(simulate(*subject.world, solver, settings,
                              [&bar](double fraction) { bar.show(fraction); }));
    }
    if (arguments.json) {
      nlohmann::ordered_json json = toJson(subject.name, runs.back());
      if (arguments.explain && runs.back().regions)
        json["explain"] = explanation(runs.back().regions->totals);
      std::printf("%s\n", jsonLine(json).c_str());
      std::fflush(stdout);  // the next solver may take minutes, or crash
    }
  }
  if (!arguments.json) printRuns(stdout, arguments, law, runs);
  return exitDone;
}

/// The forms of the solvers' names with their help, a line for each sentence.
std::string solverHelp() {
  std::vector<std::pair<std::string, std::string>> lines;
  bool goesOn = false;
  for (const SolverForm& form : solverForms()) {
    if (goesOn) {
      lines.back().first += ", " + form.name.text();
      lines.back().second += " " + form.help;
    } else {
      lines.emplace_back(form.name.text(), form.help);
    }
    goesOn = form.help.back() == ',' || form.help.back() == ';';
  }
  std::size_t widest = 0;
  for (const auto& line : lines) widest = std::max(widest, line.first.size());
  std::string text;
  for (const auto& [forms, help] : lines)
    text += "  " + forms + std::string(widest - forms.size() + 2, ' ') + help + "\n";
  return text;
}

}  // namespace

void addRunCommand(CLI::App& app, Action& chosen) {
  auto arguments = std::make_shared<RunArguments>();
  CLI::App* command = app.add_subcommand(
      "run", "simulates without pictures; summary of motion, modes, residual, time");
  command->add_option("subject", arguments->subject, "a built-in scene or a .bullet file")
      ->required()
      ->type_name("SCENE|FILE.bullet");
  command
      ->add_option("--solver", arguments->solvers,
                   "one or more, with commas between: " + listOfSolverForms(", "))
      ->type_name("NAME[,NAME]")
      ->capture_default_str();
  command
      ->add_option("--seconds", arguments->seconds,
                   "simulated time (default: the scene's own; 5 for a file)")
      ->check(greaterThanZero);
  command
      ->add_option("--hz", arguments->hz,
                   "steps a second (default: the scene's own, 60 for most and for files)")
      ->check(greaterThanZero);
  command
      ->add_option("--threads", arguments->threads,
                   "delassus: threads that solve islands side by side, and work together on a "
                   "large one; the motion is the same for any number")
      ->check(CLI::Range(1, 256))
      ->capture_default_str();
  command->add_flag(
      "--no-geometric-stiffness", arguments->noGeometricStiffness,
      "delassus: light bodies in taut joints may turn faster than the step can follow");
  command->add_flag("--explain", arguments->explain,
                    "tells what the scene asks of delassus, of which parts a step consists "
                    "therefore, and what each part costs");
  command->add_flag("--json", arguments->json, "one JSON object a line, one per solver");
  command->footer(
      "Solvers:\n" + solverHelp() +
      "\n"
      "Residuals (m/s), reaction/weight and the law's error are those of the last three quarters\n"
      "of the run. Kinetic energy, open/stick/slide and through (bodies that are in or under what\n"
      "cannot move) are those of its end. All else is of the whole run. Times are those of\n"
      "solveGroup alone. Stiffened is the largest number of bodies in one step that turned more\n"
      "slowly because of geometric stiffness.");
  command->callback(
      [&chosen, arguments] { chosen = [arguments] { return runSubject(*arguments); }; });
}

}  // namespace demos
