// The atlas as its users meet it: what it writes, that it repeats byte for byte, and that theory
// and Bullet agree in it.
#include <gtest/gtest.h>

#include <regex>

#include "tests/command_call.h"

namespace {

namespace fs = std::filesystem;

using delassus::test::lines;
using delassus::test::Outcome;
using delassus::test::read;

class Atlas : public delassus::test::CommandCall {
 protected:
  Outcome draw(const fs::path& out) const { return call("atlas --out " + out.string()); }
};

TEST_F(Atlas, DrawsEveryFigureAsVectorsAndPixels) {
  const Outcome outcome = draw(folder_ / "atlas");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
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

TEST_F(Atlas, FindsBulletWhereTheorySays) {
  const auto [status, out, err] = draw(folder_ / "atlas");
  ASSERT_EQ(status, 0) << err;
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

TEST_F(Atlas, RepeatsByteForByte) {
  ASSERT_EQ(draw(folder_ / "once").status, 0);
  ASSERT_EQ(draw(folder_ / "twice").status, 0);
  for (const auto& file : fs::directory_iterator(folder_ / "once"))
    EXPECT_TRUE(read(file.path()) == read(folder_ / "twice" / file.path().filename()))
        << file.path();
}

TEST_F(Atlas, NamesTheFileThatCannotBeWritten) {
  write("file", "in the way");
  const Outcome outcome = draw(folder_ / "file");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.err.find(file("file")), std::string::npos) << outcome.err;
  EXPECT_EQ(lines(outcome.err), 1) << outcome.err;
  EXPECT_EQ(read(folder_ / "file"), "in the way");
}

}  // namespace
