#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "demos/report/pareto.h"

namespace demos::report {

/// One scene in one view, over its samples: a summary of the scene's file.
struct SceneView {
  std::string scene, view;  ///< view: cold or warm
  int samples = 0, contacts = 0, rows = 0;
  double residual = 0;  ///< of v*, the worst sample's, m/s
  double floor = 0;     ///< errors below it count as equal: the precision of v*
  int uncertain = 0;    ///< samples left out since v* is not known well enough
  /// Error of the motion: the worst of the samples; cost: mean of the samples, ms.
  std::vector<Effort> motion;
  std::vector<Effort> modes;      ///< error: mean share of contacts in a wrong mode
  std::vector<Effort> residuals;  ///< error: the worst natural residual, m/s
  std::vector<std::pair<std::string, std::string>> excluded;  ///< method and why

  /// The work of our solver, by its name: shares of its time, and counts a step.
  struct Work {
    std::string method;
    double aroundShare, regions, factorisations;
  };
  std::vector<Work> work;
};

/// Reads the file of a scene. The warm view leaves out the cold sample, where nothing is remembered
/// yet.
SceneView readSceneView(const std::filesystem::path& file, const std::string& scene,
                        const std::string& view);

/// The scenes of the plan whose file is there.
std::vector<SceneView> readSceneViews(const std::filesystem::path& folder,
                                      const std::vector<std::string>& scenes,
                                      const std::string& view);

}  // namespace demos::report
