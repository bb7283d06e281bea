// CSV files: what is written can be read, and a file is either whole or not there.
#include "demos/report/csv.h"
#include "delassus/whole_file.h"

#include <gtest/gtest.h>

#include <cmath>

namespace demos::report {
namespace {

class Csv : public testing::Test {
 protected:
  std::filesystem::path folder_ = std::filesystem::temp_directory_path() /
                                  (std::string("delassus_csv_") +
                                   testing::UnitTest::GetInstance()->current_test_info()->name());
  void SetUp() override { std::filesystem::create_directories(folder_); }
  void TearDown() override { std::filesystem::remove_all(folder_); }
};

TEST_F(Csv, ReadsWhatItWrote) {
  CsvTable table({"name", "value"});
  const std::vector<std::string> words{"plain", "a,b", "say \"so\"", "", "delassus:1e-4"};
  for (std::size_t i = 0; i < words.size(); ++i) table.add({words[i], csvNumber(1 / (1.0 + i))});
  table.write(folder_ / "t.csv");
  const CsvTable read = CsvTable::read(folder_ / "t.csv");
  ASSERT_EQ(read.rows(), int(words.size()));
  for (int i = 0; i < read.rows(); ++i) {
    EXPECT_EQ(read.text(i, "name"), words[std::size_t(i)]);
    EXPECT_NEAR(read.number(i, "value"), 1 / (1.0 + i), 1e-9);
  }
}

TEST_F(Csv, TellsWordsFromNumbers) {
  CsvTable table({"value"});
  for (const char* word : {"nan", "", "12 apples", "done"}) table.add({word});
  for (int i = 0; i < table.rows(); ++i) EXPECT_TRUE(std::isnan(table.number(i, "value"))) << i;
  EXPECT_THROW(table.text(0, "other"), std::out_of_range);
}

TEST_F(Csv, RefusesALineOfAnotherLength) {
  delassus::writeFile(folder_ / "t.csv", "a,b\n1,2\n3\n");
  EXPECT_THROW(CsvTable::read(folder_ / "t.csv"), std::runtime_error);
}

TEST_F(Csv, LeavesNothingUnfinishedBehind) {
  CsvTable({"a"}).write(folder_ / "t.csv");
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder_)) {
    EXPECT_EQ(entry.path().filename(), "t.csv");
    ++files;
  }
  EXPECT_EQ(files, 1);
  EXPECT_THROW(CsvTable({"a"}).write(folder_ / "no" / "t.csv"), std::runtime_error);
}

// A folder is in the way of the file: everything is written but for the last step.
TEST_F(Csv, LeavesNothingUnfinishedBehindWhenItFails) {
  std::filesystem::create_directories(folder_ / "t.csv" / "in the way");
  EXPECT_THROW(CsvTable({"a"}).write(folder_ / "t.csv"), std::runtime_error);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_), {}), 1);
}

}  // namespace
}  // namespace demos::report
