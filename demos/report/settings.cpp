#include "demos/report/settings.h"

#include <cerrno>  // program_invocation_name

#include "demos/scenes/catalogue.h"

namespace demos::report {

namespace {

using Names = std::vector<std::string>;

std::string joined(const Names& names) {
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ",") + name;
  return list;
}

/// "kind:N" for each N.
void addSweeps(Names& names, const std::string& kind, const std::vector<int>& sweeps) {
  for (const int count : sweeps) names.push_back(kind + ":" + std::to_string(count));
}

Names sameProblemMethods(bool quick) {
  Names names;
  for (int exponent = 2; exponent <= 10; exponent += quick ? 2 : 1)
    names.push_back("delassus:1e-" + std::to_string(exponent));
  const std::vector<int> budgets =
      quick ? std::vector<int>{1, 5, 20} : std::vector<int>{1, 2, 5, 10, 20, 50, 100, 300, 1000};
  for (const int budget : budgets) names.push_back("delassus/" + std::to_string(budget));

  const std::vector<int> sweeps = quick
                                      ? std::vector<int>{5, 10, 50, 200, 1000}
                                      : std::vector<int>{5, 10, 20, 50, 100, 200, 500, 1000, 2000};
  for (const char* kind : {"si", "si2", "nncg", "pgs"}) addSweeps(names, kind, sweeps);
  for (const char* name : {"dantzig", "dantzig:1e-6", "lemke"}) names.emplace_back(name);
  return names;
}

Names sceneNames(bool quick) {
  if (quick) return {"stack_10_heavy_top", "pyramid_10", "card_house", "gripper"};
  return {"sliding_ladder", "box_headings",     "stack_10",   "stack_10_heavy_top",
          "stack_40",       "pyramid_10",       "pyramid_20", "wall_20x10",
          "arch",           "card_house",       "domino_run", "gripper",
          "ragdolls",       "heavy_ball_chain", "spheres_bin"};
}

}  // namespace

std::string ReportArguments::command() const {
  return program_invocation_name + (" " + words()) + " --out " + out;
}

std::string ReportArguments::commandAnywhere() const { return "delassus " + words() + " --out ."; }

std::string ReportArguments::words() const {
  std::string text = "report";
  if (stability) text += " --stability";
  if (quick) text += " --quick";
  if (!scenes.empty()) text += " --scenes " + joined(scenes);
  if (!solvers.empty()) text += " --solvers " + joined(solvers);
  if (!parts.empty()) text += " --parts " + joined(parts);
  return text;
}

Plan makePlan(const ReportArguments& arguments) {
  const bool quick = arguments.quick;
  Plan plan;
  plan.quick = quick;
  plan.scenes = arguments.scenes.empty() ? sceneNames(quick) : arguments.scenes;
  for (const std::string& scene : plan.scenes) findScene(scene);

  const auto chosen = [&arguments](const Names& usual) {
    return methodsNamed(arguments.solvers.empty() ? usual : arguments.solvers);
  };
  plan.methods = chosen(sameProblemMethods(quick));
  plan.trajectoryMethods = chosen(
      quick ? Names{"delassus", "delassus:1e-4", "si:10", "si:100", "nncg:10", "dantzig:1e-6"}
            : Names{"delassus", "delassus:1e-3", "si:10", "si:50", "si:200", "si:1000", "si2:50",
                    "nncg:10", "nncg:50", "pgs:50", "dantzig", "dantzig:1e-6", "lemke"});
  plan.stepMethods = chosen({"delassus", "si:10", "si:50", "si2:10", "nncg:10", "dantzig"});
  plan.scalingMethods = chosen({"delassus", "delassus:1e-4", "si:10", "si:100", "nncg:10", "pgs:10",
                                "dantzig", "dantzig:1e-6", "lemke"});

  plan.timing = quick ? Timing{0.5, 3, 9, 0.01} : Timing{1.5, 3, 25, 0.05};
  plan.scalingTiming = quick ? Timing{1, 1, 5, 0.05} : Timing{10, 2, 9, 0.5};
  plan.memorySteps = quick ? 5 : 6;
  plan.trajectorySeconds = quick ? 1 : 4;
  plan.scoutLimit = quick ? 4 : 20;
  plan.certificateLimit = quick ? 5 : 60;
  plan.trajectoryLimit = quick ? 2 : 6;
  plan.ablationScenes =
      !arguments.scenes.empty() ? arguments.scenes
      : quick                   ? Names{"one_box", "stack_10", "newton_cradle"}
              : Names{"one_box",           "islands_100",      "stack_10",      "pyramid_10",
                      "pyramid_20",        "wall_20x10",       "wall_and_ball", "domino_run",
                      "newton_cradle",     "heavy_ball_chain", "ragdolls",      "gripper",
                      "bead_in_trihedron", "ball_off_ball"};
  plan.ablationSeconds = quick ? 1 : 3;
  plan.ablationLimit = quick ? 5 : 20;
  plan.rates = {30, 60, 120, 240, 480};
  plan.contactCounts = quick ? std::vector<int>{4, 16, 64, 256, 1000}
                             : std::vector<int>{4, 16, 64, 256, 1000, 4000, 16000, 40000};
  return plan;
}

}  // namespace demos::report
