// Figures: the words of a script mean what they say.
#include "demos/report/figure.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include "demos/process/other_command.h"

namespace demos::report {
namespace {

namespace fs = std::filesystem;

TEST(Figure, LiteralsAreNeitherEndedNorRun) {
  EXPECT_EQ(literal("a {b}_c"), R"("a {b}_c")");
  EXPECT_EQ(literal(R"(say "x" \n)"), R"("say \"x\" \\n")");
  EXPECT_EQ(literal("`ls`"), R"("\`ls\`")");
}

class FigureFile : public testing::Test {
 protected:
  fs::path folder_ = fs::temp_directory_path() / ("delassus_figure_" + std::to_string(getpid()));
  void SetUp() override {
    if (callCommand({"gnuplot", "--version"}).status != 0) GTEST_SKIP() << "no gnuplot here";
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
};

TEST_F(FigureFile, APanelWithoutDataLeavesTheOthers) {
  Panel full, empty;
  full.title = "full";
  Curve curve;
  curve.label = "delassus";
  curve.colour = "#0060a8";
  curve.line = {{1, 2}, {3, 4}};
  full.curves = {curve};
  empty.title = "empty";
  Figure figure;
  figure.title = "two";
  for (const auto& panels : {std::vector<Panel>{empty, full}, {full, empty}, {empty}}) {
    figure.panels = panels;
    EXPECT_EQ(draw(figure, folder_, "two"), "");
    EXPECT_GT(fs::file_size(folder_ / "two.svg"), 1000U);
    EXPECT_GT(fs::file_size(folder_ / "two.png"), 1000U);
  }
}

TEST_F(FigureFile, LeavesNoHalfAPicture) {
  EXPECT_EQ(drawScript("set terminal svg\nset output 'x.svg'\nplot sin(x)\n", folder_, "x"), "");
  EXPECT_TRUE(fs::exists(folder_ / "x.svg"));
  const std::string half = "set terminal svg\nset output 'x.svg'\nplot sin(x)\nplot nonsense(x)\n";
  EXPECT_NE(drawScript(half, folder_, "x").find("cannot draw x.gp"), std::string::npos);
  EXPECT_FALSE(fs::exists(folder_ / "x.svg"));
}

TEST(Figure, FaultsAreAllToldOnce) {
  std::string faults;
  for (const char* fault : {"", "a is missing", "b is wrong", "a is missing", ""})
    addFault(faults, fault);
  EXPECT_EQ(faults, "a is missing\n\nb is wrong\n\n");
}

}  // namespace
}  // namespace demos::report
