#pragma once

#include <cairo.h>

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

#include "demos/atlas/palette.h"

namespace demos::atlas {

/// Pixels, x to the right and y down.
using Point = Eigen::Vector2d;
using Path = std::vector<Point>;

struct Stroke {
  Color color = ink;
  double width = 2;
  bool dashed = false;
};

enum class Align { Left, Centre, Right };

struct TextStyle {
  double size = 20;
  Color color = ink;
  Align align = Align::Left;
  bool bold = false;
  bool halo = false;  ///< a white rim, for text on top of lines
};

/// The drawing tools of the figures. Does not own the cairo context.
class Canvas {
 public:
  explicit Canvas(cairo_t* context);

  void fill(const Path& outline, Color color);
  void stroke(const Path& line, const Stroke& stroke, bool closed = false);
  void circle(const Point& centre, double radius, const Stroke& stroke);
  void disc(const Point& centre, double radius, Color color);
  /// A disc with a white rim.
  void dot(const Point& centre, double radius, Color color);
  /// A diamond with a dark rim.
  void diamond(const Point& centre, double radius, Color color);
  /// The head ends at `to`.
  void arrow(const Point& from, const Point& to, const Stroke& stroke);
  /// Draws what `draw` draws, cut off outside `outline`.
  void clipped(const Path& outline, const std::function<void()>& draw);

  /// One line of text, its baseline at `at`; "_{...}" is a subscript.
  void text(const Point& at, const std::string& text, const TextStyle& style);
  double textWidth(const std::string& text, const TextStyle& style);
  /// Text broken into lines of at most `width`, also at '\n', the first baseline at `at`.
  void paragraph(const Point& at, double width, const std::string& text, const TextStyle& style);

 private:
  void trace(const Path& path, bool closed);
  void set(const Stroke& stroke);
  void select(const TextStyle& style, double size);
  double layOut(const std::string& text, const TextStyle& style,
                const std::function<void(double x, double drop, const std::string& piece)>& use);

  cairo_t* context_;
};

Path rectangle(const Point& corner, const Point& size);

}  // namespace demos::atlas
