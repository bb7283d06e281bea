#pragma once

#include "demos/report/settings.h"

namespace demos::report::stability {

/// Measures the stability map in both precisions, the other one by the executable beside this one
/// at the same time, and writes stability.md. `parts` of the arguments are groups of sweeps.
/// Returns false if it was interrupted.
bool makeMap(const ReportArguments& arguments);

}  // namespace demos::report::stability
