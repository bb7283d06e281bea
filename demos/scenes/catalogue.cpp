#include "demos/scenes/catalogue.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "demos/scenes/benchmarks.h"
#include "demos/scenes/builders.h"
#include "demos/scenes/force_plate.h"
#include "demos/scenes/wall_and_ball.h"

namespace demos {

namespace {

constexpr double degree = M_PI / 180;

/// Steps with an explicit tension T are stable while h ω < 2. For links of mass m and length L that
/// zigzag, ω² = 12 T/(m L). With T = 1.6 · 981 N, 0.1 kg and 0.5 m that asks for 306 Hz with any
/// solver.
constexpr double chainRate = 480;

Camera seenFrom(double x, double y, double z, double targetY = 1, double fov = 40) {
  return {vec3(x, y, z), vec3(0, targetY, 0), fov};
}

/// The bodies of the paper, and two more whose answer is known in closed form.
void addPaperScenes(std::vector<SceneDescription>& scenes) {
  const Camera close = seenFrom(0, 0.5, 5, 0);
  scenes.push_back(
      {"bead_under_plane", "frictionless bead hung under an inclined plane by nothing", 1, close,
       "forced reaction f < 0: released at once, free fall y = -g t^2/2 (paper, 6)", [] {
         const double lean = 20 * degree;
         return buildBead({vec3(std::sin(lean), -std::cos(lean), 0)}, vec3(0, -beadForce, 0));
       }});
  scenes.push_back(
      {"bead_in_angle", "bead in a narrow angle (n1.n2 = -0.5), pulled so that f1 < 0 and f2 < 0",
       1, close,
       "both forced reactions are negative and yet the first contact persists (paper, 10)",
       [] { return buildBeadInAngle(-0.5, -25 * degree); }});
  scenes.push_back({"bead_in_angle_wide",
                    "bead in a wide angle (n1.n2 = 0.5), pulled so that f1 > 0 > f2", 1, close,
                    "one forced reaction is positive and yet both contacts are lost (paper, 10)",
                    [] { return buildBeadInAngle(0.5, 15 * degree); }});
  scenes.push_back({"bead_in_trihedron",
                    "bead in a corner of three planes, pressed on one of them and lifted", 1, close,
                    "the region that keeps one contact and releases two, of eight (paper, 11)",
                    [] { return buildBeadInTrihedron(0.4, vec3(-0.92, 0.1, 0)); }});
  scenes.push_back(
      {"rod_on_supports", "frictionless rod on two wide supports (B < 0), one end pulled up", 0.5,
       seenFrom(0, 2, 8),
       "the support under the pulled end is released at once, the other persists (paper, 7)",
       [] { return buildRodOnSupports(1.5, 0.8 * 9.81); }});
  scenes.push_back(
      {"ball_off_ball", "frictionless ball sliding off a fixed ball from 3 degrees beside the top",
       2, seenFrom(0, 1, 6, 0),
       "leaves where cos(theta) = 2/3 cos(theta_0), with an error in proportion to the step",
       [] { return buildBallOffBall(3 * degree); }});
  scenes.push_back({"sliding_ladder",
                    "rod sliding down a frictionless wall and floor from 75 degrees", 1.5,
                    seenFrom(1, 1, 6, 0.7),
                    "leaves the wall when its centre has sunk to 2/3 of its first height",
                    [] { return buildSlidingLadder(75 * degree); }});
}

void addFrictionScenes(std::vector<SceneDescription>& scenes) {
  scenes.push_back(
      {"incline",
       "two boxes on slopes one degree below and above the friction angle",
       10,
       {btVector3(6, 6, 16), btVector3(2, -1, 2), 40},
       "the first creeps less than 1e-6 m; the second accelerates at g (sin - mu cos)",
       [] {
         return buildInclines({{frictionAngle() - degree, 0}, {frictionAngle() + degree, 0}});
       }});
  scenes.push_back(
      {"force_plate", "load gliding over a table on four feet", 5, seenFrom(1.2, 1.6, 4, 0.4),
       "the feet carry the force and the moments of statics, to 1e-6 of the weight",
       buildForcePlate, 60,
       Law{"force and moments under the feet against statics, largest error by the weight",
           footForceError}});
  scenes.push_back({"box_headings", "twelve boxes pushed outwards in twelve directions", 3,
                    seenFrom(0, 16, 14, 0),
                    "all stop on one circle, v^2/(2 mu g) further out: friction is a round cone",
                    [] { return buildBoxHeadings(12, 4); }});
  scenes.push_back(
      {"rolling_balls",
       "five balls with rolling friction of 0.2 to 0.04 m; the last weighs 100 kg",
       6,
       {btVector3(4, 7, 14), btVector3(4, 0, -1), 40},
       "each rolls out after v^2 R/(10/7 kappa g), whatever its mass, and stays",
       [] {
         return buildRollingBalls({{0.2, 1}, {0.1, 1}, {0.06, 1}, {0.04, 1}, {0.04, 100}}, 3);
       }});
}

void addBoxScenes(std::vector<SceneDescription>& scenes) {
  scenes.push_back({"one_box", "one box at rest on the ground", 3, seenFrom(3, 2, 5, 0.5),
                    "stays; four reactions of a quarter of its weight each",
                    [] { return buildGridOfBoxes(1, 3); }});
  scenes.push_back({"islands_100", "a hundred separate boxes, 10 x 10, 3 m apart", 3,
                    seenFrom(20, 22, 35, 0), "a hundred islands, all at rest",
                    [] { return buildGridOfBoxes(10, 3); }});
  scenes.push_back({"stack_10", "ten boxes of 1 kg one on the other", 10, seenFrom(10, 6, 16, 5),
                    "stands; the ground carries the weight of all",
                    [] { return buildStack(10, 1); }});
  scenes.push_back({"stack_10_heavy_top", "nine boxes of 1 kg under one of 1000 kg", 10,
                    seenFrom(10, 6, 16, 5), "stands within 0.5 mm for 10 s",
                    [] { return buildStack(10, 1000); }});
  scenes.push_back({"stack_40", "forty boxes one on the other", 10, seenFrom(30, 22, 55, 20),
                    "stands within 0.5 mm for 10 s", [] { return buildStack(40, 1); }});
  for (const int base : {10, 20, 50, 100}) {
    const std::string count = std::to_string(base);
    scenes.push_back(
        {"pyramid_" + count,
         "flat pyramid of " + std::to_string(base * (base + 1) / 2) + " boxes on a row of " + count,
         base >= 50 ? 3.0 : 5.0, seenFrom(0.3 * base, 0.7 * base, 2 * base, 0.4 * base), "stands",
         [base] { return buildPyramid(base); }});
  }
  scenes.push_back({"wall_20x10", "wall of 200 bricks of 2 kg, head joints open", 5,
                    seenFrom(12, 10, 50, 5), "stands", [] { return buildWall(20, 10); }});
  scenes.push_back({"wall_and_ball", "ball of 50 kg thrown at a wall of 24 bricks of 2 kg", 2,
                    seenFrom(6, 4, 9, 2),
                    "breaks through; what the ball loses of its momentum the bricks get",
                    [] { return buildWallAndBall(6, 4, Throw()); }});
  scenes.push_back({"arch", "semicircular arch of 21 voussoirs, thickness 1.0 m, radius 5 m", 10,
                    seenFrom(0, 4, 20, 2.5),
                    "stands: its line of thrust stays inside (a semicircle needs 0.54 m)",
                    [] { return buildArch(21, 1); }});
  scenes.push_back({"arch_thin", "the same arch, 0.6 m thick", 10, seenFrom(0, 4, 20, 2.5),
                    "stands, with 3 cm to spare on either side",
                    [] { return buildArch(21, 0.6); }});
  scenes.push_back({"card_house", "house of cards of three storeys", 10, seenFrom(4, 5, 18, 3),
                    "stands", [] { return buildCardHouse(3); }});
  scenes.push_back({"domino_run", "forty dominoes, the first leaning on its edge", 10,
                    seenFrom(0, 10, 45), "all fall; no energy is gained",
                    [] { return buildDominoRun(40); }});
  scenes.push_back({"compactor",
                    "72 boxes of half a metre in a bin, one wall of which closes at 0.5 m/s",
                    7,
                    {vec3(1.5, 4, 9), vec3(-0.2, 1.3, 0), 40},
                    "no solution where they jam: they give a little, none is thrown out",
                    [] { return buildCompactor(72); }});
}

void addRoundAndHungScenes(std::vector<SceneDescription>& scenes) {
  scenes.push_back({"spheres_bin", "a thousand spheres poured into a bin of 10 x 10 m", 5,
                    seenFrom(18, 16, 24, 3), "comes to rest; no energy is gained",
                    [] { return buildSpheresBin(10); }});
  scenes.push_back({"heavy_ball_chain", "100 kg ball on twenty links of 0.1 kg, swung at a wall", 6,
                    seenFrom(0, 8, 30, 7),
                    "the chain stretches less than a thousandth of its length",
                    [] { return buildHeavyBallChain(20, 100); }, chainRate});
  scenes.push_back({"plank_bridge",
                    "crate of 100 kg dropped on eight taut planks of 2 kg",
                    6,
                    {vec3(5, 5, 12), vec3(0, 2.3, 0), 40},
                    "sags, and carries the crate at rest",
                    [] { return buildPlankBridge(8, 100); }});
  scenes.push_back({"newton_cradle", "five hung balls, restitution 1, one let go from 45 degrees",
                    5, seenFrom(0, 2.5, 10, 2.5),
                    "no energy is gained; the strings keep their length",
                    [] { return buildNewtonCradle(5); }});
  scenes.push_back({"ragdolls", "twenty ragdolls of hinges and cone-twists", 5,
                    seenFrom(8, 6, 16, 1), "fall to rest with their joints closed",
                    [] { return buildRagdolls(20); }});
  scenes.push_back({"gripper", "two driven fingers lift a box by friction", 4,
                    seenFrom(4, 3, 9, 1.2), "the box rises 1 m with the fingers and does not slip",
                    [] { return buildGripper(); }});
  scenes.back().driven = true;
}

/// The scenes of Bullet's own benchmark, and its vehicle.
void addBenchmarkScenes(std::vector<SceneDescription>& scenes) {
  scenes.push_back({"benchmark_boxes", "3008 boxes falling in 47 layers (Bullet's benchmark 1)", 20,
                    seenFrom(60, 90, 200, 50), "none falls through; no energy is gained",
                    buildBenchmarkBoxes});
  scenes.push_back({"benchmark_town",
                    "pyramid, three walls and a round tower of 1076 boxes (benchmark 2)", 20,
                    seenFrom(20, 35, 75, 8), "stands", buildBenchmarkTown});
  scenes.push_back({"benchmark_ragdolls", "136 ragdolls falling (benchmark 3)", 20,
                    seenFrom(50, 70, 160, 45), "fall to rest with their joints closed",
                    buildBenchmarkRagdolls});
  scenes.push_back({"benchmark_hulls", "960 barrels, convex hulls, falling (benchmark 4)", 20,
                    seenFrom(50, 60, 130, 30), "none falls through; no energy is gained",
                    buildBenchmarkHulls});
  scenes.push_back({"voronoi_cells",
                    "a block of stone, broken in 90 Voronoi cells, falls (benchmark 8)", 20,
                    seenFrom(10, 9, 18, 2.5), "none falls through; no energy is gained",
                    [] { return buildVoronoiCells(90, 1); }});
  scenes.push_back({"vehicle_on_planks",
                    "raycast vehicle of 800 kg drives over a mound of planks and brakes",
                    20,
                    {vec3(4, 9, 30), vec3(6, 0, 0), 40},
                    "crosses without touching them: wheels are rays, which weigh on nothing; the "
                    "planks stay",
                    buildVehicleOnPlanks});
}

}  // namespace

const std::vector<SceneDescription>& catalogue() {
  static const std::vector<SceneDescription> scenes = [] {
    std::vector<SceneDescription> all;
    addPaperScenes(all);
    addFrictionScenes(all);
    addBoxScenes(all);
    addRoundAndHungScenes(all);
    addBenchmarkScenes(all);
    return all;
  }();
  return scenes;
}

int editDistance(const std::string& a, const std::string& b) {
  // One row of Levenshtein's table at a time.
  std::vector<int> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    int diagonal = row[0];
    row[0] = int(i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const int replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({replaced, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row.back();
}

const SceneDescription& findScene(const std::string& name) {
  const auto& scenes = catalogue();
  const auto byDistance = [&name](const SceneDescription& a, const SceneDescription& b) {
    return editDistance(a.name, name) < editDistance(b.name, name);
  };
  const SceneDescription& nearest = *std::min_element(scenes.begin(), scenes.end(), byDistance);
  if (nearest.name == name) return nearest;
  const bool isLikely = 3 * editDistance(nearest.name, name) <= int(nearest.name.size());
  throw UnknownScene("there is no scene '" + name + "'" +
                     (isLikely ? "; did you mean '" + nearest.name + "'?" : "") +
                     " ('delassus scenes' lists all)");
}

}  // namespace demos
