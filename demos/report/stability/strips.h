#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "demos/report/stability/trial.h"

namespace demos::report::stability {

/// One row of cells: one solver in one precision, over all values of a sweep.
struct Strip {
  std::string label;
  std::vector<Verdict> cells;
  double limit = 0;  ///< a line between the values around it; 0: none
};

/// Strips one below the other, all with a cell for each value: one sweep by all solvers, or two
/// things at once by one solver.
struct StripPanel {
  std::string title, axis;
  std::vector<double> values;  ///< from left to right
  std::vector<Strip> strips;
};

/// Writes `name`.gp into the folder and has gnuplot draw `name`.svg and `name`.png from it, with
/// two panels beside each other under a legend. A fault is returned as one line.
std::string drawStrips(const std::string& title, const std::vector<StripPanel>& panels,
                       const std::filesystem::path& folder, const std::string& name);

/// The script alone.
std::string stripsScript(const std::string& title, const std::vector<StripPanel>& panels,
                         const std::string& name);

/// A value as tics and tables show it: 0.0001, 240, 1e6, 1e-9.
std::string tic(double value);

/// The place of `limit` among the middles of the cells, counted from 0; values rise or fall.
double placeAmong(const std::vector<double>& values, double limit);

}  // namespace demos::report::stability
