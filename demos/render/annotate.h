#pragma once

#include <string>
#include <vector>

#include "demos/render/canvas.h"
#include "demos/render/film.h"
#include "demos/render/painter.h"
#include "demos/render/view.h"

namespace demos::render {

/// How marks are drawn. The number of marks in a frame decides how small they are, and whether
/// hidden ones are drawn; all arrows have one scale. This is the same in all panels of a picture
/// and all frames of a video, so that what looks different is different.
struct MarkScale {
  std::size_t most = 0;        ///< marks in one frame
  double metresPerNewton = 0;  ///< 0: no contact or joint carries
  double longest = 0;  ///< N; larger reactions are drawn as long as this, with a double head
};

/// Long arrows reach from a twentieth to a sixth of a panel's height. A few extremes (impacts) do
/// not shrink all others.
MarkScale markScale(const std::vector<Film>& films, const View& view, Size panel);

/// Draws the contacts by their mode, the reactions of contacts and joints, and the weights of heavy
/// things. Marks hidden behind a thing are pale. `unit` is the size of a pixel in a picture of 720
/// rows.
void annotate(Drawing& drawing, const Film& film, const Frame& frame, const View& view,
              const Box& stage, const MarkScale& scale, double unit, Font& font);

/// Explains the marks in one line that starts at `place`, for the kinds of marks in `films`. The
/// grid's spacing and the arrow's scale end at `right`.
void drawLegend(Image& image, Point place, double right, double unit,
                const std::vector<Film>& films, const View& view, Size panel,
                const MarkScale& scale, Font& font);

/// "0.13", "2·10⁻¹³", "2450": two digits or so, as people write them.
std::string readable(double value);

}  // namespace demos::render
