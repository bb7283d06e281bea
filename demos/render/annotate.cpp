#include "demos/render/annotate.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "demos/render/instances.h"
#include "demos/render/palette.h"

namespace demos::render {

using delassus::Mode;
using Eigen::Vector3d;

namespace {

/// A glyph and an arrow at one place; contacts and joints alike.
struct Mark {
  Vector3d place, force;
  enum class Shape { Disc, Diamond, Ring, Square } shape;
};

std::vector<Mark> marksOf(const Frame& frame) {
  std::vector<Mark> marks;
  for (const JointMark& joint : frame.joints)
    marks.push_back({joint.place, joint.force, Mark::Shape::Square});
  for (const ContactMark& contact : frame.contacts) {
    const Mark::Shape shape = contact.mode == Mode::Stick   ? Mark::Shape::Disc
                              : contact.mode == Mode::Slide ? Mark::Shape::Diamond
                                                            : Mark::Shape::Ring;
    marks.push_back({contact.place, contact.force, shape});
  }
  return marks;
}

/// Glyphs have a pale rim, so that they stand out from any background.
void drawGlyph(Canvas& canvas, Mark::Shape shape, Point at, double radius, double alpha) {
  const double rim = std::min(1.2, 0.3 * radius);
  const Paint white{{255, 255, 255}, alpha};
  switch (shape) {
    case Mark::Shape::Disc:
      canvas.disc(at, radius + rim, white);
      canvas.disc(at, radius, {palette::sticking, alpha});
      return;
    case Mark::Shape::Diamond:
      canvas.square(at, radius + rim, true, {palette::ink, alpha});
      canvas.square(at, radius, true, {palette::sliding, alpha});
      return;
    case Mark::Shape::Ring:
      canvas.disc(at, radius + rim, {palette::released, alpha});
      canvas.ring(at, radius, std::max(1.0, 0.45 * radius), {palette::ink, alpha});
      return;
    case Mark::Shape::Square:
      canvas.square(at, 0.85 * radius + rim, false, white);
      canvas.square(at, 0.85 * radius, false, {palette::joint, alpha});
      return;
  }
}

void drawArrow(Canvas& canvas, Point from, Point to, double width, bool cut, double alpha) {
  const double head = 4.2 * width;
  const Point back = (to - from).normalized() * head * 0.8;
  canvas.arrow(from, to, width + 1.6, head + 2.5, {{255, 255, 255}, 0.75 * alpha});
  canvas.arrow(from, to, width, head, {palette::reaction, alpha});
  if (cut) canvas.arrow(from, to - back, width, head, {palette::reaction, alpha});
}

/// The distance from the camera for a value of the depth buffer, m.
double distanceOf(double depth, const View& view) {
  return view.near * view.far / (view.far - depth * (view.far - view.near));
}

/// By how many metres something stands in front of the point whose projection is `seen`.
double hiddenBy(const Drawing& drawing, const Vector3d& seen, const View& view) {
  const int x = int(seen.x()), y = int(seen.y());
  if (x < 0 || y < 0 || x >= drawing.image.size.width || y >= drawing.image.size.height) return 0;
  return distanceOf(seen.z(), view) - distanceOf(double(drawing.depth(x, y)), view);
}

/// Smaller where there are many marks, so that they do not run together.
double glyphRadius(std::size_t marks, double unit) {
  return unit *
         std::clamp(4.2 * std::sqrt(90.0 / double(std::max<std::size_t>(marks, 1))), 1.4, 4.2);
}

/// 1, 2 or 5 times a power of ten, at most `value`.
double niceBelow(double value) {
  const double power = std::pow(10, std::floor(std::log10(value)));
  return (value >= 5 * power ? 5 : value >= 2 * power ? 2 : 1) * power;
}

void labelHeavyThings(Drawing& drawing, const Film& film, const Frame& frame, const View& view,
                      double unit, Font& font) {
  constexpr int atMost = 4;
  const double heavy = heavyFrom(film);
  int count = 0;
  for (const Thing& thing : film.things) count += thing.mass >= heavy ? 1 : 0;
  if (count > atMost) return;
  for (const Frame::Pose& pose : frame.poses) {
    const Thing& thing = film.things[std::size_t(pose.thing)];
    if (thing.mass < heavy) continue;
    const Vector3d centre = pose.matrix.topRightCorner<3, 1>().cast<double>();
    const auto seen = view.project(centre, drawing.image.size);
    if (!seen) continue;
    const std::string text = readable(thing.mass) + " kg";
    const double height = 13 * unit, half = 0.5 * font.width(text, height) + 0.4 * height;
    const Point at = seen->head<2>();
    Canvas canvas(drawing.image);
    canvas.rectangle(at - Point(half, 0.72 * height), at + Point(half, 0.72 * height), 3 * unit,
                     {palette::ink, 0.8});
    font.draw(drawing.image, text, at + Point(0, 0.36 * height), height, {palette::paper},
              Align::Centre);
  }
}

}  // namespace

MarkScale markScale(const std::vector<Film>& films, const View& view, Size panel) {
  std::vector<double> forces;
  std::size_t most = 0;
  for (const Film& film : films)
    for (const Frame& frame : film.frames) {
      const std::vector<Mark> marks = marksOf(frame);
      most = std::max(most, marks.size());
      for (const Mark& mark : marks)
        if (mark.force.norm() > 0) forces.push_back(mark.force.norm());
    }
  if (forces.empty()) return {most};
  const auto place = forces.begin() + std::ptrdiff_t(0.98 * double(forces.size() - 1));
  std::nth_element(forces.begin(), place, forces.end());
  const double usual = *place;
  // As a share of the panel's height: the more arrows, the shorter they are.
  const double share = std::clamp(0.4 / std::sqrt(double(most)), 0.05, 0.16);
  constexpr double stretch = 1.8;
  return {most, share * panel.height / view.pixelsPerMetre(panel) / usual, stretch * usual};
}

void annotate(Drawing& drawing, const Film& film, const Frame& frame, const View& view,
              const Box& stage, const MarkScale& scale, double unit, Font& font) {
  const std::vector<Mark> marks = marksOf(frame);
  const double radius = glyphRadius(scale.most, unit);
  const double width = std::max(1.0, 0.5 * radius);
  // Hidden marks help only as long as they can be told apart.
  constexpr std::size_t tooMany = 250;
  const double tolerance = 0.02 * stage.radius();
  Canvas canvas(drawing.image);
  for (const bool front : {false, true}) {
    if (!front && scale.most > tooMany) continue;
    const double alpha = front ? 1 : std::clamp(6.0 / double(scale.most), 0.28, 0.65);
    std::vector<std::pair<Mark::Shape, Point>> glyphs;
    for (const Mark& mark : marks) {
      const auto seen = view.project(mark.place, drawing.image.size);
      if (!seen || (hiddenBy(drawing, *seen, view) < tolerance) != front) continue;
      glyphs.emplace_back(mark.shape, seen->head<2>());
      const double newtons = mark.force.norm();
      if (newtons == 0) continue;
      const double metres = scale.metresPerNewton * std::min(newtons, scale.longest);
      const auto tip = view.project(mark.place + mark.force / newtons * metres, drawing.image.size);
      if (tip)
        drawArrow(canvas, seen->head<2>(), tip->head<2>(), width, newtons > scale.longest, alpha);
    }
    for (const auto& [shape, at] : glyphs) drawGlyph(canvas, shape, at, radius, alpha);
  }
  labelHeavyThings(drawing, film, frame, view, unit, font);
}

void drawLegend(Image& image, Point place, double right, double unit,
                const std::vector<Film>& films, const View& view, Size panel,
                const MarkScale& scale, Font& font) {
  Canvas canvas(image);
  const double height = 14 * unit, radius = 5 * unit;
  const Paint ink{palette::ink};
  const struct {
    Mark::Shape shape;
    const char* text;
  } entries[] = {{Mark::Shape::Disc, "contact that sticks"},
                 {Mark::Shape::Diamond, "slides"},
                 {Mark::Shape::Ring, "released in this step"},
                 {Mark::Shape::Square, "joint"}};
  for (const auto& entry : entries) {
    bool any = false;
    for (const Film& film : films)
      for (const Frame& frame : film.frames)
        for (const Mark& mark : marksOf(frame)) any = any || mark.shape == entry.shape;
    if (!any) continue;
    drawGlyph(canvas, entry.shape, place + Point(radius, -0.34 * height), radius, 1);
    place.x() = font.draw(image, entry.text, place + Point(2 * radius + 6 * unit, 0), height, ink) +
                20 * unit;
  }

  place.x() = right;
  char text[64];
  std::snprintf(text, sizeof text, "grid %g m", gridSpacing(view, panel));
  font.draw(image, text, place, height, ink, Align::Right);
  place.x() -= font.width(text, height) + 24 * unit;
  if (scale.metresPerNewton == 0) return;
  const double pixelsPerNewton = scale.metresPerNewton * view.pixelsPerMetre(panel);
  const double newtons = niceBelow(90 * unit / pixelsPerNewton);
  const std::string words = "reaction " + readable(newtons) + " N";
  font.draw(image, words, place, height, ink, Align::Right);
  place.x() -= font.width(words, height) + 8 * unit;
  const Point tip = place + Point(0, -0.34 * height);
  drawArrow(canvas, tip - Point(newtons * pixelsPerNewton, 0), tip, 2.1 * unit, false, 1);
}

std::string readable(double value) {
  char text[64];
  if (value == 0) return "0";
  if (!std::isfinite(value)) return std::isnan(value) ? "not a number" : value > 0 ? "∞" : "−∞";
  const double size = std::abs(value);
  if (size >= 1e-3 && size < 1e5) {
    // Whole numbers are written out, others to two digits.
    std::snprintf(text, sizeof text, size >= 100 || size == std::round(size) ? "%.0f" : "%.2g",
                  value);
    return text;
  }
  std::snprintf(text, sizeof text, "%.0e", value);
  const std::string digits = text;
  const std::size_t e = digits.find('e');
  static const char* const raised[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string power;
  const int exponent = std::stoi(digits.substr(e + 1));
  for (const char digit : std::to_string(std::abs(exponent))) power += raised[digit - '0'];
  return digits.substr(0, e) + "·10" + (exponent < 0 ? "⁻" : "") + power;
}

}  // namespace demos::render
