#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "demos/render/annotate.h"
#include "demos/render/film.h"
#include "demos/render/painter.h"
#include "demos/render/view.h"

namespace demos::render {

/// What a picture says beside what it shows.
struct Look {
  Size size;             ///< of the whole picture
  bool plain = false;    ///< the drawings alone
  bool timing = false;   ///< milliseconds a step in the captions
  std::string title;     ///< name of the scene
  std::string summary;   ///< what it is
  std::string expected;  ///< what it should do
};

/// The panels of a picture have no room in its size.
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
  /// Throws where so many films could not be shown, to be asked before they are recorded: TooSmall,
  /// TooLarge, GlError where there is no OpenGL, std::runtime_error where the font is missing.
  static void check(const Look& look, int films, int columns);

  /// A row of panels, one a film, if there is one frame, else a row a film with a panel a frame.
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

/// Time and residual of a frame, as its caption has them; with `timing` also the milliseconds of a
/// step.
std::string factsInWords(const Frame& frame, bool timing);

}  // namespace demos::render
