// Files, framing, words, and the pictures that somebody has looked at.
#include "demos/render/picture.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <Eigen/Dense>
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <limits>
#include <tuple>

#include "demos/render/palette.h"
#include "tests/render/image_file.h"
#include "tests/render/shot.h"

namespace demos::render {
namespace {

namespace fs = std::filesystem;

class PngFile : public testing::Test {
 protected:
  fs::path folder_ = fs::temp_directory_path() / ("delassus_png_" + std::to_string(getpid()));
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }
};

Image stripes() {
  Image image({37, 19});
  for (int y = 0; y < 19; ++y)
    for (int x = 0; x < 37; ++x) *image.pixel(x, y) = std::uint8_t(7 * x + 3 * y);
  return image;
}

TEST_F(PngFile, ReadsBackWhatWasWritten) {
  const std::string file = (folder_ / "a.png").string();
  savePng(file, stripes());
  const Image back = loadPng(file);
  EXPECT_EQ(back.size.width, 37);
  EXPECT_EQ(back.rgb, stripes().rgb);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 1) << "a part was left behind";
}

TEST_F(PngFile, SaysWhichFolderCannotBeWritten) {
  std::ofstream(folder_ / "file") << "x";
  const std::string inFile = (folder_ / "file" / "deeper").string();
  try {
    prepareFolder(inFile);
    FAIL();
  } catch (const OutputError& error) {
    EXPECT_NE(std::string(error.what()).find(inFile), std::string::npos);
  }
  EXPECT_THROW(savePng(inFile + "/a.png", stripes()), OutputError);
}

TEST(Similarity, IsOneForEqualAndLessForShifted) {
  EXPECT_DOUBLE_EQ(structuralSimilarity(stripes(), stripes()), 1);
  Image shifted({37, 19});
  shifted.paste(stripes(), 3, 0);
  EXPECT_LT(structuralSimilarity(stripes(), shifted), 0.9);
}

TEST(Readable, WritesNumbersAsPeopleDo) {
  EXPECT_EQ(readable(0), "0");
  EXPECT_EQ(readable(2e-13), "2·10⁻¹³");
  EXPECT_EQ(readable(0.0441), "0.044");
  EXPECT_EQ(readable(12), "12");
  EXPECT_EQ(readable(2452.5), "2452");
  EXPECT_EQ(readable(3.04e7), "3·10⁷");
  EXPECT_EQ(readable(INFINITY), "∞");
  EXPECT_EQ(readable(std::nan("")), "not a number");
}

TEST(View, ShowsAllCornersOfTheStage) {
  for (const char* scene : {"stack_40", "box_headings", "wall_20x10"}) {
    const Film film = [&] {
      const auto world = findScene(scene).build();
      NamedSolver solver("si:10");
      return record(*world, solver, 60, {0}, [](double) {});
    }();
    for (const Size size : {Size{640, 360}, Size{200, 600}}) {
      const View view = frameView({film}, stage({film}), Shot::wishOf(scene), size);
      for (const Frame::Pose& pose : film.frames[0].poses) {
        if (film.things[std::size_t(pose.thing)].mass == 0) continue;
        for (const Eigen::Vector3d& corner : {pose.low, pose.high}) {
          const auto seen = view.project(corner, size);
          ASSERT_TRUE(seen.has_value());
          EXPECT_TRUE(seen->x() > 0 && seen->x() < size.width) << scene;
          EXPECT_TRUE(seen->y() > 0 && seen->y() < size.height) << scene;
        }
      }
    }
  }
}

Film filmOf(const std::string& scene, const std::string& name, double time) {
  const auto world = findScene(scene).build();
  NamedSolver solver(name);
  return record(*world, solver, findScene(scene).hz, {time}, [](double) {});
}

/// Boxes of a metre in a row, `apart` from one to the next.
Film fourBoxes(double apart) {
  Film film;
  film.up = Eigen::Vector3d::UnitY();
  Frame& frame = film.frames.emplace_back();
  for (int i = 0; i < 4; ++i) {
    film.things.emplace_back().mass = 1;
    const Eigen::Vector3d low(i * apart, 0, 0);
    frame.poses.push_back({i, Eigen::Matrix4f::Identity(), low, low + Eigen::Vector3d::Ones()});
  }
  return film;
}

// Where the bodies of one solver have flown apart, those of the others stay in sight.
TEST(View, IsThatOfBodiesThatKeepTogether) {
  const auto widthOf = [](const std::vector<Film>& films) {
    const Box box = stage(films);
    return box.high.x() - box.low.x();
  };
  const Film together = fourBoxes(2), wider = fourBoxes(3), flown = fourBoxes(1000);
  const double alone = widthOf({together});
  EXPECT_NEAR(widthOf({together, flown}), alone, alone);
  EXPECT_EQ(widthOf({flown, together}), widthOf({together, flown}));
  // Those of the first solver are the scene otherwise.
  EXPECT_EQ(widthOf({wider, together}), widthOf({wider}));
}

TEST(Film, MarksCarryTheWeight) {
  const Film film = filmOf("stack_10_heavy_top", "delassus", 0.2);
  ASSERT_EQ(film.frames.size(), 1u);
  Eigen::Vector3d onGround = Eigen::Vector3d::Zero();
  for (const ContactMark& mark : film.frames[0].contacts) {
    EXPECT_EQ(mark.mode, delassus::Mode::Stick);
    if (mark.place.y() < 0.1) onGround += mark.force;
  }
  EXPECT_NEAR(onGround.y(), 1009 * 9.81, 1);
}

TEST(Film, TellsReleasedContactsInTheirStep) {
  // A bead below a plane leaves the plane in the first step (paper, 6).
  const Film film = filmOf("bead_under_plane", "delassus", 1.0 / 60);
  ASSERT_EQ(film.frames[0].contacts.size(), 1u);
  EXPECT_EQ(film.frames[0].contacts[0].mode, delassus::Mode::Open);
  EXPECT_EQ(film.frames[0].contacts[0].force.norm(), 0);
}

TEST(Film, JointsShowWhatHangsOnThem) {
  const Film film = filmOf("heavy_ball_chain", "delassus", 0.1);
  ASSERT_EQ(film.frames[0].joints.size(), 21u);
  // The ball swings: its joint bears most of the weight along the chain.
  EXPECT_GT(film.frames[0].joints[0].force.norm(), 500);
  EXPECT_GT(film.frames[0].joints[0].force.y(), 0);
}

// A stock solver can throw bodies out of the numbers. They are not drawn; the caption says so.
TEST(Film, SaysThatAWorldIsLost) {
  const auto world = findScene("stack_10").build();
  const btScalar lost = std::numeric_limits<btScalar>::quiet_NaN();
  world->movableBodies()[9]->setLinearVelocity(btVector3(lost, 0, 0));
  NamedSolver solver("si:10");
  const Film film = record(*world, solver, 60, {0.1}, [](double) {});
  const Frame& frame = film.frames[0];
  EXPECT_TRUE(frame.lost);
  for (const Frame::Pose& pose : frame.poses) EXPECT_TRUE(pose.matrix.allFinite());
  EXPECT_NE(factsInWords(frame, false).find("LOST"), std::string::npos);
  EXPECT_EQ(factsInWords(frame, false).find("residual"), std::string::npos);
  Look look;
  look.size = {320, 180};
  Studio({film}, Shot::wishOf("stack_10"), look, 1).picture({0});

  const Film sound = filmOf("stack_10", "si:10", 0.1);
  EXPECT_FALSE(sound.frames[0].lost);
  EXPECT_EQ(factsInWords(sound.frames[0], false).find("LOST"), std::string::npos);
}

// Two films stand side by side, six in two rows of three: a row of six would leave slits.
TEST(Picture, HasAPanelForEachFilm) {
  const Film film = filmOf("stack_10", "si:10", 0);
  Look look;
  look.plain = true;
  for (const auto& [films, columns, rows] : {std::tuple(1, 1, 1), {2, 2, 1}, {6, 3, 2}}) {
    const Size panel{200, 190};
    const int gap = 1;
    look.size = {columns * (panel.width + gap) - gap, rows * (panel.height + gap) - gap};
    Studio studio(std::vector<Film>(films, film), Shot::wishOf("stack_10"), look, 1);
    const Image picture = studio.picture({0});
    int others = 0;
    for (int y = 0; y < panel.height; ++y)
      for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column)
          others += !std::equal(
              picture.pixel(0, y), picture.pixel(panel.width, y),
              picture.pixel(column * (panel.width + gap), row * (panel.height + gap) + y));
    EXPECT_EQ(others, 0) << films;
    const Image empty(look.size, palette::paper);
    EXPECT_NE(picture.rgb, empty.rgb);
  }
}

/// Pictures at time 0 depend on no solver. Across machines fonts and rasterisers differ a little.
constexpr double sameToTheEye = 0.97;

class Golden : public testing::TestWithParam<const char*> {};

TEST_P(Golden, LooksAsItDidWhenItWasLookedAt) {
  const std::string scene = GetParam();
  Look look;
  look.size = {480, 270};
  look.title = scene;
  look.summary = findScene(scene).summary;
  look.expected = findScene(scene).expectation;
  Studio studio({filmOf(scene, "si:10", 0)}, Shot::wishOf(scene), look, 1);
  const Image picture = studio.picture({0});
  const std::string file = std::string(DELASSUS_GOLDEN_DIR) + "/" + scene + ".png";
  if (std::getenv("DELASSUS_NEW_GOLDEN") != nullptr) savePng(file, picture);
  EXPECT_GT(structuralSimilarity(loadPng(file), picture), sameToTheEye);
}
INSTANTIATE_TEST_SUITE_P(Scenes, Golden,
                         testing::Values("stack_10_heavy_top", "arch", "newton_cradle",
                                         "spheres_bin", "ragdolls"),
                         [](const auto& info) { return std::string(info.param); });

}  // namespace
}  // namespace demos::render
