#include <array>
#include <cmath>
#include <cstdio>

#include "delassus/release.h"
#include "demos/atlas/experiments.h"
#include "demos/atlas/figures.h"
#include "demos/atlas/sketches.h"
#include "demos/scenes/builders.h"

namespace demos::atlas {

using Eigen::Matrix2d;
using Eigen::Vector2d;

namespace {

constexpr std::array<double, 4> times = {0, 0.2, 0.4, 0.6};  // s
constexpr double metre = 56;                                 // pixels
constexpr Color wrong{0.70, 0.20, 0.16};

/// One of the paper's two surprises (§10) as it happens, and as the common rule expects it:
/// "contacts with a negative reaction are lost, the others are kept".
struct Surprise {
  std::array<Vector2d, 2> normals;
  Vector2d force;                                          ///< N, on 1 kg
  Vector2d forced;                                         ///< f, N
  std::array<Vector2d, times.size()> simulated, expected;  ///< the bead's centre, m
};

Surprise simulate(double cosine, double forceAngle) {
  Surprise surprise;
  const auto normals = angleNormals(cosine);
  for (std::size_t i = 0; i < 2; ++i) surprise.normals[i] = {normals[i].x(), normals[i].y()};
  surprise.force = beadForce * Vector2d(std::cos(forceAngle), std::sin(forceAngle));
  Matrix2d N;
  N << surprise.normals[0].transpose(), surprise.normals[1].transpose();
  surprise.forced = delassus::analyseRelease(N * N.transpose(), N * surprise.force).forced;

  // The common rule: the rest of the force when the contacts with a positive reaction are held
  // (here at most one).
  Vector2d acceleration = surprise.force;
  for (std::size_t i = 0; i < 2; ++i)
    if (surprise.forced[Eigen::Index(i)] > 0)
      acceleration -= surprise.normals[i] * surprise.normals[i].dot(surprise.force);

  const std::vector<Vector2d> track = trackBead(buildBeadInAngle(cosine, forceAngle), times.back());
  for (std::size_t i = 0; i < times.size(); ++i) {
    surprise.simulated[i] = track[std::size_t(std::lround(times[i] / timeStep))];
    surprise.expected[i] = acceleration * times[i] * (times[i] + timeStep) / 2;
  }
  return surprise;
}

/// The contacts that the bead still touches in the last frame.
std::string keptOf(const Surprise& surprise) {
  constexpr double touching = 1e-3;  // m
  std::string kept;
  for (std::size_t i = 0; i < 2; ++i)
    if (std::abs(surprise.normals[i].dot(surprise.simulated.back())) < touching)
      kept += (kept.empty() ? "" : " and ") + std::to_string(i + 1);
  return kept.empty() ? "none" : kept;
}

std::string newtons(double force) {
  char text[32];
  std::snprintf(text, sizeof text, "%s%.1f N", force < 0 ? "−" : "+", std::abs(force));
  return text;
}

std::string forcedOf(const Surprise& surprise) {
  return "f₁ = " + newtons(surprise.forced[0]) + ", f₂ = " + newtons(surprise.forced[1]);
}

void drawFrame(Canvas& canvas, const Surprise& surprise, std::size_t frame, const Point& corner,
               const Point& start) {
  constexpr double radius = 0.5 * metre;
  const Point size(228, 250);
  canvas.fill(rectangle(corner, size), tint(pale, 0.07));
  const Point bead = corner + start;
  const auto place = [&](const Vector2d& x) { return Point(bead + metre * AngleSketch::up(x)); };
  const AngleSketch planes{surprise.normals, bead, radius, 300};
  canvas.clipped(rectangle(corner, size), [&] {
    drawPlanes(canvas, planes);
    if (frame > 0) {
      canvas.stroke({bead, place(surprise.simulated[frame])}, {pale, 1.5});
      drawGhostBead(canvas, place(surprise.expected[frame]), radius, wrong);
    }
    drawBead(canvas, place(surprise.simulated[frame]), radius);
    if (frame == 0) {
      const Point tip = place(surprise.force * (2.2 / beadForce));
      canvas.arrow(bead, tip, {ink, 4});
      canvas.text(tip + Point(8, 2), "F", {20, ink, Align::Left, true});
      for (const int i : {0, 1})
        drawNumber(canvas, planes.contact(i) + 17 * (planes.contact(i) - bead).normalized(),
                   std::to_string(i + 1), wallColor);
    }
  });
  char time[16];
  std::snprintf(time, sizeof time, "%.1f s", times[frame]);
  canvas.text(corner + Point(size.x() - 8, 22), time, {16, pale, Align::Right});
}

struct Words {
  std::string heading, reactions, idea;
  Point ideaAt, factAt;  ///< labels in the last frame
};

void drawRow(Canvas& canvas, const Surprise& surprise, const Words& words, double top,
             const Point& start) {
  canvas.paragraph({40, top + 26}, 250, words.heading, {23, ink, Align::Left, true});
  canvas.paragraph({40, top + 100}, 250, words.reactions, {18});
  canvas.paragraph({40, top + 180}, 250, words.idea, {18, wrong});
  Point corner;
  for (std::size_t frame = 0; frame < times.size(); ++frame) {
    corner = {310 + 236.0 * double(frame), top};
    drawFrame(canvas, surprise, frame, corner, start);
  }
  canvas.text(corner + words.ideaAt, "common rule", {16, wrong, Align::Right, true});
  canvas.text(corner + words.factAt, "Bullet", {16, ink, Align::Right, true});
}

void draw(Canvas& canvas, const Surprise& narrow, const Surprise& wide) {
  canvas.text({40, 50}, "What intuition gets wrong: “a contact that would pull is lost”",
              {30, ink, Align::Left, true});
  drawRow(canvas, narrow,
          {"Both would pull,\nyet one is kept",
           "forced reactions:\n" + forcedOf(narrow),
           "dashed: the common rule,\nboth are lost",
           {220, 206},
           {130, 100}},
          92, {70, 110});
  drawRow(canvas, wide,
          {"One would push,\nyet both are lost",
           "forced reactions:\n" + forcedOf(wide),
           "dashed: the common rule,\n1 is kept",
           {220, 206},
           {134, 110}},
          382, {70, 150});
  canvas.paragraph({40, 682}, 1200,
                   "Both paradoxes of the paper (§10), simulated in Bullet on this solver: the "
                   "sign of a forced reaction, the one that holding both contacts would need, does "
                   "not tell whether its contact is kept.",
                   {19, pale});
}

}  // namespace

Figure intuition() {
  const double degree = M_PI / 180;
  const Surprise narrow = simulate(-0.5, -25 * degree), wide = simulate(0.5, 15 * degree);
  return {"intuition",
          {1280, 740},
          [=](Canvas& canvas) { draw(canvas, narrow, wide); },
          forcedOf(narrow) + ": kept " + keptOf(narrow) + "; " + forcedOf(wide) + ": kept " +
              keptOf(wide)};
}

}  // namespace demos::atlas
