#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "demos/render/annotate.h"
#include "demos/render/film.h"
#include "demos/render/painter.h"
#include "demos/render/view.h"

namespace demos::render {

/// The size of a picture and its words.
struct Look {
  Size size;             ///< of the whole picture
  bool plain = false;    ///< only the drawings
  bool timing = false;   ///< milliseconds a step in the captions
  std::string title;     ///< name of the scene
  std::string summary;   ///< what it is
  std::string expected;  ///< what it should do
};

/// The picture's size leaves no room for its panels.
class TooSmall : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};
/// OpenGL has no memory for the panels of a picture of its size.
class TooLarge : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Makes pictures of films that show one scene at the same times: side by side, with one camera and
/// one scale of arrows.
class Studio {
 public:
  /// `columns`: how many frames of a film one picture shows. Throws what `check` throws.
  Studio(std::vector<Film> films, const Wish& wish, const Look& look, int columns);
  /// Call it before films are recorded. Throws TooSmall or TooLarge if this many cannot be shown,
  /// GlError where there is no OpenGL, std::runtime_error where the font is missing.
  static void check(const Look& look, int films, int columns);

  /// For one frame: a panel for each film, in so many rows that the smaller side of a panel is as
  /// large as it can be. Otherwise: a row for each film, with a panel for each frame.
  Image picture(const std::vector<int>& frames);

 private:
  struct Layout {
    double unit;  ///< a pixel in a picture of 1280 x 720
    int rows, columns, header, caption, footer, gap;
    Size panel;
  };
  static Layout layOut(const Look& look, int films, int columns);
  void drawPanel(Image& picture, int film, int frame, int row, int column);
  void drawCaption(Image& picture, const Film& film, const Frame& frame, Point place, double width);
  void drawFrame(Image& picture);

  Look look_;
  Layout layout_;
  std::vector<Film> films_;
  Box stage_;
  View view_;
  MarkScale scale_;
  Painter painter_;
  Font regular_, bold_;
};

/// Time and residual of a frame, as in its caption; with `timing` also the milliseconds of a step.
std::string factsInWords(const Frame& frame, bool timing);

}  // namespace demos::render
