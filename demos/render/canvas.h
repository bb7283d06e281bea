#pragma once

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "demos/render/image.h"

namespace demos::render {

using Point = Eigen::Vector2d;  ///< pixels from the upper left corner of an image

/// A stroke or a filling: colour and opacity.
struct Paint {
  Colour colour;
  double alpha = 1;
};

/// Draws smooth figures on an image: each pixel is covered by its distance from the figure's edge.
class Canvas {
 public:
  explicit Canvas(Image& image) : image_(image) {}

  void disc(Point centre, double radius, Paint paint);
  void ring(Point centre, double radius, double width, Paint paint);
  /// A square, turned by 45 degrees if `diamond`.
  void square(Point centre, double half, bool diamond, Paint paint);
  void line(Point from, Point to, double width, Paint paint);
  void triangle(Point a, Point b, Point c, Paint paint);
  /// From `from` to `to` with a head of `head` pixels; short arrows are all head.
  void arrow(Point from, Point to, double width, double head, Paint paint);
  void rectangle(Point low, Point high, double rounding, Paint paint);
  void blend(int x, int y, Paint paint);

 private:
  /// Fills the figure within the box; `distance` is that from its edge, pixels, negative inside.
  void fill(Point low, Point high, const std::function<double(Point)>& distance, Paint paint);

  Image& image_;
};

enum class Align { Left, Centre, Right };

/// Text in DejaVu Sans, by FreeType.
class Font {
 public:
  /// Throws std::runtime_error where the font is missing, naming its package.
  explicit Font(bool bold);
  ~Font();
  Font(Font&&) noexcept;

  /// Width of a UTF-8 text at `height` pixels an em.
  double width(const std::string& text, double height);
  /// Draws it on the base line at `place`; returns the x where it ends.
  double draw(Image& image, const std::string& text, Point place, double height, Paint paint,
              Align align = Align::Left);

 private:
  struct Face;
  std::unique_ptr<Face> face_;
};

}  // namespace demos::render
