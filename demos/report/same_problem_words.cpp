#include <cmath>
#include <cstdio>

#include "demos/report/figure.h"
#include "demos/report/markdown.h"
#include "demos/report/part.h"
#include "demos/report/same_problem.h"
#include "demos/report/scene_view.h"
#include "demos/scenes/catalogue.h"
#include "demos/table.h"

namespace demos::report {

namespace {

constexpr const char* folderName = "same_problem";
const std::vector<double> errorLevels{1e-1, 1e-2, 1e-3, 1e-4, 1e-6, 1e-8};

std::string viewName(const std::string& view) {
  return view == "cold" ? "cold: no stored impulses" : "each with its own warm start";
}

/// "**delassus:1e-4** 0.12", and the time of ours after it if another method is faster.
std::string fastestCell(const SceneView& view, double error) {
  if (error < view.floor) return "?";
  const Effort* best = cheapest(view.motion, error);
  if (best == nullptr) return "none";
  if (best->family == "delassus") return "**" + best->method + "** " + shortMs(best->cost);
  const std::vector<Effort> ours = ofFamily(view.motion, "delassus");
  const Effort* own = cheapest(ours, error);
  return best->method + " " + shortMs(best->cost) +
         (own != nullptr ? " (delassus " + shortMs(own->cost) + ")" : " (delassus: not reached)");
}

/// The scene's name, and the number of samples that count, if not all do.
std::string sceneCell(const SceneView& view) {
  if (view.uncertain == 0) return view.scene;
  return view.scene + " (" + std::to_string(view.samples) + " of " +
         std::to_string(view.samples + view.uncertain) + " samples)";
}

std::string fastestTable(const std::vector<SceneView>& views) {
  std::vector<std::string> heading{"scene", "contacts"};
  for (const double error : errorLevels) heading.push_back("≤ " + shortNumber(error));
  MarkdownTable table(heading);
  for (const SceneView& view : views) {
    if (view.motion.empty()) continue;
    std::vector<std::string> row{sceneCell(view), std::to_string(view.contacts)};
    for (const double error : errorLevels) row.push_back(fastestCell(view, error));
    table.add(row);
  }
  return table.text();
}

double errorOf(const SceneView& view, const std::string& method) {
  for (const Effort& effort : view.motion)
    if (effort.method == method) return effort.error;
  return INFINITY;
}

/// The work on which our solver spent its time.
std::string workOf(const SceneView& view, const std::string& method) {
  for (const SceneView::Work& work : view.work)
    if (work.method == method)
      return shortNumber(work.regions, 2) + " regions, " + shortNumber(work.factorisations, 2) +
             " factorisations a step; " + shortNumber(100 * work.aroundShare, 2) +
             " % around the solve";
  return "";
}

/// Every place where our curve is above the others. An error counts as below that of ten sweeps if
/// it is a tenth less; otherwise the two count as the same.
std::string defeatTable(const std::vector<SceneView>& views) {
  constexpr double below = 0.9;
  MarkdownTable table({"scene", "start", "error", "faster", "ms", "ours", "ms", "times as long",
                       "where ours spends it"});
  bool any = false;
  for (const SceneView& view : views)
    for (const Defeat& defeat : defeats(view.motion, "delassus", below * errorOf(view, "si:10"))) {
      any = true;
      const Effort& rival = defeat.rival;
      std::vector<std::string> row{view.scene, view.view, shortNumber(rival.error, 2),
                                   code(rival.method), shortMs(rival.cost)};
      if (defeat.own == nullptr)
        row.insert(row.end(), {"not reached", "", "", ""});
      else
        row.insert(row.end(), {code(defeat.own->method), shortMs(defeat.own->cost),
                               shortNumber(defeat.own->cost / rival.cost, 2),
                               workOf(view, defeat.own->method)});
      table.add(row);
    }
  return any ? table.text() : "";
}

Curve curveOf(const std::vector<Effort>& efforts, const std::string& label,
              const std::string& family) {
  Curve curve;
  curve.label = label;
  curve.colour = familyColour(family);
  curve.width = family == "delassus" ? 3 : 1.5;
  for (const Effort& effort : front(efforts))
    curve.line.push_back({effort.cost, effort.error, effort.costLow, effort.costHigh});
  for (const Effort& effort : efforts) curve.marks.push_back({effort.cost, effort.error});
  return curve;
}

Panel motionPanel(const SceneView& view, const std::string& title) {
  Panel panel;
  panel.title = title;
  panel.xLabel = "ms a step";
  panel.yLabel = "error of the motion  |v - v*| / |vf - v*|";
  panel.unknownBelow = view.floor;
  panel.yLeast = 1e-13;
  panel.yMost = 10;
  for (const std::string& family : families(view.motion)) {
    if (family == "delassus") continue;
    panel.curves.push_back(curveOf(ofFamily(view.motion, family), family, family));
  }
  // Ours last, on top.
  const std::vector<Effort> ours = ofFamily(view.motion, "delassus");
  if (!ours.empty()) panel.curves.push_back(curveOf(ours, "delassus", "delassus"));
  return panel;
}

Figure sceneFigure(const SceneView& cold, const SceneView& warm) {
  Figure figure;
  figure.title = cold.scene + ", " + std::to_string(cold.contacts) +
                 " contacts: error against time, lower left is better";
  figure.panels = {motionPanel(cold, viewName("cold")), motionPanel(warm, viewName("warm"))};
  return figure;
}

/// All scenes at a glance: ours, and the best of all others together.
Figure overviewFigure(const std::vector<SceneView>& views) {
  Figure figure;
  figure.title =
      "Error of the motion against time, each solver with its own warm start: lower left is better";
  figure.columns = panelColumns(views.size());
  figure.panelWidth = 330;
  figure.panelHeight = 300;
  for (const SceneView& view : views) {
    if (view.motion.empty()) continue;
    Panel panel;
    panel.title = view.scene;
    panel.xLabel = "ms a step";
    panel.yLabel = "error";
    panel.yLeast = 1e-13;
    panel.yMost = 10;
    panel.unknownBelow = view.floor;
    Curve others = curveOf(ofOthers(view.motion, "delassus"), "best of Bullet's", "si");
    others.marks.clear();
    panel.curves.push_back(others);
    for (const Effort& effort : view.motion)
      if (effort.method == "si:10") {
        Curve usual;
        usual.colour = familyColour("dantzig");
        usual.marks = {{effort.cost, effort.error}};
        usual.markLabels = {"si:10"};
        panel.curves.push_back(usual);
      }
    Curve ours = curveOf(ofFamily(view.motion, "delassus"), "delassus", "delassus");
    ours.marks.clear();
    panel.curves.push_back(ours);
    figure.panels.push_back(panel);
  }
  return figure;
}

std::string certificateTable(const std::vector<SceneView>& cold) {
  MarkdownTable table({"scene", "samples", "contacts", "joint rows", "residual of v*, m/s",
                       "v* known to", "samples left out"});
  for (const SceneView& view : cold)
    table.add({view.scene, std::to_string(view.samples), std::to_string(view.contacts),
               std::to_string(view.rows), shortNumber(view.residual, 2), shortNumber(view.floor, 2),
               std::to_string(view.uncertain)});
  return table.text();
}

/// "dantzig, lemke: time limit" for each reason.
std::string excludedLine(const SceneView& view) {
  std::vector<std::pair<std::string, std::string>> byReason;
  for (const auto& [method, reason] : view.excluded) {
    auto found = byReason.begin();
    while (found != byReason.end() && found->first != reason) ++found;
    if (found == byReason.end())
      byReason.emplace_back(reason, code(method));
    else
      found->second += ", " + code(method);
  }
  std::string text;
  for (const auto& [reason, methods] : byReason)
    text += (text.empty() ? "" : "; ") + reason + ": " + methods;
  return text;
}

std::string sceneSection(const SceneView& cold, const SceneView& warm,
                         const std::filesystem::path& folder, std::string& trouble) {
  std::string text = "### " + cold.scene + "\n\n" + findScene(cold.scene).summary + ".";
  if (cold.motion.empty()) return text + " No sample whose motion is known.\n\n";
  const std::string excluded =
      excludedLine(warm.excluded.size() > cold.excluded.size() ? warm : cold);
  if (!excluded.empty()) text += " Not in the picture: " + excluded + ".";
  text += " Data: [" + cold.scene + ".csv](" + folderName + "/" + cold.scene + ".csv).\n\n";
  addFault(trouble, draw(sceneFigure(cold, warm), folder, cold.scene));
  return text + picture(folderName, cold.scene, "error against time, " + cold.scene);
}

Words writeSameProblem(const Plan& plan, const std::filesystem::path& report) {
  const std::filesystem::path folder = report / folderName;
  const std::vector<SceneView> cold = readSceneViews(folder, plan.scenes, "cold"),
                               warm = readSceneViews(folder, plan.scenes, "warm");
  if (cold.empty()) return {};

  std::string trouble;
  addFault(trouble, draw(overviewFigure(warm), folder, "overview"));
  Words words;
  words.front =
      "## Who reaches which error in which time\n\n"
      "The fastest setting of all solvers and its time in ms a step, for the error |v − v*|_M / "
      "|v_f − v*|_M of the\n"
      "motion in the worst of the sampled steps. Each solver has its own warm start: the impulses "
      "that it has left in the contact\n"
      "points; joints, and points that are new, begin from nothing. **Bold**: ours; in brackets: "
      "ours where another one is\n"
      "faster; none: no solver gets there; ?: finer than v* is known. Behind a scene: the samples "
      "that count, where v* of\n"
      "the others is not known.\n\n" +
      fastestTable(warm) + "The same from cold, without stored impulses:\n\n" + fastestTable(cold) +
      picture(folderName, "overview", "error against time, all scenes");
  std::vector<SceneView> both = warm;
  both.insert(both.end(), cold.begin(), cold.end());
  const std::string table = defeatTable(both);
  words.front += "## Where `delassus` is not the fastest\n\n";
  words.front +=
      table.empty()
          ? "Below the error of `si:10` the curve of `delassus` lies on or below all others, in "
            "every scene "
            "and view.\n\n"
          : "Below the error of `si:10` its curve lies on or below all others except here:\n\n" +
                table;

  words.body =
      "## Same problem, every solver\n\n"
      "At sampled steps of the trajectory of `delassus` the very arguments of `solveGroup` are "
      "given to each method in turn,\n"
      "in a process of its own. Samples: *cold* (first step with reactions), *impact* (reactions "
      "do most), *settling* (most\n"
      "contacts change mode after it), *resting* (last step). A point is one setting of a solver: "
      "the mean time and the worst\n"
      "error of the samples, over repeats (median; bars: quartiles). Lines join the best settings "
      "of a family, pale points\n"
      "are the others. `delassus` has two kinds of settings: a tolerance (`delassus:1e-4`) and a "
      "budget (`delassus/N`: N\n"
      "sweeps and N/20 regions, at least one, an island). Grey: finer than v* is known. v* is a "
      "solve to tolerance\n"
      "1e-12, its certificate the natural "
      "residual and how far a second solve from other reactions agrees. Bullet's friction is a "
      "line or a square pyramid, the\n"
      "law's is a round cone: where contacts slide, no number of sweeps closes that gap.\n\n" +
      certificateTable(cold);
  for (std::size_t i = 0; i < cold.size(); ++i)
    words.body += sceneSection(cold[i], warm[i], folder, trouble);
  words.front += trouble;
  return words;
}

}  // namespace

Part sameProblemPart(const Plan& plan) {
  Part part;
  part.name = folderName;
  for (const std::string& scene : plan.scenes)
    part.units.push_back({scene, [&plan, scene](const Progress& progress) {
                            return measureSameProblem(findScene(scene), plan, progress);
                          }});
  part.write = [&plan](const std::filesystem::path& report) {
    return writeSameProblem(plan, report);
  };
  return part;
}

}  // namespace demos::report
