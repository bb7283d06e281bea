#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>

#include "delassus/release.h"
#include "demos/atlas/experiments.h"
#include "demos/atlas/figures.h"
#include "demos/atlas/region_map.h"
#include "demos/atlas/sketches.h"
#include "demos/scenes/builders.h"

namespace demos::atlas {

using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

constexpr double height = 0.4;  ///< of each plane's normal: how steep the corner is
constexpr int directions = 900;
constexpr double radius = 250;  ///< of the sphere, pixels

/// One of the eight trihedra, in the space of forces on the bead.
struct Trihedron {
  std::vector<Vector3d> edges;
  std::vector<bool> persisting;
};

struct Pull {
  Vector3d direction;
  std::vector<bool> kept;
};

struct Corner {
  Matrix3d N;  ///< rows: the normals
  std::vector<Trihedron> regions;
  std::vector<Pull> pulls;
  int agree = 0;
};

/// Held contacts press the force out through their normals; lost ones leave along the edge of the
/// other two. With 1 kg and F = −Nᵀ f, the edges e_i and −W⁻¹e_j of the paper (§11) are −n_i and
/// N⁻¹e_j.
std::vector<Trihedron> regionsOf(const Matrix3d& N) {
  const Matrix3d opening = N.inverse();
  std::vector<Trihedron> regions;
  for (int held = 0; held < 8; ++held) {
    Trihedron region;
    Vector3d middle(0, 0, 0);
    for (int i = 0; i < 3; ++i) {
      region.edges.push_back((held >> i & 1) != 0 ? Vector3d(-N.row(i))
                                                  : Vector3d(opening.col(i).normalized()));
      middle += region.edges.back();
    }
    region.persisting = delassus::analyseRelease(N * N.transpose(), N * middle).persisting;
    regions.push_back(region);
  }
  return regions;
}

Corner measure() {
  const auto given = trihedronNormals(height);
  const std::vector<btVector3> normals(given.begin(), given.end());
  Corner corner;
  for (int i = 0; i < 3; ++i)
    corner.N.row(i) << normals[std::size_t(i)].x(), normals[std::size_t(i)].y(),
        normals[std::size_t(i)].z();
  corner.regions = regionsOf(corner.N);
  const Matrix3d W = corner.N * corner.N.transpose();
  for (int i = 0; i < directions; ++i) {
    // Fibonacci's spiral: directions spread evenly over the sphere.
    const double y = 1 - (2.0 * i + 1) / directions, turn = i * M_PI * (3 - std::sqrt(5.0));
    Pull pull;
    pull.direction = {std::sqrt(1 - y * y) * std::cos(turn), y,
                      std::sqrt(1 - y * y) * std::sin(turn)};
    const btVector3 force = vec3(pull.direction.x(), pull.direction.y(), pull.direction.z());
    const delassus::VectorXd openings = stepBead(normals, force * btScalar(beadForce), "delassus");
    const auto theory = delassus::analyseRelease(W, corner.N * pull.direction);
    if ((openings - theory.u).lpNorm<Eigen::Infinity>() <= keptTolerance) ++corner.agree;
    for (const Fate fate : fatesOf(openings)) pull.kept.push_back(fate == Fate::Kept);
    corner.pulls.push_back(pull);
  }
  return corner;
}

/// A sphere of directions seen from afar: rows are right, up, and towards the eye.
struct View {
  Matrix3d axes;
  Point centre;

  Point at(const Vector3d& direction) const {
    return centre + radius * Point(axes.row(0).dot(direction), -axes.row(1).dot(direction));
  }
  double depth(const Vector3d& direction) const { return axes.row(2).dot(direction); }
};

View lookFrom(const Vector3d& eye, const Point& centre) {
  View view;
  const Vector3d towards = eye.normalized();
  const Vector3d right = Vector3d(0, 1, 0).cross(towards).normalized();
  view.axes << right.transpose(), towards.cross(right).transpose(), towards.transpose();
  view.centre = centre;
  return view;
}

/// The great arc between two directions less than 180° apart, without its end.
void appendArc(std::vector<Vector3d>& arc, const Vector3d& from, const Vector3d& to) {
  constexpr int pieces = 24;
  const double angle = std::acos(std::min(1.0, std::max(-1.0, from.dot(to))));
  if (angle < 1e-9) return;
  for (int i = 0; i < pieces; ++i)
    arc.push_back(
        (std::sin(angle * (pieces - i) / pieces) * from + std::sin(angle * i / pieces) * to) /
        std::sin(angle));
}

/// The part of the spherical triangle that the eye sees: the plane of the sphere's rim cuts its
/// cone, edge by edge.
std::vector<Vector3d> visiblePart(const View& view, const std::vector<Vector3d>& edges) {
  std::vector<Vector3d> corners;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const Vector3d &here = edges[i], &next = edges[(i + 1) % edges.size()];
    const double a = view.depth(here), b = view.depth(next);
    if (a >= 0) corners.push_back(here);
    if ((a >= 0) != (b >= 0))
      corners.push_back(((b * here - a * next) * (b > a ? 1 : -1)).normalized());
  }
  std::vector<Vector3d> outline;
  for (std::size_t i = 0; i < corners.size(); ++i)
    appendArc(outline, corners[i], corners[(i + 1) % corners.size()]);
  return outline;
}

Path project(const View& view, const std::vector<Vector3d>& directions) {
  Path path;
  for (const Vector3d& direction : directions) path.push_back(view.at(direction));
  return path;
}

/// Area and centre of gravity of a flat outline.
std::pair<double, Point> areaAndCentre(const Path& outline) {
  double area = 0;
  Point moment(0, 0);
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Point &a = outline[i], &b = outline[(i + 1) % outline.size()];
    const double cross = a.x() * b.y() - a.y() * b.x();
    area += cross / 2;
    moment += cross / 6 * (a + b);
  }
  return {std::abs(area), area == 0 ? Point(0, 0) : Point(moment / area)};
}

void drawSphere(Canvas& canvas, const Corner& corner, const View& view) {
  struct Label {
    Point at;
    std::string name;
  };
  std::vector<Label> labels;
  for (const Trihedron& region : corner.regions) {
    const Path outline = project(view, visiblePart(view, region.edges));
    if (outline.empty()) continue;
    canvas.fill(outline, tint(colorOf(region.persisting), 1.25 * regionTint));
    const auto [area, centre] = areaAndCentre(outline);
    if (area > 0.05 * M_PI * radius * radius) labels.push_back({centre, nameOf(region.persisting)});
  }
  for (const Trihedron& region : corner.regions)
    canvas.stroke(project(view, visiblePart(view, region.edges)), {white, 2.5}, true);
  for (const Pull& pull : corner.pulls)
    if (view.depth(pull.direction) > 0.05)
      canvas.disc(view.at(pull.direction), 2.6, colorOf(pull.kept));
  canvas.circle(view.centre, radius, {ink, 2});
  for (const Label& label : labels)
    canvas.text(label.at + Point(0, 8), label.name, {24, ink, Align::Centre, true, true});
}

/// The bead between its three planes, seen from above.
void drawCorner(Canvas& canvas, const Matrix3d& N, const Point& centre) {
  constexpr double beadSize = 15, length = 95;
  View view = lookFrom({0.3, 1, 0}, centre);
  const Matrix3d opening = N.inverse();
  const auto place = [&](const Vector3d& x) {
    return Point(centre + Point(view.axes.row(0).dot(x), -view.axes.row(1).dot(x)));
  };
  const Vector3d apex = -beadSize * opening.rowwise().sum();
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const Path face = {place(apex), place(apex + length * opening.col(j).normalized()),
                       place(apex + length * opening.col(k).normalized())};
    canvas.fill(face, tint(pale, 0.25 + 0.12 * i));
    canvas.stroke(face, {white, 2}, true);
  }
  drawBead(canvas, centre, beadSize);
  canvas.text(centre + Point(0, 72), "the corner, from above", {15, pale, Align::Centre});
}

void draw(Canvas& canvas, const Corner& corner) {
  canvas.text({40, 50}, "Three contacts: eight regions on the sphere of force directions",
              {30, ink, Align::Left, true});
  const View below = lookFrom({-0.3, -1, 0}, {330, 420}), above = lookFrom({0.3, 1, 0}, {950, 420});
  drawCorner(canvas, corner.N, {640, 165});
  drawSphere(canvas, corner, below);
  drawSphere(canvas, corner, above);
  canvas.text({330, 125}, "pressed into the corner", {23, ink, Align::Centre, true});
  canvas.text({950, 125}, "pulled out of the corner", {23, ink, Align::Centre, true});

  struct Entry {
    double x;
    Color color;
    std::string words;
  };
  for (const Entry& entry :
       {Entry{60, keptAll, "all three contacts kept"}, Entry{390, keptSecond, "two kept, one lost"},
        Entry{690, keptFirst, "one kept, two lost"}, Entry{990, keptNone, "all lost"}}) {
    canvas.dot({entry.x, 714}, 7, entry.color);
    canvas.text({entry.x + 16, 720}, entry.words, {19});
  }
  canvas.paragraph(
      {40, 766}, 1200,
      "A bead in a corner of three planes, pulled in all directions: each dot is one Bullet "
      "step on this solver, each spherical triangle a region drawn from W; " +
          std::to_string(corner.agree) + " of " + std::to_string(directions) + " agree.",
      {19, pale});
}

}  // namespace

Figure threeContacts() {
  const Corner corner = measure();
  return {"three_contacts",
          {1280, 820},
          [=](Canvas& canvas) { draw(canvas, corner); },
          std::to_string(corner.agree) + " of " + std::to_string(directions) +
              " simulated directions agree"};
}

}  // namespace demos::atlas
