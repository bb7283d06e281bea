// What the page says of the measures on one and the same problem.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "demos/report/part.h"
#include "demos/report/same_problem.h"

namespace demos::report {
namespace {

namespace fs = std::filesystem;

/// Writes a scene's file in which every measure is 1. Each of `agreements` says how well v* is
/// known in one sample.
void writeMeasures(const fs::path& file, const std::vector<const char*>& agreements) {
  const char* phases[] = {"cold", "impact", "settling", "resting"};
  CsvTable table = sameProblemTable();
  for (std::size_t i = 0; i < agreements.size(); ++i)
    for (const char* view : {"cold", "warm"})
      table.add({phases[i], "1", "1",    "1", view,          "si:10", "si", "done", "1",
                 "1",       "1", "1",    "1", "1",           "1",     "1",  "1",    "1",
                 "1",       "1", "done", "1", agreements[i], "1",     "1"});
  table.write(file);
}

// Without a remark, a table of the samples that are left would be taken for a table of all.
TEST(SameProblemWords, TellOfHowManySamplesTheMotionIsKnown) {
  const fs::path folder =
      fs::temp_directory_path() / ("delassus_same_problem_words_" + std::to_string(getpid()));
  fs::create_directories(folder / "same_problem");
  writeMeasures(folder / "same_problem" / "spheres_bin.csv", {"1e-9", "1e-9", "0.5", "nan"});
  writeMeasures(folder / "same_problem" / "stack_10.csv", {"1e-9", "1e-9", "1e-9", "1e-9"});
  Plan plan;
  plan.scenes = {"spheres_bin", "stack_10"};
  const std::string front = sameProblemPart(plan).write(folder).front;
  fs::remove_all(folder);

  // The warm view leaves out the cold sample.
  const std::size_t warm = front.find("| spheres_bin (1 of 3 samples) | 1 |"),
                    cold = front.find("| spheres_bin (2 of 4 samples) | 1 |");
  EXPECT_LT(warm, cold) << front;
  EXPECT_NE(cold, std::string::npos) << front;
  EXPECT_NE(front.find("| stack_10 | 1 |"), std::string::npos) << front;
  EXPECT_EQ(front.find("| stack_10 ("), std::string::npos) << front;
}

}  // namespace
}  // namespace demos::report
