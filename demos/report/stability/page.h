#pragma once

#include <filesystem>
#include <string>

#include "demos/report/part.h"
#include "demos/report/stability/trial.h"

namespace demos::report::stability {

/// The folders of the two precisions in the map's folder.
constexpr const char* precisions[] = {"double", "float"};

/// Writes the page and draws its pictures from all measures that are there, of both precisions.
void writeMapPage(const std::filesystem::path& out, const std::string& command,
                  const std::vector<SweepGroup>& groups, const MapPlan& plan, int missing);

/// The longest run of values over which a solver holds: "all", "none", "to 1e6", "from 1e-04", "1
/// to 100, then too slow".
std::string rangeOf(const std::vector<double>& values, const std::vector<Verdict>& verdicts);

}  // namespace demos::report::stability
