#include <algorithm>
#include <cmath>
#include <optional>

#include "demos/process/apart.h"
#include "demos/report/closed_form.h"
#include "demos/report/figure.h"
#include "demos/report/markdown.h"
#include "demos/report/part.h"
#include "demos/scenes/builders.h"
#include "demos/scenes/catalogue.h"
#include "demos/scenes/measures.h"
#include "demos/scenes/statistics.h"
#include "demos/table.h"

namespace demos::report {

namespace {

constexpr const char* folderName = "time_step";

/// A motion that is known without any solver: how wrong is a world at time `seconds`?
struct KnownMotion {
  std::string scene, unit, what;
  double seconds;  ///< a whole number of steps at every rate
  /// Makes the measure for a world at its start.
  std::function<std::function<double(const World&)>(const World&)> measure;
};

double away(const btRigidBody& body, const Plane& truth) {
  const btVector3& centre = body.getWorldTransform().getOrigin();
  return std::hypot(centre.x() - truth.x, centre.y() - truth.y);
}

std::vector<KnownMotion> knownMotions() {
  std::vector<KnownMotion> known;
  known.push_back(
      {"ball_off_ball", "m", "distance from the closed form after leaving", 1.4,
       [](const World& start) {
         const btVector3 p = start.movableBodies()[0]->getWorldTransform().getOrigin();
         const Plane truth = ballOffBallAt(1.4, std::hypot(p.x(), p.y()), std::atan2(p.x(), p.y()));
         return [truth](const World& world) { return away(*world.movableBodies()[0], truth); };
       }});
  known.push_back({"sliding_ladder", "m", "distance from the closed form after leaving the wall",
                   0.9, [](const World& start) {
                     const btRigidBody& rod = *start.movableBodies()[0];
                     const btVector3 p = rod.getWorldTransform().getOrigin();
                     const double L = std::hypot(p.x(), p.y());
                     const double inertia = 1 / rod.getInvInertiaTensorWorld()[2][2];
                     const Plane truth = slidingLadderAt(0.9, L, std::atan2(p.y(), p.x()),
                                                         inertia * rod.getInvMass() / (L * L));
                     return [truth](const World& world) {
                       return away(*world.movableBodies()[0], truth);
                     };
                   }});
  known.push_back(
      {"incline", "m", "error of the way of either box", 1, [](const World& start) {
         std::vector<btVector3> from;
         for (const btRigidBody* box : start.movableBodies())
           from.push_back(box->getWorldTransform().getOrigin());
         return [from](const World& world) {
           constexpr double degree = M_PI / 180;
           double worst = 0;
           for (std::size_t i = 0; i < from.size(); ++i) {
             const double angle = frictionAngle() + (i == 0 ? -degree : degree);
             const double way =
                 (world.movableBodies()[i]->getWorldTransform().getOrigin() - from[i]).length();
             worst = largerOf(worst, std::abs(way - inclineWay(1, angle, usualFriction)));
           }
           return worst;
         };
       }});
  known.push_back({"newton_cradle", "J", "energy lost or gained", 2, [](const World& start) {
                     const double energy = totalEnergy(start);
                     return [energy](const World& world) {
                       return std::abs(totalEnergy(world) - energy);
                     };
                   }});
  return known;
}

std::vector<double> errorAt(const KnownMotion& known, const Method& method, double rate) {
  NamedSolver named(method.name);
  const std::unique_ptr<World> world = findScene(known.scene).build();
  const auto measure = known.measure(*world);
  named.configure(world->dynamics().getSolverInfo());
  world->setSolver(named.solver());
  world->run(known.seconds, rate);
  return {measure(*world)};
}

CsvTable measureScene(const KnownMotion& known, const Plan& plan, const Progress& progress) {
  CsvTable table({"method", "family", "rate", "error", "ending"});
  const double runs = double(plan.stepMethods.size() * plan.rates.size());
  int done = 0;
  for (const Method& method : plan.stepMethods)
    for (const double rate : plan.rates) {
      const ApartResult run =
          runApart([&] { return errorAt(known, method, rate); }, Limits{2 * plan.trajectoryLimit});
      const double error = run.ending == Ending::Done ? run.numbers.at(0) : std::nan("");
      table.add(
          {method.name, method.family, csvNumber(rate), csvNumber(error), toString(run.ending)});
      progress(++done / runs);
    }
  return table;
}

/// Slope of log error over log h by least squares: error ∝ h^order. Empty unless all values are
/// numbers.
std::optional<double> orderOf(const std::vector<Place>& places) {
  const double n = double(places.size());
  if (n < 2) return {};
  double x = 0, y = 0, xx = 0, xy = 0;
  for (const Place& place : places) {
    if (!(place.y > 0) || !std::isfinite(place.y)) return {};
    const double h = std::log(place.x), e = std::log(place.y);
    x += h, y += e, xx += h * h, xy += h * e;
  }
  return (n * xy - x * y) / (n * xx - x * x);
}

std::vector<Place> placesOf(const CsvTable& table, const std::string& method) {
  std::vector<Place> places;
  for (int row = 0; row < table.rows(); ++row)
    if (table.text(row, "method") == method)
      places.push_back({1e3 / table.number(row, "rate"), table.number(row, "error")});
  return places;
}

/// Curves that a reader cannot tell apart.
bool coincide(const std::vector<Place>& a, const std::vector<Place>& b) {
  constexpr double visible = 0.02;
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (!(std::abs(a[i].y - b[i].y) <= visible * b[i].y)) return false;
  return true;
}

Curve curveOf(const std::string& label, const std::string& family, std::vector<Place> places) {
  Curve curve;
  curve.label = label;
  curve.colour = familyColour(family);
  curve.width = family == "delassus" ? 3 : 1.5;
  // Names stand at the right end, where steps are long.
  std::sort(places.begin(), places.end(), [](const Place& a, const Place& b) { return a.x < b.x; });
  curve.line = std::move(places);
  return curve;
}

Panel panelOf(const KnownMotion& known, const CsvTable& table, const Plan& plan) {
  Panel panel;
  panel.title = known.scene + ": " + known.what;
  panel.xLabel = "time step, ms";
  panel.yLabel = "error, " + known.unit;
  panel.yMost = 10;  // curves that explode are drawn on the border
  const std::vector<Place> ours = placesOf(table, "delassus");
  int alike = 0;
  for (const Method& method : plan.stepMethods) {
    const std::vector<Place> places = placesOf(table, method.name);
    const bool own = method.name == "delassus";
    if (!own && coincide(places, ours)) {
      ++alike;
      continue;
    }
    if (!own) panel.curves.push_back(curveOf(method.name, method.family, places));
  }
  // Ours last, on top, and in the name of all curves that it would cover.
  if (!ours.empty()) {
    const std::string others = " and " + std::to_string(alike) + " others";
    panel.curves.push_back(curveOf(alike > 0 ? "delassus" + others : "delassus", "delassus", ours));
  }
  return panel;
}

Words writeTimeStep(const Plan& plan, const std::filesystem::path& report) {
  const std::filesystem::path folder = report / folderName;
  std::vector<std::string> heading{"scene"};
  for (const Method& method : plan.stepMethods) heading.push_back(code(method.name));
  MarkdownTable table(heading);
  Figure figure;
  figure.title = "Error at a fixed time against the time step";
  for (const KnownMotion& known : knownMotions()) {
    if (!std::filesystem::exists(folder / (known.scene + ".csv"))) continue;
    const CsvTable data = CsvTable::read(folder / (known.scene + ".csv"));
    figure.panels.push_back(panelOf(known, data, plan));
    std::vector<std::string> row{known.scene + ", " + known.what};
    for (const Method& method : plan.stepMethods) {
      const std::vector<Place> places = placesOf(data, method.name);
      const std::optional<double> order = orderOf(places);
      const double finest = places.empty() ? std::nan("") : places.back().y;
      const bool converges = order && *order > 0.3;
      row.push_back(
          (converges ? "h^" + shortNumber(*order, 2) : "none") + ", " +
          (std::isfinite(finest) ? shortNumber(finest, 2) + " " + known.unit : "explodes"));
    }
    table.add(row);
  }
  if (figure.panels.empty()) return {};
  const std::string trouble = draw(figure, folder, "orders");
  Words words;
  words.body =
      "## Time step\n\n"
      "Error against what mechanics says, for steps of 1/30 to 1/480 s: order of convergence by "
      "least squares, and the error\n"
      "at the finest step. The ball and the ladder are compared with the integral of their "
      "equations of motion, the boxes with\n"
      "½ g (sin − μ cos) t², the cradle (restitution 1) with its first energy. Bullet's integrator "
      "is of first order:\n"
      "h^1 is what a solver can leave of it; none: the error does not shrink with the step.\n\n" +
      table.text() + picture(folderName, "orders", "error against time step") +
      (trouble.empty() ? "" : trouble + "\n\n");
  return words;
}

}  // namespace

Part timeStepPart(const Plan& plan) {
  Part part;
  part.name = folderName;
  for (const KnownMotion& known : knownMotions())
    part.units.push_back({known.scene, [&plan, known](const Progress& progress) {
                            return measureScene(known, plan, progress);
                          }});
  part.write = [&plan](const std::filesystem::path& report) { return writeTimeStep(plan, report); };
  return part;
}

}  // namespace demos::report
