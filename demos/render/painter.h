#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "demos/render/film.h"
#include "demos/render/image.h"
#include "demos/render/view.h"

namespace demos::render {

/// A drawn frame as the camera saw it.
struct Drawing {
  Image image;
  std::vector<float> depths;           ///< of each pixel, 0 near to 1 far, rows from the top
  std::vector<std::uint32_t> numbers;  ///< of the thing in each pixel: its index + 1, 0 for the sky

  float depth(int x, int y) const { return depths[std::size_t(y) * image.size.width + x]; }
  std::uint32_t number(int x, int y) const {
    return numbers[std::size_t(y) * image.size.width + x];
  }
};

/// Metres between the lines of the ground's grid, a power of ten, for a view at this size.
double gridSpacing(const View& view, Size size);

/// Draws frames of films with OpenGL: sun with a soft shadow, sky light with ambient occlusion, a
/// grid on the ground, outlines.
///
/// All pictures of one painter have one size. It owns the OpenGL context; one painter at a time.
class Painter {
 public:
  /// Throws GlError where there is no OpenGL.
  explicit Painter(Size size);
  ~Painter();
  Painter(const Painter&) = delete;
  Painter& operator=(const Painter&) = delete;

  /// Uploads the meshes of a film. The returned number stands for it in `draw`. Planes must have
  /// been laid.
  int load(const Film& film);
  /// Throws GlError if OpenGL reports an error.
  Drawing draw(int loaded, const Film& film, const Frame& frame, const View& view,
               const Box& stage);

 private:
  struct Gl;
  std::unique_ptr<Gl> gl_;
};

}  // namespace demos::render
