#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace demos::report {

struct Place {
  double x, y;
  double xLow = 0, xHigh = 0;  ///< spread of x; none if both are zero
};

/// One line with its name at its end, and faint marks that belong to it.
struct Curve {
  std::string label;
  std::string colour;  ///< #rrggbb
  double width = 1.5;
  std::vector<Place> line, marks;
  bool joined = true;  ///< false: marks alone, each with its own name in `markLabels`
  std::vector<std::string> markLabels;
};

struct Panel {
  std::string title, xLabel, yLabel;
  bool logX = true, logY = true;
  double yLeast = 0, yMost = 0;  ///< limits of the axis; zero: as the data ask
  double unknownBelow = 0;       ///< y below which the truth is not known: shaded
  std::vector<Curve> curves;
};

struct Figure {
  std::string title;
  int columns = 2;
  int panelWidth = 520, panelHeight = 430;  ///< pixels
  std::vector<Panel> panels;
};

/// What is said where gnuplot cannot be found.
constexpr const char* noGnuplot =
    "gnuplot is missing: no pictures, only data (apt-get install gnuplot-nox)";

/// Writes `name`.gp into the folder and has gnuplot draw `name`.svg and `name`.png from it. What is
/// wrong, if anything, is returned as one line; the report is then one without this picture.
std::string draw(const Figure& figure, const std::filesystem::path& folder,
                 const std::string& name);

/// The same for a script that is already written.
std::string drawScript(const std::string& script, const std::filesystem::path& folder,
                       const std::string& name);

/// Adds what `draw` returned to `faults`, each a paragraph, and each once.
void addFault(std::string& faults, const std::string& fault);

/// Columns for that many small panels: about square, at most four.
int panelColumns(std::size_t panels);

/// `text` in gnuplot's double quotes, letter by letter: what stands between backticks would be run
/// as a command of the shell.
std::string literal(const std::string& text);

/// The script alone.
std::string gnuplotScript(const Figure& figure, const std::string& name);

/// Okabe and Ito's colours, told apart by all; ours is the strong blue, everybody keeps one colour
/// in all pictures.
std::string familyColour(const std::string& family);

}  // namespace demos::report
