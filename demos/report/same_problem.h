#pragma once

#include "demos/report/csv.h"
#include "demos/report/settings.h"
#include "demos/scenes/scene.h"

namespace demos::report {

/// The heading of a scene's file: one row for each sampled step, view and method.
CsvTable sameProblemTable();

/// Gives the sampled steps of the scene to every method. The trajectory is that of `delassus`.
CsvTable measureSameProblem(const SceneDescription& scene, const Plan& plan,
                            const Progress& progress);

}  // namespace demos::report
