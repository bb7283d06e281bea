#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "delassus/release.h"
#include "demos/atlas/experiments.h"
#include "demos/atlas/figures.h"
#include "demos/atlas/region_map.h"
#include "demos/atlas/sketches.h"

namespace demos::atlas {

using delassus::ReleaseAnalysis;
using delassus::Wall;
using Eigen::Matrix2d;
using Eigen::Vector2d;

namespace {

constexpr double weight = 9.81;   ///< of the rod, N
constexpr double halfLength = 2;  ///< of the rod, m
constexpr double duration = 1;    ///< of a load's way, s
constexpr int places = 24;        ///< of the load on its way; even, so that none lies at a crossing

/// A load that moves over a rod on supports at ±a.
struct Case {
  double a;  ///< m
  std::function<Load(double time)> load;
  double later;  ///< when the rod is shown a second time, s
};

/// 60 N walk from the middle to the right end.
Case walking() {
  return {1.3,
          [](double time) {
            return Load{halfLength * std::min(1.0, time / duration), -60};
          },
          1.12};
}

/// A hook that pulls up ever harder while it moves from right to left. Both forced reactions vanish
/// at the same time: the hook carries the whole rod just when it passes the middle. It asks for
/// f = s (0.18, 1), with s falling from 5 N to −5 N:
///
///     f1 + f2 = weight − up,   (f1 − f2) a = −up x
Case lifting() {
  constexpr double a = 1.7;
  return {a,
          [](double time) {
            const Vector2d f = 5 * (1 - 2 * time / duration) * Vector2d(0.18, 1);
            const double up = weight - f.sum();
            return Load{(f[1] - f[0]) * a / up, up};
          },
          0.95};
}

/// The forced reactions at each place of the load while the rod rests, the contacts that the solver
/// kept, and the point where M_Λ₁Λ₂ is left.
struct Trajectory {
  std::vector<SupportStep> steps;
  std::vector<Vector2d> forced;  ///< N
  double crossingTime = 0;       ///< s
  Vector2d crossing;             ///< N
  ReleaseAnalysis wall;          ///< of the crossing point
  RodPose later;
  int agree = 0;
};

/// Where the straight way between two places leaves M_Λ₁Λ₂, as a share of the way. If the reactions
/// vanish there together, both are zero.
std::pair<double, Vector2d> crossingOf(const Vector2d& before, const Vector2d& after) {
  constexpr double together = 1e-3;  // of the way: float's round-off is below it
  Vector2d share;
  for (int i = 0; i < 2; ++i)
    share[i] =
        after[i] < 0 ? before[i] / (before[i] - after[i]) : std::numeric_limits<double>::infinity();
  const double first = share.minCoeff();
  Vector2d crossing = before + first * (after - before);
  for (int i = 0; i < 2; ++i)
    if (share[i] <= first + together) crossing[i] = 0;
  return {first, crossing};
}

Trajectory follow(const Case& given) {
  Trajectory trajectory;
  const double interval = duration / places;
  for (int i = 0; i < places; ++i) {
    const SupportStep step = stepRodOnSupports(given.a, given.load((i + 0.5) * interval));
    const ReleaseAnalysis theory = delassus::analyseRelease(step.W, step.q);
    if ((theory.r - step.reaction).norm() <= keptTolerance * theory.forced.norm())
      ++trajectory.agree;
    trajectory.steps.push_back(step);
    trajectory.forced.emplace_back(theory.forced / timeStep);
  }
  const auto left = std::find_if(trajectory.forced.begin(), trajectory.forced.end(),
                                 [](const Vector2d& f) { return f.minCoeff() < 0; });
  const auto [share, crossing] = crossingOf(*(left - 1), *left);
  trajectory.crossing = crossing;
  trajectory.crossingTime = (double(left - trajectory.forced.begin()) - 0.5 + share) * interval;
  const Matrix2d& W = trajectory.steps.front().W;
  trajectory.wall = delassus::analyseRelease(W, -W * crossing);
  trajectory.later = runRodOnSupports(given.a, given.load, given.later);
  return trajectory;
}

std::string nameOf(Wall wall) {
  return wall == Wall::Face ? "a face" : wall == Wall::Edge ? "an edge" : "the vertex";
}

Color colorOf(const SupportStep& step) {
  const double none = keptTolerance * step.reaction.norm();
  return atlas::colorOf(std::vector<bool>{step.reaction[0] > none, step.reaction[1] > none});
}

/// Places in pixels from the origin of the map, y up.
struct Words {
  std::string heading;
  double scale;  ///< pixels a newton
  std::string crossing;
  Vector2d crossingAt;
  std::string load;  ///< at the crossing
  Vector2d both, first, second, none;
};

void drawLoad(Canvas& canvas, const Load& load, const Point& at, Color color) {
  constexpr double length = 58;
  const Point up(0, -1);
  if (load.up < 0)
    canvas.arrow(at + (8 + length) * up, at + 8 * up, {color, 4});
  else
    canvas.arrow(at, at + (8 + length) * up, {color, 4});
}

void drawScene(Canvas& canvas, const Case& given, const Trajectory& trajectory,
               const std::string& loadWords, const Point& middle) {
  constexpr double metre = 66;
  for (const int side : {1, -1}) {
    const Point top = middle + Point(side * given.a * metre, 0.1 * metre);
    drawSupport(canvas, top);
    canvas.text(top + Point(0, 21), side > 0 ? "1" : "2", {16, ink, Align::Centre, true});
  }
  const RodPose& later = trajectory.later;
  canvas.stroke(rodOutline(middle + metre * Point(later.x, 1 - later.y), later.angle,
                           halfLength * metre, 0.2 * metre),
                {pale, 1.8, true}, true);
  drawRod(canvas, middle, 0, halfLength * metre, 0.2 * metre);
  for (const double time : {0.1, 0.3}) {
    const Load load = given.load(time * duration);
    drawLoad(canvas, load, middle + Point(metre * load.x, 0), tint(pale, 0.45));
  }
  const Load load = given.load(trajectory.crossingTime);
  const Point at = middle + Point(metre * load.x, 0);
  drawLoad(canvas, load, at, ink);
  canvas.text(at - Point(0, 74), loadWords, {16, ink, Align::Centre});
}

void drawMap(Canvas& canvas, const Trajectory& trajectory, const Words& words,
             const Point& origin) {
  constexpr double halfSide = 205;
  RegionMap map(canvas, origin, halfSide, words.scale);
  const std::vector<Sector> sectors = regionsOf(trajectory.steps.front().W);
  for (const Sector& sector : sectors) map.fill(sector);
  for (const Sector& sector : sectors) map.ray(sector.from, {white, 2.5});
  map.axes("f₁", "f₂");

  const auto pixels = [&](const Vector2d& offset) {
    return Point(origin + Point(offset.x(), -offset.y()));
  };
  const auto label = [&](const Vector2d& at, const std::string& name, const std::string& kept) {
    canvas.text(pixels(at), name, {24, ink, Align::Centre, true});
    canvas.text(pixels(at) + Point(0, 23), kept, {16, ink, Align::Centre});
  };
  label(words.both, "M_{Λ₁Λ₂}", "both kept");
  label(words.first, "M_{Λ₁}", "only 1 kept");
  label(words.second, "M_{Λ₂}", "only 2 kept");
  label(words.none, "M_{l}", "both lost");

  const Point begin = map.at(trajectory.forced.front()), end = map.at(trajectory.forced.back());
  canvas.arrow(begin, end + 16 * (end - begin).normalized(), {ink, 2});
  for (std::size_t i = 0; i < trajectory.forced.size(); ++i)
    canvas.dot(map.at(trajectory.forced[i]), 4, colorOf(trajectory.steps[i]));
  canvas.circle(map.at(trajectory.crossing), 12, {ink, 3});
  canvas.text(pixels(words.crossingAt), "through " + nameOf(trajectory.wall.wall),
              {17, ink, Align::Left, true});
  canvas.paragraph(pixels(words.crossingAt) + Point(0, 23), 190, words.crossing, {16});
}

void draw(Canvas& canvas, const std::array<Case, 2>& cases,
          const std::array<Trajectory, 2>& trajectories, const std::string& agreement) {
  canvas.text({40, 50}, "A load moves over a rod: which support lets go?",
              {30, ink, Align::Left, true});
  const std::array<Words, 2> words = {Words{"A weight walks past support 1",
                                            2.2,
                                            "f₂ alone vanishes:\nexactly 2 is lost",
                                            {22, -58},
                                            "60 N",
                                            {95, 160},
                                            {80, -160},
                                            {-105, 90},
                                            {-105, -100}},
                                      Words{"A hook lifts ever harder, moving left",
                                            33,
                                            "f₁ and f₂ vanish at\nonce, yet 1 is kept",
                                            {15, -50},
                                            "9.8 N, the weight of the rod",
                                            {110, 110},
                                            {105, -160},
                                            {-105, 90},
                                            {-120, -120}}};
  for (std::size_t i = 0; i < 2; ++i) {
    const double x = i == 0 ? 330 : 950;
    canvas.text({x, 102}, words[i].heading, {22, ink, Align::Centre, true});
    drawScene(canvas, cases[i], trajectories[i], words[i].load, {x, 215});
    drawMap(canvas, trajectories[i], words[i], {x, 525});
  }
  canvas.paragraph({40, 790}, 1200,
                   "Leaving a region through a face releases exactly one contact; through the "
                   "vertex, what comes next must be computed (§10); dots are Bullet steps of the "
                   "resting rod in the colour of what was kept (" +
                       agreement + "), dashed is the rod a moment later.",
                   {18, pale});
}

}  // namespace

Figure movingLoad() {
  const std::array<Case, 2> cases = {walking(), lifting()};
  const std::array<Trajectory, 2> trajectories = {follow(cases[0]), follow(cases[1])};
  const std::string agreement = std::to_string(trajectories[0].agree + trajectories[1].agree) +
                                " of " + std::to_string(2 * places) + " steps agree";
  return {"moving_load",
          {1280, 840},
          [=](Canvas& canvas) { draw(canvas, cases, trajectories, agreement); },
          agreement + "; the weight leaves through " + nameOf(trajectories[0].wall.wall) +
              ", the hook through " + nameOf(trajectories[1].wall.wall)};
}

}  // namespace demos::atlas
