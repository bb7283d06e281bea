#include "demos/report/figure.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <sstream>

#include "delassus/whole_file.h"
#include "demos/process/other_command.h"
#include "demos/report/csv.h"
#include "demos/report/label_places.h"

namespace demos::report {

namespace {

constexpr int fontSize = 12, titleHeight = 40;
// Room for tics and names of the axes around a panel, and for the names at the ends of curves, in
// pixels.
constexpr int leftRoom = 74, rightRoom = 16, topRoom = 30, bottomRoom = 52;

std::string number(double value) {
  char word[32];
  std::snprintf(word, sizeof word, "%.6g", value);
  return word;
}

/// A curve that runs beyond this would leave the others no room on the axis (and cost time: gnuplot
/// counts the tics of 1e128).
constexpr double farthest = 1e12;

bool drawable(double value, bool log) { return std::abs(value) < farthest && (!log || value > 0); }

/// The range of an axis, with room at both ends; whole decades at the low end of a logarithmic one.
struct Range {
  double least = std::numeric_limits<double>::infinity(), most = -least;
  void take(double value, bool log) {
    if (!drawable(value, log)) return;
    least = std::min(least, value);
    most = std::max(most, value);
  }
};

struct Axes {
  Range x, y;
  bool empty() const { return !(x.least <= x.most && y.least <= y.most); }
};

double letterWidth(const Figure& figure) {
  return 0.58 * fontSize / (figure.panelWidth - leftRoom - rightRoom);
}
double lineHeight(const Figure& figure) {
  return 1.35 * fontSize / (figure.panelHeight - topRoom - bottomRoom);
}

/// Calls `visit(place, name)` for everything that is drawn; most of it has no name.
template <class Visit>
void forEachPlace(const Panel& panel, const Visit& visit) {
  const auto offer = [&](const Place& place, const std::string& name) {
    if (drawable(place.x, panel.logX) && drawable(place.y, panel.logY)) visit(place, name);
  };
  for (const Curve& curve : panel.curves) {
    for (std::size_t i = 0; i < curve.marks.size(); ++i)
      offer(curve.marks[i], i < curve.markLabels.size() ? curve.markLabels[i] : "");
    for (const Place& place : curve.line)
      offer(place, &place == &curve.line.back() ? curve.label : "");
  }
}

Range verticalRange(const Panel& panel) {
  Range y;
  forEachPlace(panel, [&](const Place& place, const std::string&) { y.take(place.y, panel.logY); });
  const bool fixed = panel.yMost > panel.yLeast;
  if (fixed && (!panel.logY || panel.yLeast > 0)) return {panel.yLeast, panel.yMost};
  if (panel.logY) {
    if (fixed) y.most = std::max(y.least, std::min(y.most, panel.yMost));
    return {std::pow(10, std::floor(std::log10(y.least) - 0.2)),
            std::pow(10, std::ceil(std::log10(y.most) + 0.1))};
  }
  const double span = std::max(y.most - y.least, 1e-9);
  return {y.least - 0.06 * span, y.most + 0.1 * span};
}

/// As wide as the data and the names to their right need.
Range horizontalRange(const Panel& panel, double letter) {
  Range x;
  const auto scaled = [&](double value) { return panel.logX ? std::log10(value) : value; };
  forEachPlace(panel, [&](const Place& place, const std::string&) { x.take(place.x, panel.logX); });
  const double least = scaled(x.least), most = scaled(x.most);
  const double margin = 0.06, span = std::max(most - least, 0.5);
  double dataShare = 1 - margin;
  forEachPlace(panel, [&](const Place& place, const std::string& name) {
    const double at = margin + (scaled(place.x) - least) / span;
    dataShare = std::min(dataShare, (1 - letter * (double(name.size()) + 2)) / at);
  });
  const double width = span / std::max(dataShare, 0.4);
  const double from = least - margin * width, to = from + (1 + margin) * width;
  return panel.logX ? Range{std::pow(10, from), std::pow(10, to)} : Range{from, to};
}

Axes axesOf(const Figure& figure, const Panel& panel) {
  bool any = false;
  forEachPlace(panel, [&any](const Place&, const std::string&) { any = true; });
  if (!any) return {};
  return {horizontalRange(panel, letterWidth(figure)), verticalRange(panel)};
}

/// The place of a value in its range, from 0 to 1.
double fraction(double value, const Range& range, bool log) {
  const double share = log ? std::log(value / range.least) / std::log(range.most / range.least)
                           : (value - range.least) / (range.most - range.least);
  return std::clamp(share, 0.0, 1.0);
}

void writeData(std::ostream& script, const std::string& name, const std::vector<Place>& places,
               const Panel& panel, const Axes& axes) {
  script << "$" << name << " << EOD\n";
  for (const Place& place : places) {
    if (!drawable(place.x, panel.logX) || !drawable(place.y, panel.logY)) continue;
    // A value beyond the axis is drawn on its border.
    const double y = std::clamp(place.y, axes.y.least, axes.y.most);
    const bool spread = place.xHigh > 0;
    script << number(place.x) << ' ' << number(y) << ' ' << number(spread ? place.xLow : place.x)
           << ' ' << number(spread ? place.xHigh : place.x) << '\n';
  }
  script << "EOD\n";
}

bool anyDrawable(const std::vector<Place>& places, const Panel& panel) {
  return std::any_of(places.begin(), places.end(), [&panel](const Place& place) {
    return drawable(place.x, panel.logX) && drawable(place.y, panel.logY);
  });
}

std::string dataName(std::size_t panel, std::size_t curve, const char* kind) {
  return std::string(kind) + std::to_string(panel) + "_" + std::to_string(curve);
}

/// The names at the ends of curves, and of single marks, where they find room.
std::vector<Label> labelsOf(const Figure& figure, const Panel& panel, const Axes& axes) {
  std::vector<Label> labels;
  std::vector<Dot> dots;
  const auto dotAt = [&](const Place& place) {
    return Dot{fraction(place.x, axes.x, panel.logX), fraction(place.y, axes.y, panel.logY)};
  };
  for (const Curve& curve : panel.curves) {
    const auto offer = [&](const Place& place, const std::string& name) {
      const Dot dot = dotAt(place);
      dots.push_back(dot);
      if (!name.empty()) labels.push_back({name, curve.colour, dot.x, dot.y});
    };
    Panel alone = panel;
    alone.curves = {curve};
    forEachPlace(alone, offer);
    // Lines are rows of dots.
    constexpr int dotsPerLine = 40;
    for (std::size_t i = 1; i < curve.line.size(); ++i) {
      const Dot a = dotAt(curve.line[i - 1]), b = dotAt(curve.line[i]);
      for (int k = 1; k < dotsPerLine; ++k) {
        const double share = double(k) / dotsPerLine;
        dots.push_back({a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)});
      }
    }
  }
  return placeLabels(labels, dots, letterWidth(figure), lineHeight(figure));
}

void writeAxis(std::ostream& script, char axis, const Range& range, bool log,
               const std::string& name) {
  script << (log ? "set" : "unset") << " logscale " << axis << '\n';
  // Tics at decades read as powers where there are many of them.
  const double decades = log ? std::log10(range.most / range.least) : 0;
  const int every = std::max(1, int(std::ceil(decades / 6)));
  if (log && decades <= 1.8) {
    // Few decades: 1, 2, 5 of each.
    script << "set " << axis << "tics nomirror (";
    std::string separator;
    for (int power = int(std::floor(std::log10(range.least))); power <= std::log10(range.most);
         ++power)
      for (const int digit : {1, 2, 5}) {
        script << separator << number(digit * std::pow(10, power));
        separator = ", ";
      }
    script << ")\n";
  } else if (log)
    script << "set " << axis << "tics " << number(std::pow(10, every)) << " nomirror\n";
  else
    script << "set " << axis << "tics autofreq nomirror\n";
  script << (every > 1 ? "unset m" : "set m") << axis << "tics\n";
  script << "set format " << axis << (log && decades > 4 ? " \"10^{%T}\"\n" : " \"%g\"\n");
  script << "set " << axis << "range [" << number(range.least) << ':' << number(range.most)
         << "]\n";
  script << "set " << axis << "label " << literal(name) << " noenhanced\n";
}

void writePanel(std::ostream& script, const Figure& figure, std::size_t index) {
  const Panel& panel = figure.panels[index];
  const Axes axes = axesOf(figure, panel);
  script << "set title " << literal(panel.title) << " noenhanced\n";
  if (axes.empty()) {
    script << "unset logscale\nunset xlabel\nunset ylabel\nset xrange [0:1]\nset yrange [0:1]\n"
           << "unset label\nunset arrow\nunset object\nunset xtics\nunset ytics\n"
           << "set label \"nothing to show\" at graph 0.5, graph 0.5 center\nplot NaN\n";
    return;
  }
  writeAxis(script, 'x', axes.x, panel.logX, panel.xLabel);
  writeAxis(script, 'y', axes.y, panel.logY, panel.yLabel);
  script << "unset label\nunset arrow\nunset object\n";
  if (panel.unknownBelow > 0 && panel.unknownBelow > axes.y.least)
    script << "set object 1 rectangle from graph 0, graph 0 to graph 1, first "
           << number(std::min(panel.unknownBelow, axes.y.most))
           << " behind fillstyle solid noborder fillcolor '#eeeeee'\n";

  for (const Label& label : labelsOf(figure, panel, axes)) {
    script << "set label " << literal(label.text) << " at graph " << number(label.textX)
           << ", graph " << number(label.textY) << " left front noenhanced textcolor rgb '"
           << label.colour << "'\n";
    // A name that had to move away is tied to its point.
    const double end = label.textX + letterWidth(figure) * double(label.text.size());
    if (std::abs(label.textY - label.y) > 0.8 * lineHeight(figure))
      script << "set arrow from graph " << number(label.x) << ", graph " << number(label.y)
             << " to graph " << number(label.textX > label.x ? label.textX : end) << ", graph "
             << number(label.textY) << " nohead lw 0.6 lc rgb '" << label.colour << "'\n";
  }

  std::string separator = "plot ";
  const auto plot = [&](const std::string& data, const std::string& style) {
    script << separator << "$" << data << ' ' << style;
    separator = ", \\\n  ";
  };
  for (std::size_t i = 0; i < panel.curves.size(); ++i) {
    const Curve& curve = panel.curves[i];
    const std::string colour = "lc rgb '" + curve.colour + "'";
    const std::string faint = "lc rgb '#a0" + curve.colour.substr(1) + "'";
    if (anyDrawable(curve.marks, panel))
      plot(dataName(index, i, "marks"),
           "using 1:2 with points pt 7 ps 0.45 " + (curve.markLabels.empty() ? faint : colour));
    if (!anyDrawable(curve.line, panel)) continue;
    const std::string data = dataName(index, i, "line");
    plot(data, "using 1:2:3:4 with xerrorbars pt 0 lw 0.8 " + faint);
    if (curve.joined) plot(data, "using 1:2 with lines lw " + number(curve.width) + " " + colour);
    plot(data, "using 1:2 with points pt 7 ps " + number(0.35 + 0.15 * curve.width) + " " + colour);
  }
  if (separator == "plot ") script << "plot NaN";
  script << '\n';
}

}  // namespace

std::string literal(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '"' || c == '\\' || c == '`') out += '\\';
    out += c;
  }
  return '"' + out + '"';
}

std::string familyColour(const std::string& family) {
  static const std::map<std::string, std::string> colours{
      {"delassus", "#0060a8"}, {"si", "#d55e00"},      {"si2", "#e69f00"},  {"nncg", "#009e73"},
      {"pgs", "#cc79a7"},      {"dantzig", "#555555"}, {"lemke", "#999999"}};
  const auto found = colours.find(family);
  return found != colours.end() ? found->second : "#777777";
}

int panelColumns(std::size_t panels) {
  return std::clamp(int(std::ceil(std::sqrt(double(panels)))), 1, 4);
}

std::string gnuplotScript(const Figure& figure, const std::string& name) {
  const int rows = (int(figure.panels.size()) + figure.columns - 1) / figure.columns;
  const int width = figure.columns * figure.panelWidth;
  const int height = rows * figure.panelHeight + titleHeight;
  std::ostringstream script;
  script << "# Draws " << name << ".svg and " << name << ".png: gnuplot " << name << ".gp\n";
  for (std::size_t i = 0; i < figure.panels.size(); ++i) {
    const Panel& panel = figure.panels[i];
    const Axes axes = axesOf(figure, panel);
    if (axes.empty()) continue;
    for (std::size_t k = 0; k < panel.curves.size(); ++k) {
      writeData(script, dataName(i, k, "line"), panel.curves[k].line, panel, axes);
      writeData(script, dataName(i, k, "marks"), panel.curves[k].marks, panel, axes);
    }
  }
  script << "do for [kind in \"svg png\"] {\n"
         << "if (kind eq \"svg\") { set terminal svg size " << width << ',' << height
         << " font 'DejaVu Sans," << fontSize << "' background '#ffffff' }\n"
         << "if (kind eq \"png\") { set terminal pngcairo size " << width << ',' << height
         << " font 'DejaVu Sans," << fontSize * 3 / 4 << "' background '#ffffff' }\n"
         << "set output " << literal(name + ".") << ".kind\n"
         << "set border 3 lc rgb '#666666'\nset grid back lw 0.6 lc rgb '#e4e4e4'\n"
         << "set tics textcolor rgb '#333333'\nunset key\n"
         << "set multiplot title " << literal(figure.title) << " noenhanced\n";
  for (int i = 0; i < int(figure.panels.size()); ++i) {
    const int row = i / figure.columns, column = i % figure.columns;
    const double left = column * figure.panelWidth + leftRoom;
    const double right = (column + 1) * figure.panelWidth - rightRoom;
    const double top = height - titleHeight - row * figure.panelHeight - topRoom;
    const double bottom = height - titleHeight - (row + 1) * figure.panelHeight + bottomRoom;
    script << "set lmargin at screen " << number(left / width) << "\nset rmargin at screen "
           << number(right / width) << "\nset tmargin at screen " << number(top / height)
           << "\nset bmargin at screen " << number(bottom / height) << '\n';
    writePanel(script, figure, std::size_t(i));
  }
  script << "unset multiplot\n}\n";
  return script.str();
}

std::string draw(const Figure& figure, const std::filesystem::path& folder,
                 const std::string& name) {
  return drawScript(gnuplotScript(figure, name), folder, name);
}

std::string drawScript(const std::string& script, const std::filesystem::path& folder,
                       const std::string& name) {
  // Removes pictures, so that neither an older one nor half of one passes for this one.
  const auto removePictures = [&] {
    for (const char* kind : {".svg", ".png"}) std::filesystem::remove(folder / (name + kind));
  };
  removePictures();
  delassus::writeFile(folder / (name + ".gp"), script);
  const CommandResult drawn =
      callCommand({"env", "--chdir=" + folder.string(), "gnuplot", name + ".gp"});
  if (drawn.status == 0) return "";
  removePictures();
  if (drawn.status == 127) return noGnuplot;
  return "gnuplot cannot draw " + name + ".gp: " + drawn.text;
}

void addFault(std::string& faults, const std::string& fault) {
  if (!fault.empty() && faults.find(fault) == std::string::npos) faults += fault + "\n\n";
}

}  // namespace demos::report
