#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace delassus::test {

/// What a call of the command left: its exit status and both outputs.
struct Outcome {
  int status;
  std::string out, err;
};

/// The bytes of a file; empty if there is no such file.
inline std::string read(const std::filesystem::path& path) {
  std::stringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

inline int lines(const std::string& text) {
  return int(std::count(text.begin(), text.end(), '\n'));
}

/// Calls `delassus` as its users do, with a folder of the test's own, which is removed afterwards.
class CommandCall : public testing::Test {
 protected:
  std::filesystem::path folder_ = [] {
    const testing::TestInfo& test = *testing::UnitTest::GetInstance()->current_test_info();
    return std::filesystem::temp_directory_path() / ("delassus_" + std::to_string(getpid()) + "_" +
                                                     test.test_suite_name() + "_" + test.name());
  }();
  void SetUp() override { std::filesystem::create_directories(folder_); }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string file(const std::string& name) const { return (folder_ / name).string(); }
  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(file(name), std::ios::binary) << text;
    return file(name);
  }

  /// `before` goes before the command: "PATH=/nowhere", "timeout 1".
  Outcome call(const std::string& arguments, const std::string& before = "") const {
    const std::string out = file("stdout"), err = file("stderr");
    const std::string line =
        before + " " + DELASSUS_COMMAND + " " + arguments + " >" + out + " 2>" + err;
    const int answer = std::system(line.c_str());
    EXPECT_TRUE(WIFEXITED(answer)) << arguments;
    return {WEXITSTATUS(answer), read(out), read(err)};
  }
};

}  // namespace delassus::test
