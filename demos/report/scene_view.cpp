#include "demos/report/scene_view.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "demos/report/csv.h"
#include "demos/scenes/statistics.h"

namespace demos::report {

namespace {

/// v* is not known if two solves differ by more than this, relative to |v_f − v*|_M.
constexpr double mostDisagreement = 1e-2;
/// No motion is known better than to round-off.
constexpr double roundOffFloor = 1e-13;

/// Sums for a method over the samples.
struct Sums {
  std::string family, fault;
  int samples = 0;
  double cost = 0, costLow = 0, costHigh = 0;
  double error = 0, residual = 0, wrong = 0;
  double solve = 0, around = 0, regions = 0, factorisations = 0;
};

void add(Sums& sums, const CsvTable& table, int row, double floor) {
  constexpr double ms = 1e3;
  ++sums.samples;
  sums.cost += ms * table.number(row, "seconds");
  sums.costLow += ms * table.number(row, "seconds_low");
  sums.costHigh += ms * table.number(row, "seconds_high");
  const double error = table.number(row, "error");
  // A motion that is not a number has the largest error.
  sums.error = std::isfinite(error) ? std::max({sums.error, error, floor}) : INFINITY;
  sums.residual = largerOf(sums.residual, table.number(row, "residual_max"));
  sums.wrong += table.number(row, "wrong_modes");
  sums.solve += table.number(row, "solve_seconds");
  sums.around += table.number(row, "around_seconds");
  sums.regions += table.number(row, "regions");
  sums.factorisations += table.number(row, "factorisations");
}

void take(SceneView& view, const std::string& method, const Sums& sums) {
  if (!sums.fault.empty()) {
    view.excluded.emplace_back(method, sums.fault);
    return;
  }
  const double n = sums.samples;
  const Effort effort{method,           sums.family,       sums.cost / n,
                      sums.costLow / n, sums.costHigh / n, sums.error};
  view.motion.push_back(effort);
  view.modes.push_back(effort);
  view.modes.back().error = sums.wrong / n;
  view.residuals.push_back(effort);
  view.residuals.back().error = sums.residual;
  if (sums.family == "delassus")
    view.work.push_back({method, sums.around / (sums.around + sums.solve), sums.regions / n,
                         sums.factorisations / n});
}

}  // namespace

SceneView readSceneView(const std::filesystem::path& file, const std::string& scene,
                        const std::string& view) {
  const CsvTable table = CsvTable::read(file);
  SceneView result;
  result.scene = scene;
  result.view = view;
  bool onlyCold = true;
  for (int row = 0; row < table.rows(); ++row) onlyCold &= table.text(row, "phase") == "cold";

  std::vector<std::string> order;
  std::map<std::string, Sums> methods;
  std::set<std::string> phases, uncertain;
  for (int row = 0; row < table.rows(); ++row) {
    const std::string& phase = table.text(row, "phase");
    if (table.text(row, "view") != view) continue;
    if (view == "warm" && phase == "cold" && !onlyCold) continue;
    const double agreement = table.number(row, "certificate_agreement");
    if (table.text(row, "certificate_ending") != "done" || !(agreement <= mostDisagreement)) {
      uncertain.insert(phase);
      continue;
    }
    const double floor = std::max(agreement, roundOffFloor);
    phases.insert(phase);
    result.floor = std::max(result.floor, floor);
    result.residual = largerOf(result.residual, table.number(row, "certificate_residual"));
    result.contacts = std::max(result.contacts, int(table.number(row, "contacts")));
    result.rows = std::max(result.rows, int(table.number(row, "rows")));

    const std::string& method = table.text(row, "method");
    if (methods.count(method) == 0) order.push_back(method);
    Sums& sums = methods[method];
    sums.family = table.text(row, "family");
    const std::string& ending = table.text(row, "ending");
    if (ending == "done")
      add(sums, table, row, floor);
    else
      sums.fault = ending;
  }
  result.samples = int(phases.size());
  result.uncertain = int(uncertain.size());
  for (const std::string& method : order) take(result, method, methods[method]);
  return result;
}

std::vector<SceneView> readSceneViews(const std::filesystem::path& folder,
                                      const std::vector<std::string>& scenes,
                                      const std::string& view) {
  std::vector<SceneView> views;
  for (const std::string& scene : scenes) {
    const std::filesystem::path file = folder / (scene + ".csv");
    if (std::filesystem::exists(file)) views.push_back(readSceneView(file, scene, view));
  }
  return views;
}

}  // namespace demos::report
