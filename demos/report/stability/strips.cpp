#include "demos/report/stability/strips.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>

#include "demos/report/figure.h"

namespace demos::report::stability {

namespace {

constexpr int columns = 2, panelWidth = 640, stripHeight = 20, fontSize = 12;
// Room around the cells of a panel, and for the title and the legend of the figure, pixels.
constexpr int leftRoom = 170, rightRoom = 16, topRoom = 30, bottomRoom = 46, headRoom = 70;

/// Okabe and Ito's colours, and a sign for readers who see no colours.
struct Look {
  Verdict verdict;
  const char *colour, *sign, *signColour;
};
constexpr Look looks[] = {{Verdict::Holds, "#0072b2", "", "#ffffff"},
                          {Verdict::HoldsAndSays, "#56b4e9", "o", "#000000"},
                          {Verdict::FailsAndSays, "#e69f00", "!", "#000000"},
                          {Verdict::Fails, "#d55e00", "x", "#ffffff"},
                          {Verdict::TooSlow, "#bbbbbb", "t", "#000000"},
                          {Verdict::Crashes, "#000000", "#", "#ffffff"}};

const Look& lookOf(Verdict verdict) {
  return *std::find_if(std::begin(looks), std::end(looks),
                       [verdict](const Look& look) { return look.verdict == verdict; });
}

int panelHeight(const std::vector<StripPanel>& panels) {
  std::size_t strips = 1;
  for (const StripPanel& panel : panels) strips = std::max(strips, panel.strips.size());
  return topRoom + bottomRoom + stripHeight * int(strips);
}

class Script {
 public:
  Script(int width, int height) : width_(width), height_(height) {}

  /// Pixels from the upper left.
  void rectangle(double x, double y, double w, double h, const std::string& colour) {
    text_ << "set object " << ++objects_ << " rectangle from screen " << across(x) << ", screen "
          << down(y + h) << " to screen " << across(x + w) << ", screen " << down(y)
          << " fillstyle solid border lc rgb '#ffffff' fillcolor rgb '" << colour << "' lw 1\n";
  }
  void label(double x, double y, const std::string& words, const char* side,
             const std::string& colour, int size = fontSize) {
    if (words.empty()) return;
    text_ << "set label " << literal(words) << " at screen " << across(x) << ", screen " << down(y)
          << ' ' << side << " front noenhanced textcolor rgb '" << colour
          << "' font sprintf(\"DejaVu Sans,%g\", scale * " << size << ")\n";
  }
  void line(double x, double from, double to) {
    text_ << "set arrow from screen " << across(x) << ", screen " << down(from) << " to screen "
          << across(x) << ", screen " << down(to) << " nohead front lw 2.5 lc rgb '#000000'\n";
  }
  std::string text() const { return text_.str(); }

 private:
  double across(double x) const { return x / width_; }
  double down(double y) const { return 1 - y / height_; }

  std::ostringstream text_;
  int width_, height_, objects_ = 0;
};

void addLegend(Script& script) {
  double x = 20;
  for (const Look& look : looks) {
    constexpr double y = 36, size = 18, letter = 7.4;
    const std::string words = toString(look.verdict);
    script.rectangle(x, y, size, size, look.colour);
    script.label(x + size / 2, y + size / 2, look.sign, "center", look.signColour, 11);
    script.label(x + size + 6, y + size / 2, words, "left", "#333333");
    x += size + 30 + letter * double(words.size());
  }
}

void addPanel(Script& script, const StripPanel& panel, double left, double top) {
  const double cell = double(panelWidth - leftRoom - rightRoom) / double(panel.values.size());
  const double from = left + leftRoom, first = top + topRoom;
  script.label(left + 12, top + topRoom / 2.0, panel.title, "left", "#000000");
  for (std::size_t row = 0; row < panel.strips.size(); ++row) {
    const Strip& strip = panel.strips[row];
    const double y = first + double(row) * stripHeight;
    script.label(from - 8, y + stripHeight / 2.0, strip.label, "right", "#333333", 11);
    if (strip.limit > 0)
      script.line(from + (placeAmong(panel.values, strip.limit) + 0.5) * cell, y, y + stripHeight);
    for (std::size_t i = 0; i < strip.cells.size(); ++i) {
      const Look& look = lookOf(strip.cells[i]);
      const double x = from + double(i) * cell;
      script.rectangle(x, y, cell, stripHeight, look.colour);
      script.label(x + cell / 2, y + stripHeight / 2.0, look.sign, "center", look.signColour, 11);
    }
  }
  const double bottom = first + stripHeight * double(panel.strips.size());
  const std::size_t every = panel.values.size() > 13 ? 2 : 1;  // as many as there is room for
  for (std::size_t i = 0; i < panel.values.size(); i += every)
    script.label(from + (double(i) + 0.5) * cell, bottom + 10, tic(panel.values[i]), "center",
                 "#333333", 10);
  script.label(from + 0.5 * cell * double(panel.values.size()), bottom + 28, panel.axis, "center",
               "#333333", 11);
}

}  // namespace

std::string tic(double value) {
  const double size = std::abs(value);
  char word[32];
  if (size >= 1e-4 && size < 1e5) {
    std::snprintf(word, sizeof word, "%.3g", value);
    if (size < 1000) return word;
    std::snprintf(word, sizeof word, "%.0f", value);
    return word;
  }
  std::snprintf(word, sizeof word, "%.2g", value);
  // 1e-06 and 1e+06: the zeros and the plus carry no information.
  std::string text = word;
  const std::size_t at = text.find('e');
  if (at == std::string::npos) return text;
  return text.substr(0, at + 1) + std::to_string(std::stoi(text.substr(at + 1)));
}

double placeAmong(const std::vector<double>& values, double limit) {
  const auto scaled = [](double value) { return std::log10(std::max(value, 1e-300)); };
  for (std::size_t i = 1; i < values.size(); ++i) {
    const double a = scaled(values[i - 1]), b = scaled(values[i]), x = scaled(limit);
    if ((a <= x && x <= b) || (b <= x && x <= a)) return double(i) - 1 + (x - a) / (b - a);
  }
  const bool rising = values.front() <= values.back();
  return (limit < values.front()) == rising ? -0.5 : double(values.size()) - 0.5;
}

std::string stripsScript(const std::string& title, const std::vector<StripPanel>& panels,
                         const std::string& name) {
  const int rows = (int(panels.size()) + columns - 1) / columns;
  const int width = columns * panelWidth, each = panelHeight(panels);
  const int height = headRoom + rows * each;
  Script script(width, height);
  script.label(width / 2.0, 18, title, "center", "#000000", 14);
  addLegend(script);
  for (int i = 0; i < int(panels.size()); ++i)
    addPanel(script, panels[std::size_t(i)], double(i % columns) * panelWidth,
             headRoom + double(i / columns) * each);

  std::ostringstream out;
  out << "# Draws " << name << ".svg and " << name << ".png: gnuplot " << name << ".gp\n"
      << "do for [kind in \"svg png\"] {\n"
      << "if (kind eq \"svg\") { scale = 1.0; set terminal svg size " << width << ',' << height
      << " font 'DejaVu Sans," << fontSize << "' background '#ffffff' }\n"
      << "if (kind eq \"png\") { scale = 0.75; set terminal pngcairo size " << width << ','
      << height << " font 'DejaVu Sans," << fontSize * 3 / 4 << "' background '#ffffff' }\n"
      << "set output \"" << name << ".\".kind\n"
      << "unset border\nunset tics\nunset key\nset lmargin 0\nset rmargin 0\nset tmargin 0\n"
      << "set bmargin 0\nset xrange [0:1]\nset yrange [0:1]\n"
      << script.text() << "plot NaN\nunset object\nunset label\nunset arrow\nunset output\n}\n";
  return out.str();
}

std::string drawStrips(const std::string& title, const std::vector<StripPanel>& panels,
                       const std::filesystem::path& folder, const std::string& name) {
  return drawScript(stripsScript(title, panels, name), folder, name);
}

}  // namespace demos::report::stability
