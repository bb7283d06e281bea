#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "demos/report/methods.h"

namespace demos::report {

/// The user's wishes.
struct ReportArguments {
  std::vector<std::string> scenes, solvers, parts;  ///< empty: the report's own choice
  std::string out = "report";
  bool quick = false;
  bool resume = false;
  bool stability = false;     ///< the stability map in place of the report
  bool onePrecision = false;  ///< of the map: without the other executable

  /// The command that makes the same report when called from the same folder, with the executable
  /// as it was called.
  std::string command() const;
  /// The same, whatever the executable and the folder.
  std::string commandAnywhere() const;

 private:
  /// The command without its first word and the folder.
  std::string words() const;
};

/// The plan of the report. Full takes under 40 minutes on two slow cores, quick under 3.
struct Plan {
  bool quick = false;
  std::vector<std::string> scenes;  ///< of same problem and own trajectory
  std::vector<Method> methods;      ///< given the same problems
  std::vector<Method> trajectoryMethods, stepMethods, scalingMethods;

  Timing timing;              ///< on the same problem
  Timing scalingTiming;       ///< on one problem of a size
  int memorySteps;            ///< steps that a method's own warm start is made of
  double trajectorySeconds;   ///< simulated, s, at most
  double scoutLimit;          ///< wall-clock limit of the run that finds the steps to sample, s
  double certificateLimit;    ///< of one solve of v*, s
  double trajectoryLimit;     ///< of one method's own trajectory, s
  std::vector<double> rates;  ///< steps a second of the time-step part
  std::vector<std::string> ablationScenes;
  double ablationSeconds;          ///< simulated, s, at most
  double ablationLimit;            ///< of one scene, s
  std::vector<int> contactCounts;  ///< wanted in the scaling part
};

/// Throws UnknownSolver or UnknownScene.
Plan makePlan(const ReportArguments& arguments);

/// A function that is told the fraction done.
using Progress = std::function<void(double)>;

}  // namespace demos::report
