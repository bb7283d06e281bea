// Every scene as the camera sees it: something is there, and each body is where Bullet's own rays
// meet it.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <set>

#include "tests/render/shot.h"

namespace demos::render {
namespace {

constexpr Size small{240, 135};

btVector3 toBullet(const Eigen::Vector3d& v) { return vec3(v.x(), v.y(), v.z()); }

/// Bullet's ray, which passes through planes: from behind they are glass.
struct RayThroughPlanes : btCollisionWorld::ClosestRayResultCallback {
  using ClosestRayResultCallback::ClosestRayResultCallback;
  bool needsCollision(btBroadphaseProxy* proxy) const override {
    const auto* object = static_cast<const btCollisionObject*>(proxy->m_clientObject);
    return object->getCollisionShape()->getShapeType() != STATIC_PLANE_PROXYTYPE;
  }
};

/// The number that Bullet's ray through the pixel expects there (at the sample that gives the
/// number). 0: the ray meets nothing.
std::uint32_t numberByRay(const Shot& shot, int x, int y) {
  const Size size = shot.drawing.image.size;
  const Eigen::Matrix4d fromClip =
      (shot.view.projection(double(size.width) / size.height) * shot.view.toEye()).inverse();
  const Eigen::Vector4d clip(2 * (x + 0.25) / size.width - 1, 1 - 2 * (y + 0.75) / size.height, 1,
                             1);
  const Eigen::Vector3d end = (fromClip * clip).hnormalized();
  RayThroughPlanes ray(toBullet(shot.view.eye), toBullet(end));
  shot.world->dynamics().rayTest(ray.m_rayFromWorld, ray.m_rayToWorld, ray);
  if (!ray.hasHit()) return 0;
  return std::uint32_t(ray.m_collisionObject->getWorldArrayIndex()) + 1;
}

bool moves(const Shot& shot, std::uint32_t number) {
  return number > 0 && shot.film.things[number - 1].mass > 0;
}

/// True if `number` is drawn in the pixel or beside it: outlines run between pixels, and polygons
/// stand for round things.
bool isDrawnAt(const Shot& shot, int x, int y, std::uint32_t number) {
  for (int j = -1; j <= 1; ++j)
    for (int i = -1; i <= 1; ++i)
      if (shot.drawing.number(x + i, y + j) == number) return true;
  return false;
}

/// The share of the pixels that show the moving thing which Bullet's ray finds there.
double agreement(const Shot& shot) {
  shot.world->dynamics().updateAabbs();
  int agreed = 0, seen = 0;
  for (int y = 1; y < small.height - 1; y += 2)
    for (int x = 1; x < small.width - 1; x += 2) {
      const std::uint32_t met = numberByRay(shot, x, y);
      if (!moves(shot, met)) continue;
      ++seen;
      agreed += isDrawnAt(shot, x, y, met) ? 1 : 0;
    }
  return seen > 0 ? double(agreed) / seen : 0;
}

class EveryScene : public testing::TestWithParam<std::string> {};

TEST_P(EveryScene, IsSeenWhereTheWorldHasIt) {
  const Shot shot(GetParam(), 0, small);
  std::set<std::uint32_t> numbers;
  std::set<int> brightness;
  for (int y = 0; y < small.height; ++y)
    for (int x = 0; x < small.width; ++x) {
      if (moves(shot, shot.drawing.number(x, y))) numbers.insert(shot.drawing.number(x, y));
      brightness.insert(shot.drawing.image.pixel(x, y)[1]);
    }
  EXPECT_GE(numbers.size(), 1u);
  EXPECT_GT(brightness.size(), 20u) << "the picture is nearly of one tone";
  // Less than one, because of things only a pixel wide: the limbs of benchmark_ragdolls.
  EXPECT_GT(agreement(shot), 0.97);
}

std::vector<std::string> sceneNames() {
  std::vector<std::string> names;
  for (const SceneDescription& scene : catalogue()) names.push_back(scene.name);
  return names;
}
INSTANTIATE_TEST_SUITE_P(Scenes, EveryScene, testing::ValuesIn(sceneNames()),
                         [](const auto& info) { return info.param; });

TEST(MovedScene, IsSeenWhereTheWorldHasIt) {
  for (const char* scene : {"gripper", "newton_cradle", "box_headings"})
    EXPECT_GT(agreement(Shot(scene, 0.5, small)), 0.98) << scene;
}

TEST(Painter, DrawsTheSameBytesAgain) {
  const Shot first("stack_10", 0.1, small), second("stack_10", 0.1, small);
  EXPECT_EQ(first.drawing.image.rgb, second.drawing.image.rgb);
  EXPECT_EQ(first.drawing.numbers, second.drawing.numbers);
}

TEST(Painter, DepthIsThatOfTheProjectedPoint) {
  // The nearest point of a ball is on the line from its centre to the camera.
  auto world = std::make_unique<World>();
  world->add(1, world->sphere(1), at(0, 0, 0), {});
  const Shot shot(std::move(world), 0, small);
  const Eigen::Vector3d nearest = shot.view.eye.normalized();
  const auto seen = shot.view.project(nearest, small);
  ASSERT_TRUE(seen.has_value());
  EXPECT_EQ(shot.drawing.number(int(seen->x()), int(seen->y())), 1u);
  EXPECT_NEAR(double(shot.drawing.depth(int(seen->x()), int(seen->y()))), seen->z(), 1e-3);
}

TEST(Painter, ShadowFallsAwayFromTheSun) {
  // The ground beside a box is darker than it is without the box.
  const auto build = [](bool box) {
    auto world = std::make_unique<World>();
    world->add(0, world->box(vec3(50, 1, 50)), at(0, -1, 0), {});
    world->add(1, world->box(vec3(0.5, 2, 0.5)), at(box ? 0 : 2.5, 2, 0), {});
    return world;
  };
  Wish wish;
  wish.eye = Eigen::Vector3d(0, 6, 12);
  wish.lookAt = Eigen::Vector3d(0, 1, 0);
  const Shot with(build(true), 0, small, wish), without(build(false), 0, small, wish);
  int darker = 0;
  for (int y = 0; y < small.height; ++y)
    for (int x = 0; x < small.width; ++x) {
      const bool ground = with.drawing.number(x, y) == 1 && without.drawing.number(x, y) == 1;
      if (ground && with.drawing.image.pixel(x, y)[1] + 30 < without.drawing.image.pixel(x, y)[1])
        ++darker;
    }
  EXPECT_GT(darker, 100);
}

}  // namespace
}  // namespace demos::render
