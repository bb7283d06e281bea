#include "demos/render/picture.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "demos/render/gl.h"
#include "demos/render/ground.h"
#include "demos/render/palette.h"
#include "demos/scenes/solvers.h"

namespace demos::render {

namespace {

/// The films with their planes laid on `box`.
std::vector<Film> onStage(std::vector<Film> films, const Box& box) {
  for (Film& film : films) layPlanes(film, box);
  return films;
}

/// `height`, or less if the text would be wider than `room`.
double fitted(Font& font, const std::string& text, double height, double room) {
  return height * std::min(1.0, room / std::max(1.0, font.width(text, height)));
}

std::string inSeconds(double time) {
  char text[32];
  std::snprintf(text, sizeof text, "t = %.4g s", time);
  return text;
}

std::string inWords(Size size) {
  return std::to_string(size.width) + "x" + std::to_string(size.height);
}

/// How many of `count` are in each of so many rows, the last one perhaps excepted.
int inRowsOf(int count, int rows) { return (count + rows - 1) / rows; }

}  // namespace

std::string factsInWords(const Frame& frame, bool timing) {
  std::string facts = inSeconds(frame.time);
  if (frame.lost)
    facts += "    LOST: a body is nowhere, its place not a number";
  else if (frame.residual)
    facts += "    residual " + readable(*frame.residual) + " m/s";
  if (timing && frame.time > 0) facts += "    " + readable(frame.milliseconds) + " ms a step";
  return facts;
}

Studio::Layout Studio::layOut(const Look& look, int films, int columns) {
  Layout layout{};
  layout.unit = std::clamp(std::min(look.size.height / 720.0, look.size.width / 1000.0), 0.4, 4.0);
  const auto pixels = [&](double units) {
    return look.plain ? 0 : int(std::lround(units * layout.unit));
  };
  layout.header = pixels(64);
  layout.caption = pixels(48);
  layout.footer = pixels(40);
  layout.gap = std::max(1, int(std::lround(3 * layout.unit)));
  const auto arrange = [&](int rows, int across) {
    layout.rows = rows;
    layout.columns = across;
    const int height = look.size.height - layout.header - layout.footer - rows * layout.caption;
    layout.panel = {(look.size.width - (across - 1) * layout.gap) / across,
                    (height - (rows - 1) * layout.gap) / rows};
    return std::min(layout.panel.width, layout.panel.height);
  };
  if (columns > 1) {
    arrange(films, columns);
  } else {
    int best = 1;
    for (int rows = 2; rows <= films; ++rows)
      if (arrange(rows, inRowsOf(films, rows)) > arrange(best, inRowsOf(films, best))) best = rows;
    arrange(best, inRowsOf(films, best));
  }
  constexpr int least = 16;
  if (layout.panel.width < least || layout.panel.height < least)
    throw TooSmall("a picture of " + inWords(look.size) + " is too small for " +
                   inWords({layout.columns, layout.rows}) + " panels");
  return layout;
}

void Studio::check(const Look& look, int films, int columns) {
  const Size panel = layOut(look, films, columns).panel;
  try {
    const Painter painter(panel);
  } catch (const GlMemoryError& error) {
    throw TooLarge("a picture of " + inWords(look.size) + " is too large: " + error.what());
  }
  const Font regular(false), bold(true);
}

Studio::Studio(std::vector<Film> films, const Wish& wish, const Look& look, int columns)
    : look_(look),
      layout_(layOut(look, int(films.size()), columns)),
      stage_(stage(films)),
      view_(frameView(films, stage_, wish, layout_.panel)),
      scale_(markScale(films, view_, layout_.panel)),
      painter_(layout_.panel),
      regular_(false),
      bold_(true) {
  films_ = onStage(std::move(films), stage_);
  for (const Film& film : films_) painter_.load(film);
}

Image Studio::picture(const std::vector<int>& frames) {
  Image picture(look_.size, palette::paper);
  for (int film = 0; film < int(films_.size()); ++film)
    for (int i = 0; i < int(frames.size()); ++i)
      if (frames.size() > 1)
        drawPanel(picture, film, frames[std::size_t(i)], film, i);
      else
        drawPanel(picture, film, frames[0], film / layout_.columns, film % layout_.columns);
  if (!look_.plain) drawFrame(picture);
  return picture;
}

void Studio::drawPanel(Image& picture, int filmIndex, int frameIndex, int row, int column) {
  const Film& film = films_[std::size_t(filmIndex)];
  const Frame& frame = film.frames[std::size_t(frameIndex)];
  Drawing drawing = painter_.draw(filmIndex, film, frame, view_, stage_);
  if (!look_.plain) annotate(drawing, film, frame, view_, stage_, scale_, layout_.unit, regular_);
  const int x = column * (layout_.panel.width + layout_.gap);
  const int top = layout_.header + row * (layout_.caption + layout_.panel.height + layout_.gap);
  picture.paste(drawing.image, x, top + layout_.caption);
  if (!look_.plain) drawCaption(picture, film, frame, Point(x, top), layout_.panel.width);
}

void Studio::drawCaption(Image& picture, const Film& film, const Frame& frame, Point place,
                         double width) {
  const double unit = layout_.unit, margin = 14 * unit;
  const double room = width - 2 * margin;
  Point line = place + Point(margin, 19 * unit);
  const double nameEnd = bold_.draw(picture, film.solver, line,
                                    fitted(bold_, film.solver, 17 * unit, room), {palette::ink});
  const std::string words = solverInWords(film.solver);
  const double left = place.x() + width - margin - nameEnd - 10 * unit;
  // A narrow panel has room only for the name.
  if (regular_.width(words, 11 * unit) <= left)
    regular_.draw(picture, words, Point(nameEnd + 10 * unit, line.y()),
                  fitted(regular_, words, 14 * unit, left), {palette::paleInk});

  const std::string facts = factsInWords(frame, look_.timing);
  line.y() += 20 * unit;
  regular_.draw(picture, facts, line, fitted(regular_, facts, 14 * unit, room), {palette::ink});
}

void Studio::drawFrame(Image& picture) {
  const double unit = layout_.unit, margin = 14 * unit;
  const double room = look_.size.width - 2 * margin;
  Point line(margin, 28 * unit);
  const double nameEnd = bold_.draw(picture, look_.title, line,
                                    fitted(bold_, look_.title, 22 * unit, room), {palette::ink});
  const double left = look_.size.width - margin - nameEnd - 14 * unit;
  if (left > 60 * unit)
    regular_.draw(picture, look_.summary, Point(nameEnd + 14 * unit, line.y()),
                  fitted(regular_, look_.summary, 17 * unit, left), {palette::ink});
  if (!look_.expected.empty()) {
    const std::string text = "expected: " + look_.expected;
    regular_.draw(picture, text, line + Point(0, 24 * unit),
                  fitted(regular_, text, 15 * unit, room), {palette::paleInk});
  }
  Canvas canvas(picture);
  canvas.line(Point(0, layout_.header), Point(look_.size.width, layout_.header), 1,
              {palette::rule});
  drawLegend(picture, Point(margin, look_.size.height - 14 * unit), look_.size.width - margin, unit,
             films_, view_, layout_.panel, scale_, regular_);
}

}  // namespace demos::render
