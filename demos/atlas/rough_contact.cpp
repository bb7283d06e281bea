#include <array>
#include <cmath>
#include <utility>

#include "delassus/one_contact.h"
#include "demos/atlas/experiments.h"
#include "demos/atlas/figures.h"
#include "demos/atlas/region_map.h"
#include "demos/atlas/sketches.h"
#include "demos/scenes/builders.h"

namespace demos::atlas {

using delassus::Mat3;
using delassus::Vec3;
using Eigen::Matrix2d;
using Eigen::Vector2d;

namespace {

constexpr LeaningRod rod{60 * M_PI / 180, 0.5};
constexpr int directions = 120;
constexpr double ring = 195, halfSide = 270;

/// The plane of the figure: tangential reaction to the right, normal reaction up.
struct Direction {
  Vector2d forced;
  Vec3 theory, ours;  ///< relative velocity of the rod's end: normal, then tangential, m/s
};

struct Measured {
  Mat3 W;
  std::vector<Direction> directions;
  int agree = 0;
  double scale = 0;  ///< velocity scale of the test whether a contact moves, m/s
};

/// W of normal and tangent, with the tangent first as in the figure.
Matrix2d inPlane(const Mat3& W) {
  return (Matrix2d() << W(1, 1), W(1, 0), W(0, 1), W(0, 0)).finished();
}

Measured measure() {
  Measured measured;
  measured.W = stepLeaningRod(rod, {0, 0}).W;
  const Matrix2d W = inPlane(measured.W);
  measured.scale = timeStep * beadForce;
  for (int i = 0; i < directions; ++i) {
    const double turn = (i + 0.5) * 2 * M_PI / directions;
    Direction direction;
    direction.forced = {std::cos(turn), std::sin(turn)};
    // q = h F for 1 kg, and q = −W f.
    const Vector2d force = -(W * direction.forced).normalized() * beadForce;
    const RodStep step = stepLeaningRod(rod, force);
    direction.ours = step.u;
    direction.theory = step.W * delassus::solveOneContact(step.W, step.q, rod.friction) + step.q;
    if ((direction.ours - direction.theory).lpNorm<Eigen::Infinity>() <=
        keptTolerance * measured.scale)
      ++measured.agree;
    measured.directions.push_back(direction);
  }
  return measured;
}

Color colorOf(const Vec3& u, double scale) {
  if (fateOf(u[0] / scale) == Fate::Released) return keptNone;
  if (std::abs(u[1]) <= keptTolerance * scale) return keptAll;
  return u[1] < 0 ? keptFirst : keptSecond;
}

/// Where the regions meet, counter-clockwise, from W and μ: the two edges of Coulomb's cone, and
/// the line (W f)_n = 0 on which the free motion neither opens the contact nor closes it.
std::array<Vector2d, 4> boundariesOf(const Measured& measured) {
  const Vector2d release(measured.W(0, 0), -measured.W(0, 1));
  return {Vector2d(rod.friction, 1), Vector2d(-rod.friction, 1), -release, release};
}

/// The regions between them, by the exact solver of one contact. Released is half a plane, in two
/// parts that meet on the axis.
std::vector<Sector> regionsOf(const Measured& measured) {
  const auto [right, left, releaseLeft, releaseRight] = boundariesOf(measured);
  const Vector2d down(0, -1);
  std::vector<Sector> sectors;
  for (const auto& [from, to] :
       {std::pair(right, left), std::pair(left, releaseLeft), std::pair(releaseLeft, down),
        std::pair(down, releaseRight), std::pair(releaseRight, right)}) {
    Sector sector{from, to, {}, ""};
    const Vector2d inPlaneQ = -inPlane(measured.W) * sector.middle();
    const Vec3 q(inPlaneQ[1], inPlaneQ[0], 0);
    const Vec3 r = delassus::solveOneContact(measured.W, q, rod.friction);
    sector.color = colorOf(measured.W * r + q, q.norm());
    sectors.push_back(sector);
  }
  return sectors;
}

void drawMap(Canvas& canvas, const Measured& measured, const Point& origin) {
  RegionMap map(canvas, origin, halfSide, 1);
  for (const Sector& sector : regionsOf(measured)) map.fill(sector);
  for (const Vector2d& boundary : boundariesOf(measured)) map.ray(boundary, {white, 2.5});
  map.axes("f_{t}", "f_{n}");
  for (const Direction& direction : measured.directions)
    canvas.dot(map.at(ring * direction.forced), 4, colorOf(direction.ours, measured.scale));

  const TextStyle name{25, ink, Align::Centre, true};
  canvas.text(map.at({-56, 222}), "stuck", name);
  canvas.text(map.at({191, 218}), "slides left", name);
  canvas.text(map.at({-92, 32}), "slides right", name);
  canvas.text(map.at({72, -95}), "released", name);

  // Where the sign of f_n alone says the opposite of the theory.
  const Vector2d release = boundariesOf(measured).back();
  const TextStyle surprise{16, ink, Align::Left, true};
  const Path lost = map.arc({1, 0}, release, ring + 16);
  canvas.stroke(lost, {ink, 4});
  canvas.paragraph(map.at({72, 36}), 120, "f_{n} > 0,\nyet released", surprise);
  const Path held = map.arc({-1, 0}, -release, ring + 16);
  canvas.stroke(held, {ink, 4});
  canvas.paragraph(map.at({-178, -30}), 150, "f_{n} < 0,\nyet slides", surprise);
}

void drawSketch(Canvas& canvas, const Point& tip) {
  constexpr double halfLength = 95;
  const Point centre = tip + halfLength * Point(std::cos(rod.lean), -std::sin(rod.lean));
  drawGround(canvas, tip - Point(150, 0), tip + Point(250, 0), 14);
  drawRod(canvas, centre, rod.lean, halfLength, 15);
  canvas.arrow(tip, tip + Point(0, -85), {keptAll, 4});
  canvas.text(tip + Point(-14, -66), "f_{n}", {22, keptAll, Align::Right, true});
  canvas.arrow(tip, tip + Point(85, 0), {keptAll, 4});
  canvas.text(tip + Point(94, -8), "f_{t}", {22, keptAll, Align::Left, true});
  canvas.arrow(centre, centre + Point(70, 52), {ink, 3});
  canvas.text(centre + Point(78, 62), "force, turned through 360°", {18});
}

void draw(Canvas& canvas, const Measured& measured) {
  canvas.text({40, 50}, "One contact with friction: released, stuck or sliding",
              {30, ink, Align::Left, true});
  drawMap(canvas, measured, {345, 405});
  canvas.text({720, 125}, "A rod leaning on rough ground (μ = 0.5)", {23, ink, Align::Left, true});
  drawSketch(canvas, {875, 350});

  struct Entry {
    Color color;
    std::string words;
  };
  double line = 440;
  for (const Entry& entry : {Entry{keptAll, "stuck: f lies in Coulomb's cone, |f_{t}| ≤ μ f_{n}"},
                             Entry{keptFirst, "slides to the left: f lies right of the cone"},
                             Entry{keptSecond, "slides to the right: f lies left of the cone"},
                             Entry{keptNone, "released: the free motion opens, −(W f)_{n} > 0"}}) {
    canvas.dot({728, line - 6}, 7, entry.color);
    canvas.text({746, line}, entry.words, {19});
    line += 40;
  }
  canvas.paragraph({720, line + 20}, 500,
                   "The rod turns when it is pushed at its end: W couples normal and tangent and "
                   "tilts the border "
                   "of the released region.",
                   {18, pale});
  canvas.paragraph(
      {40, 766}, 1200,
      "The forced reaction (f_{t}, f_{n}), the one that would hold the end still, tells what the "
      "end does: " +
          std::to_string(measured.agree) + " of " + std::to_string(directions) +
          " Bullet steps on this solver (dots) end as their region, drawn from W and μ, says.",
      {19, pale});
}

}  // namespace

Figure oneRoughContact() {
  const Measured measured = measure();
  return {"rough_contact",
          {1280, 820},
          [=](Canvas& canvas) { draw(canvas, measured); },
          std::to_string(measured.agree) + " of " + std::to_string(directions) +
              " simulated directions agree"};
}

}  // namespace demos::atlas
