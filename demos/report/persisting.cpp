#include <cmath>

#include "demos/report/figure.h"
#include "demos/report/markdown.h"
#include "demos/report/part.h"
#include "demos/report/scene_view.h"
#include "demos/table.h"

namespace demos::report {

namespace {

constexpr const char* folderName = "persisting";

Panel modesPanel(const SceneView& view) {
  Panel panel;
  panel.title = view.scene;
  panel.xLabel = "ms a step";
  panel.yLabel = "contacts in a wrong mode, %";
  panel.logY = false;
  double most = 1;
  const auto add = [&](const std::string& family) {
    Curve curve;
    curve.label = family;
    curve.colour = familyColour(family);
    curve.width = family == "delassus" ? 3 : 1.5;
    for (const Effort& effort : front(ofFamily(view.modes, family))) {
      curve.line.push_back({effort.cost, 100 * effort.error});
      most = std::max(most, 100 * effort.error);
    }
    panel.curves.push_back(curve);
  };
  for (const std::string& family : families(view.modes))
    if (family != "delassus") add(family);
  add("delassus");
  panel.yLeast = -0.05 * most;
  panel.yMost = 1.1 * most;
  return panel;
}

std::string percent(const SceneView& view, const std::string& method) {
  for (const Effort& effort : view.modes)
    if (effort.method == method)
      return shortNumber(100 * effort.error, effort.error < 0.995 ? 2 : 3);
  return "–";
}

Words writePersisting(const Plan& plan, const std::filesystem::path& report) {
  // Reads the measures on the same problems in another way.
  const std::vector<SceneView> views = readSceneViews(report / "same_problem", plan.scenes, "warm");
  if (views.empty()) return {};

  std::vector<std::string> shown;
  for (const char* name :
       {"delassus:1e-8", "delassus:1e-2", "delassus/5", "si:10", "si:50", "si:200", "si:1000",
        "si2:50", "nncg:50", "pgs:50", "dantzig", "dantzig:1e-6", "lemke"})
    for (const Method& method : plan.methods)
      if (method.name == name) shown.emplace_back(name);
  std::vector<std::string> heading{"scene"};
  for (const std::string& name : shown) heading.push_back(code(name));
  MarkdownTable table(heading);
  Figure figure;
  figure.title =
      "Contacts whose mode (open, stick, slide) is not the one that takes place, own warm start";
  figure.columns = panelColumns(views.size());
  figure.panelWidth = 330;
  figure.panelHeight = 300;
  for (const SceneView& view : views) {
    if (view.modes.empty()) continue;
    figure.panels.push_back(modesPanel(view));
    std::vector<std::string> row{view.scene};
    for (const std::string& name : shown) row.push_back(percent(view, name));
    table.add(row);
  }
  const std::string trouble = draw(figure, report / folderName, "modes");
  Words words;
  words.body =
      "## Which contacts persist\n\n"
      "What Delassus' paper is about, in one number: the share of contacts, in percent, that a "
      "solver takes in another mode\n"
      "than the motion that takes place, mean of the samples. Modes are read from the motion, "
      "since reactions of redundant\n"
      "contacts are not unique: open where the gap opens faster than 1 mm/s, else sliding where "
      "the contact slides faster than\n"
      "that, else sticking. –: beyond its time limit, crashed or gave up.\n\n" +
      table.text() + picture(folderName, "modes", "wrong modes against time") +
      (trouble.empty() ? "" : trouble + "\n\n");
  return words;
}

}  // namespace

Part persistingPart(const Plan& plan) {
  Part part;
  part.name = folderName;
  part.write = [&plan](const std::filesystem::path& report) {
    return writePersisting(plan, report);
  };
  return part;
}

}  // namespace demos::report
