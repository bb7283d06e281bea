// The atlas as its users meet it: what is written, that it repeats byte for byte, and that theory
// and Bullet agree in it.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>

namespace {

namespace fs = std::filesystem;

std::string read(const fs::path& path) {
  std::stringstream bytes;
  bytes << std::ifstream(path, std::ios::binary).rdbuf();
  return bytes.str();
}

class Atlas : public testing::Test {
 protected:
  fs::path folder_ =
      fs::temp_directory_path() / ("delassus_atlas_" + std::to_string(getpid()) +
                                   testing::UnitTest::GetInstance()->current_test_info()->name());
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }

  /// Exit status of `delassus atlas --out OUT`; its output is in the files out and err.
  int draw(const fs::path& out) const {
    const std::string line = std::string(DELASSUS_COMMAND) + " atlas --out " + out.string() + " >" +
                             (folder_ / "out").string() + " 2>" + (folder_ / "err").string();
    const int answer = std::system(line.c_str());
    EXPECT_TRUE(WIFEXITED(answer));
    return WEXITSTATUS(answer);
  }
};

TEST_F(Atlas, drawsEveryFigureAsVectorsAndPixels) {
  ASSERT_EQ(draw(folder_ / "atlas"), 0) << read(folder_ / "err");
  int files = 0;
  for (const char* figure :
       {"two_contacts", "three_contacts", "rough_contact", "intuition", "moving_load"}) {
    const std::string png = read(folder_ / "atlas" / (std::string(figure) + ".png"));
    EXPECT_EQ(png.substr(0, 8), "\x89PNG\r\n\x1a\n") << figure;
    const std::string svg = read(folder_ / "atlas" / (std::string(figure) + ".svg"));
    EXPECT_EQ(svg.substr(0, 5), "<?xml") << figure;
    EXPECT_NE(svg.find("</svg>"), std::string::npos) << figure;
    files += 2;
  }
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_ / "atlas"), {}), files)
      << "nothing is left beside the figures";
}

TEST_F(Atlas, findsBulletWhereTheorySays) {
  ASSERT_EQ(draw(folder_ / "atlas"), 0) << read(folder_ / "err");
  const std::string out = read(folder_ / "out");
  const std::regex count("([0-9]+) of ([0-9]+)");
  int counts = 0;
  for (std::sregex_iterator it(out.begin(), out.end(), count), end; it != end; ++it, ++counts)
    EXPECT_EQ((*it)[1], (*it)[2]) << out;
  EXPECT_EQ(counts, 4) << out;
  EXPECT_TRUE(std::regex_search(
      out, std::regex("f₁ = −.*, f₂ = −.*: kept 1; f₁ = \\+.*, f₂ = −.*: kept none")))
      << out;
  EXPECT_NE(out.find("the weight leaves through a face, the hook through the vertex"),
            std::string::npos)
      << out;
}

TEST_F(Atlas, repeatsByteForByte) {
  ASSERT_EQ(draw(folder_ / "once"), 0);
  ASSERT_EQ(draw(folder_ / "twice"), 0);
  for (const auto& file : fs::directory_iterator(folder_ / "once"))
    EXPECT_TRUE(read(file.path()) == read(folder_ / "twice" / file.path().filename()))
        << file.path();
}

TEST_F(Atlas, namesTheFileThatCannotBeWritten) {
  std::ofstream(folder_ / "file") << "in the way";
  EXPECT_EQ(draw(folder_ / "file"), 1);
  const std::string err = read(folder_ / "err");
  EXPECT_NE(err.find((folder_ / "file").string()), std::string::npos) << err;
  EXPECT_EQ(std::count(err.begin(), err.end(), '\n'), 1) << err;
  EXPECT_EQ(read(folder_ / "file"), "in the way");
}

}  // namespace
