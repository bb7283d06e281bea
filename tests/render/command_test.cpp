// `delassus render` as its users meet it.
#include <gtest/gtest.h>

#include "tests/command_call.h"
#include "tests/render/image_file.h"

namespace {

namespace fs = std::filesystem;

using delassus::test::lines;
using delassus::test::Outcome;
using delassus::test::read;

class RenderCommand : public delassus::test::CommandCall {
 protected:
  Outcome render(const std::string& arguments, const std::string& before = "") const {
    return call("render " + arguments, before);
  }
  void expectOneLine(const Outcome& outcome, const std::string& mentions) const {
    EXPECT_EQ(outcome.status, 1);
    EXPECT_EQ(lines(outcome.err), 1) << outcome.err;
    EXPECT_NE(outcome.err.find(mentions), std::string::npos) << outcome.err;
  }
};

TEST_F(RenderCommand, SideBySideRepeatsItsBytes) {
  const std::string arguments = "one_box --solver delassus,si:10 --at 0.1 --size 320x180 --out ";
  EXPECT_EQ(render(arguments + file("a")).status, 0);
  EXPECT_EQ(render(arguments + file("b")).status, 0);
  const std::string first = read(file("a/one_box.png"));
  EXPECT_GT(first.size(), 1000u);
  EXPECT_EQ(first, read(file("b/one_box.png")));
}

TEST_F(RenderCommand, SizeAndNameAreAsAsked) {
  const Outcome outcome =
      render("one_box --at 0,0.1,0.2 --plain --size 300x100 --out " + file("a"));
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.out, file("a/one_box.png") + "\n");
  const auto image = demos::render::loadPng(file("a/one_box.png"));
  EXPECT_EQ(image.size.width, 300);
  EXPECT_EQ(image.size.height, 100);
}

TEST_F(RenderCommand, CameraChangesThePicture) {
  EXPECT_EQ(render("one_box --at 0 --size 160x90 --out " + file("a")).status, 0);
  EXPECT_EQ(render("one_box --at 0 --size 160x90 --camera 0,1,9 --look-at 0,0,0 --out " + file("b"))
                .status,
            0);
  EXPECT_NE(read(file("a/one_box.png")), read(file("b/one_box.png")));
}

TEST_F(RenderCommand, UnknownSceneNamesTheNearest) {
  expectOneLine(render("stack10 --out " + file("a")), "stack_10");
  EXPECT_FALSE(fs::exists(file("a"))) << "nothing is made for a scene that is not there";
}

TEST_F(RenderCommand, FolderThatCannotBeWritten) {
  write("plain", "x");
  expectOneLine(render("one_box --at 0 --out " + file("plain")), file("plain"));
}

TEST_F(RenderCommand, NoContextIsTold) {
  // Mesa then offers less than the requested 3.3 core profile.
  expectOneLine(
      render("one_box --at 0 --size 160x90 --out " + file("a"), "MESA_GL_VERSION_OVERRIDE=2.1"),
      "no OpenGL");
  EXPECT_FALSE(fs::exists(file("a")));
}

TEST_F(RenderCommand, MissingFfmpegIsToldAtOnce) {
  expectOneLine(render("one_box --video --out " + file("a"), "PATH=/nowhere"), "ffmpeg");
  EXPECT_FALSE(fs::exists(file("a/one_box.mp4")));
}

TEST_F(RenderCommand, RefusesRunsWithoutEnd) {
  for (const char* endless : {"--at 0,1e12", "--at 1e30", "--video --at 1e9"}) {
    expectOneLine(render(std::string("one_box --out ") + file("a") + " " + endless, "timeout 20"),
                  "a billion steps");
    EXPECT_FALSE(fs::exists(file("a"))) << endless;
  }
}

// Before anything is simulated, since that would take minutes.
TEST_F(RenderCommand, TellsAtOnceWhichSizesCannotBe) {
  const std::string slow = "stack_40 --at 300 --out " + file("a");
  for (const char* small :
       {" --size 64x64", " --size 40x40 --plain --solver si:1,si:2,si:3,si:4,si:5,si:6",
        " --size 640x90 --at 1,2 --solver delassus,si:10"}) {
    const Outcome outcome = render(slow + small, "timeout 20");
    EXPECT_EQ(outcome.status, 2) << small;
    EXPECT_EQ(lines(outcome.err), 1) << outcome.err;
    EXPECT_NE(outcome.err.find("take a larger --size"), std::string::npos) << outcome.err;
  }
  expectOneLine(render(slow + " --size 8192x8192", "timeout 20"), "take a smaller --size");
  EXPECT_FALSE(fs::exists(file("a")));
}

TEST_F(RenderCommand, VideoIsWholeAndAlone) {
  if (std::system("command -v ffmpeg >/dev/null 2>&1") != 0) GTEST_SKIP() << "no ffmpeg here";
  const Outcome outcome = render("one_box --video --at 0.2 --size 160x90 --out " + file("a"));
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  const std::string video = read(file("a/one_box.mp4"));
  ASSERT_GT(video.size(), 500u);
  EXPECT_EQ(video.substr(4, 4), "ftyp");
  EXPECT_EQ(std::distance(fs::directory_iterator(file("a")), {}), 1) << "a part was left behind";
}

TEST_F(RenderCommand, BadNumbersAreBadUsage) {
  EXPECT_EQ(render("one_box --size 12").status, 2);
  EXPECT_EQ(render("one_box --size 0x5").status, 2);
  EXPECT_EQ(render("one_box --camera 1,2").status, 2);
  for (const char* number : {"nan", "inf", "1e999", "x"})
    for (const char* flag : {"--camera", "--look-at"})
      EXPECT_EQ(render(std::string("one_box ") + flag + " 1,2," + number).status, 2) << number;
  EXPECT_EQ(render("one_box --camera 1,2,3 --look-at 1,2,3").status, 2);
  EXPECT_EQ(render("one_box --at -1").status, 2);
}

}  // namespace
