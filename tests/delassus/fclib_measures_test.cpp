#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "delassus/problem_text.h"
#include "delassus/residual.h"
#include "tests/support/shared_data.h"

namespace delassus {
namespace {

/// The published list of problems states `rel` at r = 0, in two digits, computed by others.
TEST(FclibMeasures, AgreeWithThePublishedListAtRest) {
  if (test::sharedFolder().empty()) GTEST_SKIP() << test::noSharedFolder;
  std::ifstream list(test::sharedFolder() / "problems" / "PROBLEMS.md");
  int checked = 0;
  for (std::string line; std::getline(list, line);) {
    std::vector<std::string> cells;
    std::istringstream in(line);
    for (std::string cell; std::getline(in, cell, '|');) {
      const auto begin = cell.find_first_not_of(' ');
      cells.push_back(begin == std::string::npos
                          ? ""
                          : cell.substr(begin, cell.find_last_not_of(' ') + 1 - begin));
    }
    if (cells.size() < 5) continue;
    for (const char* suffix : {".fc3d", ".lcp"}) {
      const auto file = test::sharedFolder() / "problems" / (cells[1] + suffix);
      if (!std::filesystem::exists(file)) continue;
      const Problem problem = readProblem(file.string());
      const double published = std::stod(cells[cells.size() - 2]);
      const double rel = fclibMeasures(problem, VectorXd::Zero(problem.size())).rel;
      EXPECT_NEAR(rel, published, 0.0501 * published) << cells[1];
      ++checked;
    }
  }
  EXPECT_GT(checked, 0);
}

}  // namespace
}  // namespace delassus
