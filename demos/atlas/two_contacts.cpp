#include <Eigen/LU>
#include <cmath>

#include "delassus/release.h"
#include "demos/atlas/experiments.h"
#include "demos/atlas/figures.h"
#include "demos/atlas/region_map.h"
#include "demos/atlas/sketches.h"
#include "demos/scenes/builders.h"

namespace demos::atlas {

using Eigen::Matrix2d;
using Eigen::Vector2d;

namespace {

constexpr double degree = M_PI / 180;
constexpr int directions = 120;
constexpr const char* stock = "si:10";

/// A bead between two planes, pulled in one direction: the opening velocities of theory and of
/// Bullet, as parts of h F.
struct Direction {
  Vector2d forced;  ///< unit direction in the plane of forced reactions
  Vector2d theory, ours, stock;
};

struct Angle {
  double opening;  ///< between the planes, degrees
  Matrix2d W;
  std::vector<Direction> measured;
};

bool asTheRegionSays(const Direction& direction) {
  return (direction.ours - direction.theory).lpNorm<Eigen::Infinity>() <= keptTolerance;
}

bool stockDiffers(const Direction& direction) {
  return fatesOf(direction.stock) != fatesOf(direction.theory);
}

Angle measure(double opening) {
  const auto pair = angleNormals(-std::cos(opening * degree));
  const std::vector<btVector3> normals(pair.begin(), pair.end());
  const double c = normals[0].dot(normals[1]);
  Angle angle{opening, (Matrix2d() << 1, c, c, 1).finished(), {}};
  for (int i = 0; i < directions; ++i) {
    // Half a spacing aside, so that no direction lies on a wall of a region.
    const double turn = (i + 0.5) * 2 * M_PI / directions;
    Direction direction;
    direction.forced = {std::cos(turn), std::sin(turn)};
    // The force that asks for these reactions (paper §9): F = −(f1 n1 + f2 n2).
    const btVector3 against =
        normals[0] * btScalar(direction.forced[0]) + normals[1] * btScalar(direction.forced[1]);
    const btVector3 force = against.normalized() * btScalar(-beadForce);
    direction.theory =
        delassus::analyseRelease(angle.W, -angle.W * direction.forced / against.length()).u;
    direction.ours = stepBead(normals, force, "delassus");
    direction.stock = stepBead(normals, force, stock);
    angle.measured.push_back(direction);
  }
  return angle;
}

/// One colour for each set of kept contacts; ink for a case unknown to the theory: a contact that
/// sinks in.
Color colorOf(const Vector2d& openings) {
  std::vector<bool> persisting;
  for (const Fate fate : fatesOf(openings)) {
    if (fate == Fate::Sunk) return ink;
    persisting.push_back(fate == Fate::Kept);
  }
  return atlas::colorOf(persisting);
}

/// The words about one of the two angles. Places in pixels from the origin of its map, y up.
struct Labels {
  std::string heading, subheading;
  Vector2d both, first, second, none;
  Vector2d noneLeader{0, 0};  ///< end of a line from the label of M_l, if that lies outside
  Vector2d surpriseFrom, surpriseTo, surpriseAt, surpriseLeader;
  std::string surprise;
  std::string stock;
};

void label(Canvas& canvas, const Point& at, const std::string& name, const std::string& words) {
  canvas.text(at, name, {25, ink, Align::Centre, true});
  canvas.text(at + Point(0, 24), words, {17, ink, Align::Centre});
}

void drawMap(Canvas& canvas, const Angle& angle, const Labels& labels, const Point& origin) {
  constexpr double halfSide = 235, ring = 160, outerRing = 180;
  RegionMap map(canvas, origin, halfSide, 1);
  const std::vector<Sector> sectors = regionsOf(angle.W);
  for (const Sector& sector : sectors) map.fill(sector);
  for (const Sector& sector : sectors) map.ray(sector.from, {white, 2.5});
  map.axes("f₁", "f₂");

  for (const Direction& direction : angle.measured) {
    canvas.dot(map.at(ring * direction.forced), 4, colorOf(direction.ours));
    if (stockDiffers(direction))
      canvas.diamond(map.at(outerRing * direction.forced), 6, colorOf(direction.stock));
  }

  label(canvas, map.at(labels.both), "M_{Λ₁Λ₂}", "both kept");
  label(canvas, map.at(labels.first), "M_{Λ₁}", "only 1 kept");
  label(canvas, map.at(labels.second), "M_{Λ₂}", "only 2 kept");
  label(canvas, map.at(labels.none), "M_{l}", "both lost");
  if (labels.noneLeader.norm() > 0)
    canvas.stroke({map.at(labels.none - Vector2d(-10, 32)), map.at(labels.noneLeader)}, {ink, 1.4});

  // The part that contradicts the common rule (§10).
  const Path surprise = map.arc(labels.surpriseFrom, labels.surpriseTo, outerRing - 4);
  canvas.stroke(surprise, {ink, 4});
  canvas.stroke({surprise[surprise.size() / 2], map.at(labels.surpriseLeader)}, {ink, 1.4});
  canvas.paragraph(map.at(labels.surpriseAt), halfSide, labels.surprise,
                   {16, ink, Align::Left, true});
  canvas.paragraph(map.at({halfSide - 8, halfSide - 22}), 110, labels.stock,
                   {16, ink, Align::Right, true});
}

void drawHeading(Canvas& canvas, const Angle& angle, const Labels& labels, const Point& corner) {
  AngleSketch sketch{uprightAngle(angle.opening * degree), {0, 0}, 16, 26};
  sketch.bead = corner + Point(48, 40);
  drawPlanes(canvas, sketch);
  drawBead(canvas, sketch.bead, sketch.radius);
  canvas.text(sketch.bead + Point(26, -14), "1", {15, ink, Align::Left, true});
  canvas.text(sketch.bead + Point(-26, -14), "2", {15, ink, Align::Right, true});
  canvas.text(corner + Point(125, 34), labels.heading, {23, ink, Align::Left, true});
  canvas.text(corner + Point(125, 64), labels.subheading, {17, pale});
}

void draw(Canvas& canvas, const Angle& narrow, const Angle& wide, const std::string& agreement) {
  canvas.text({40, 50}, "Two contacts: which of them does the motion keep?",
              {30, ink, Align::Left, true});
  const auto edge = [](const Angle& angle, int i) -> Vector2d { return -angle.W.inverse().col(i); };
  const Labels ofNarrow{"A bead in a narrow angle (30°)",
                        "W = [[A₁, B], [B, A₂]] with B < 0",
                        {80, 70},
                        {78, -62},
                        {-85, 70},
                        {-188, -98},
                        {-168, -166},
                        edge(narrow, 1),
                        {0, -1},
                        {9, -200},
                        {5, -193},
                        "both reactions negative,\nyet 1 is kept",
                        "stock Bullet\nsinks into\na plane"};
  const Labels ofWide{"A bead in a wide angle (150°)",
                      "the same with B > 0",
                      {75, 70},
                      {97, -26},
                      {-54, 118},
                      {-65, -75},
                      {0, 0},
                      {0, -1},
                      edge(wide, 1),
                      {10, -203},
                      {44, -187},
                      "f₁ is positive,\nyet both are lost",
                      "stock Bullet\nloses 1"};
  drawHeading(canvas, narrow, ofNarrow, {75, 75});
  drawHeading(canvas, wide, ofWide, {705, 75});
  drawMap(canvas, narrow, ofNarrow, {320, 440});
  drawMap(canvas, wide, ofWide, {950, 440});

  const double legend = 720;
  canvas.dot({66, legend - 6}, 5, keptFirst);
  canvas.dot({51, legend - 6}, 5, keptAll);
  canvas.text({82, legend}, "one Bullet step on this solver, in the colour of what it kept", {18});
  canvas.diamond({694, legend - 6}, 7, keptSecond);
  canvas.text({712, legend}, "stock Bullet (SI, 10 sweeps) where its outcome differs", {18});
  canvas.paragraph({40, 766}, 1200,
                   "The forced reactions (f₁, f₂), those that holding both contacts would need, "
                   "fall into four regions, drawn from W, that tell what the motion keeps: " +
                       agreement,
                   {19, pale});
}

}  // namespace

Figure twoContacts() {
  const Angle narrow = measure(30), wide = measure(150);
  int agree = 0, total = 0, stockWrong = 0;
  for (const Angle* angle : {&narrow, &wide})
    for (const Direction& direction : angle->measured) {
      ++total;
      agree += asTheRegionSays(direction) ? 1 : 0;
      stockWrong += stockDiffers(direction) ? 1 : 0;
    }
  const std::string agreement =
      std::to_string(agree) + " of " + std::to_string(total) + " simulated directions agree";
  return {"two_contacts",
          {1280, 820},
          [=](Canvas& canvas) { draw(canvas, narrow, wide, agreement + "."); },
          agreement + "; " + stock + " differs in " + std::to_string(stockWrong)};
}

}  // namespace demos::atlas
