#pragma once

#include "demos/report/settings.h"

namespace demos::report::stability {

/// Measures the stability map in both precisions and writes stability.md. The executable beside
/// this one measures the other precision at the same time. `parts` of the arguments are groups of
/// sweeps. Returns false if it was interrupted.
bool makeMap(const ReportArguments& arguments);

}  // namespace demos::report::stability
