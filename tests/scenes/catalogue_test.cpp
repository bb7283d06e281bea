#include "demos/scenes/catalogue.h"

#include <gtest/gtest.h>

#include <set>

namespace demos {
namespace {

TEST(Catalogue, DescribesEveryScene) {
  std::set<std::string> names;
  for (const SceneDescription& scene : catalogue()) {
    EXPECT_TRUE(names.insert(scene.name).second) << scene.name << " is there twice";
    EXPECT_FALSE(scene.summary.empty()) << scene.name;
    EXPECT_FALSE(scene.expectation.empty()) << scene.name;
    EXPECT_GT(scene.seconds, 0) << scene.name;
    EXPECT_GT((scene.camera.eye - scene.camera.target).length(), 0) << scene.name;
    const auto world = scene.build();
    EXPECT_FALSE(world->movableBodies().empty()) << scene.name;
    EXPECT_EQ(world->time(), 0) << scene.name;
  }
}

TEST(Catalogue, FindsByName) {
  for (const SceneDescription& scene : catalogue()) EXPECT_EQ(&findScene(scene.name), &scene);
}

TEST(Catalogue, NamesTheNearestOfAnUnknownScene) {
  const auto messageFor = [](const std::string& name) -> std::string {
    try {
      findScene(name);
    } catch (const UnknownScene& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(messageFor("one_bx").find("'one_box'"), std::string::npos);
  EXPECT_NE(messageFor("pyramid_51").find("'pyramid_50'"), std::string::npos);
  EXPECT_NE(messageFor("").find("there is no scene ''"), std::string::npos);
}

TEST(EditDistance, CountsLetters) {
  EXPECT_EQ(editDistance("", ""), 0);
  EXPECT_EQ(editDistance("", "arch"), 4);
  EXPECT_EQ(editDistance("arch", "arch"), 0);
  EXPECT_EQ(editDistance("kitten", "sitting"), 3);
  EXPECT_EQ(editDistance("sitting", "kitten"), 3);
}

}  // namespace
}  // namespace demos
