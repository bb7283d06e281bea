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

/// The message if gnuplot cannot be found.
constexpr const char* noGnuplot =
    "gnuplot is missing: no pictures, only data (apt-get install gnuplot-nox)";

/// Writes `name`.gp into the folder and has gnuplot draw `name`.svg and `name`.png from it. A fault
/// is returned as one line; the report then lacks this picture.
std::string draw(const Figure& figure, const std::filesystem::path& folder,
                 const std::string& name);

/// The same for a script that is already written.
std::string drawScript(const std::string& script, const std::filesystem::path& folder,
                       const std::string& name);

/// Adds a fault from `draw` to `faults`, each as a paragraph and only once.
void addFault(std::string& faults, const std::string& fault);

/// Columns for that many small panels: about square, at most four.
int panelColumns(std::size_t panels);

/// `text` in gnuplot's double quotes, with every letter taken as it is: otherwise text between
/// backticks would run as a shell command.
std::string literal(const std::string& text);

/// The script alone.
std::string gnuplotScript(const Figure& figure, const std::string& name);

/// Okabe and Ito's colours, which all eyes can tell apart. Ours is the strong blue; each family has
/// the same colour in all pictures.
std::string familyColour(const std::string& family);

}  // namespace demos::report
