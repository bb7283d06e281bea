#include "demos/atlas/canvas.h"

#include <cmath>
#include <sstream>

namespace demos::atlas {

namespace {

constexpr double subscriptScale = 0.74, subscriptDrop = 0.24;  // of the size of the text
constexpr double lineSpacing = 1.4;

}  // namespace

Canvas::Canvas(cairo_t* context) : context_(context) {
  // Without hinting, text is as wide in PNG as in SVG.
  cairo_font_options_t* options = cairo_font_options_create();
  cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
  cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
  cairo_set_font_options(context_, options);
  cairo_font_options_destroy(options);
  cairo_set_line_join(context_, CAIRO_LINE_JOIN_ROUND);
}

void Canvas::trace(const Path& path, bool closed) {
  cairo_new_path(context_);
  for (const Point& point : path) cairo_line_to(context_, point.x(), point.y());
  if (closed) cairo_close_path(context_);
}

void Canvas::set(const Stroke& stroke) {
  cairo_set_source_rgb(context_, stroke.color.red, stroke.color.green, stroke.color.blue);
  cairo_set_line_width(context_, stroke.width);
  const double dash[] = {3.5 * stroke.width, 2.5 * stroke.width};
  cairo_set_dash(context_, dash, stroke.dashed ? 2 : 0, 0);
}

void Canvas::fill(const Path& outline, Color color) {
  trace(outline, true);
  cairo_set_source_rgb(context_, color.red, color.green, color.blue);
  cairo_fill(context_);
}

void Canvas::stroke(const Path& line, const Stroke& stroke, bool closed) {
  trace(line, closed);
  set(stroke);
  cairo_stroke(context_);
}

void Canvas::circle(const Point& centre, double radius, const Stroke& stroke) {
  cairo_new_path(context_);
  cairo_arc(context_, centre.x(), centre.y(), radius, 0, 2 * M_PI);
  set(stroke);
  cairo_stroke(context_);
}

void Canvas::disc(const Point& centre, double radius, Color color) {
  // Draws the round cap of a line of no length: it is short in SVG, where figures have hundreds of
  // dots.
  trace({centre, centre}, false);
  set({color, 2 * radius});
  cairo_set_line_cap(context_, CAIRO_LINE_CAP_ROUND);
  cairo_stroke(context_);
  cairo_set_line_cap(context_, CAIRO_LINE_CAP_BUTT);
}

void Canvas::dot(const Point& centre, double radius, Color color) {
  disc(centre, radius + 1.2, white);
  disc(centre, radius, color);
}

void Canvas::diamond(const Point& centre, double radius, Color color) {
  const Point right(radius, 0), down(0, radius);
  const Path outline = {centre + right, centre + down, centre - right, centre - down};
  fill(outline, color);
  stroke(outline, {ink, 1.4}, true);
}

void Canvas::arrow(const Point& from, const Point& to, const Stroke& stroke) {
  const double length = (to - from).norm();
  if (length <= 0) return;
  const Point along = (to - from) / length, across(-along.y(), along.x());
  const double head = std::min(length, 4 + 4 * stroke.width);
  this->stroke({from, to - 0.8 * head * along}, stroke);
  fill({to, to - head * along + 0.42 * head * across, to - head * along - 0.42 * head * across},
       stroke.color);
}

void Canvas::clipped(const Path& outline, const std::function<void()>& draw) {
  cairo_save(context_);
  trace(outline, true);
  cairo_clip(context_);
  draw();
  cairo_restore(context_);
}

void Canvas::select(const TextStyle& style, double size) {
  cairo_select_font_face(context_, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                         style.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(context_, size);
}

double Canvas::layOut(const std::string& text, const TextStyle& style,
                      const std::function<void(double, double, const std::string&)>& use) {
  double x = 0;
  const auto piece = [&](const std::string& letters, bool subscript) {
    if (letters.empty()) return;
    select(style, style.size * (subscript ? subscriptScale : 1));
    if (use) use(x, subscript ? subscriptDrop * style.size : 0, letters);
    cairo_text_extents_t extents;
    cairo_text_extents(context_, letters.c_str(), &extents);
    x += extents.x_advance;
  };
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t open = std::min(text.find("_{", at), text.size());
    piece(text.substr(at, open - at), false);
    if (open == text.size()) break;
    const std::size_t close = std::min(text.find('}', open), text.size());
    piece(text.substr(open + 2, close - open - 2), true);
    at = close + 1;
  }
  return x;
}

double Canvas::textWidth(const std::string& text, const TextStyle& style) {
  return layOut(text, style, nullptr);
}

void Canvas::text(const Point& at, const std::string& text, const TextStyle& style) {
  const double share = style.align == Align::Left ? 0 : style.align == Align::Centre ? 0.5 : 1;
  const double left = at.x() - share * textWidth(text, style);
  for (const bool rim : {true, false}) {
    if (rim && !style.halo) continue;
    layOut(text, style, [&](double x, double drop, const std::string& piece) {
      cairo_move_to(context_, left + x, at.y() + drop);
      if (rim) {
        cairo_text_path(context_, piece.c_str());
        set({white, 0.28 * style.size});
        cairo_stroke(context_);
      } else {
        cairo_set_source_rgb(context_, style.color.red, style.color.green, style.color.blue);
        cairo_show_text(context_, piece.c_str());
      }
    });
  }
}

void Canvas::paragraph(const Point& at, double width, const std::string& text,
                       const TextStyle& style) {
  Point baseline = at;
  std::istringstream lines(text);
  for (std::string given; std::getline(lines, given);) {
    std::istringstream words(given);
    std::string line;
    for (std::string word; words >> word;) {
      const std::string longer = line.empty() ? word : line + " " + word;
      if (line.empty() || textWidth(longer, style) <= width) {
        line = longer;
        continue;
      }
      this->text(baseline, line, style);
      baseline.y() += lineSpacing * style.size;
      line = word;
    }
    this->text(baseline, line, style);
    baseline.y() += lineSpacing * style.size;
  }
}

Path rectangle(const Point& corner, const Point& size) {
  return {corner, corner + Point(size.x(), 0), corner + size, corner + Point(0, size.y())};
}

}  // namespace demos::atlas
