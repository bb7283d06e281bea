// Articulated bodies: each link is drawn at the place that its joints give it.
#include <BulletDynamics/Featherstone/btMultiBody.h>
#include <BulletDynamics/Featherstone/btMultiBodyConstraintSolver.h>
#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>
#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>
#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "tests/render/shot.h"

namespace demos::render {
namespace {

/// Bars of 1 kg on hinges along e_z, hung from a fixed block, in a world of Bullet's own
/// articulated bodies.
class Pendulum {
 public:
  static constexpr int links = 4;

  Pendulum()
      : world_(&dispatcher_, &broadphase_, &solver_, &configuration_),
        body_(links, 0, btVector3(0, 0, 0), true, false) {
    world_.setGravity(vec3(0, -9.81, 0));
    btVector3 inertia;
    bar_.calculateLocalInertia(1, inertia);
    const btVector3 half = vec3(halfLength, 0, 0);
    for (int link = 0; link < links; ++link)
      body_.setupRevolute(link, 1, inertia, link - 1, btQuaternion::getIdentity(),
                          btVector3(0, 0, 1), link == 0 ? vec3(halfBlock, 0, 0) : half, half, true);
    body_.finalizeMultiDof();
    world_.addMultiBody(&body_);
    for (int link = -1; link < links; ++link) {
      auto collider = std::make_unique<btMultiBodyLinkCollider>(&body_, link);
      collider->setCollisionShape(link < 0 ? &block_ : &bar_);
      if (link < 0)
        body_.setBaseCollider(collider.get());
      else
        body_.getLink(link).m_collider = collider.get();
      world_.addCollisionObject(collider.get());
      colliders_.push_back(std::move(collider));
    }
  }
  ~Pendulum() {
    for (const auto& collider : colliders_) shownIn_->removeCollisionObject(collider.get());
    world_.removeMultiBody(&body_);
  }
  Pendulum(const Pendulum&) = delete;
  Pendulum& operator=(const Pendulum&) = delete;

  void swing(double seconds) {
    for (int i = 0; i < int(seconds * 240); ++i) world_.stepSimulation(btScalar(1.0 / 240), 0);
  }
  /// Takes the links' collision objects out of the world that moved them, and puts them into the
  /// one that is drawn.
  void showIn(btCollisionWorld& world) {
    for (const auto& collider : colliders_) {
      shownIn_->removeCollisionObject(collider.get());
      world.addCollisionObject(collider.get());
    }
    shownIn_ = &world;
  }
  /// The link's centre of mass by the angles of the joints; that of the base for -1.
  Eigen::Vector3d centre(int link) {
    const btVector3 place =
        link < 0 ? body_.getBasePos() : body_.localPosToWorld(link, btVector3(0, 0, 0));
    return toFloat(place).cast<double>();
  }

 private:
  static constexpr double halfLength = 0.5, halfWidth = 0.12, halfBlock = 0.2;

  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase broadphase_;
  btMultiBodyConstraintSolver solver_;
  btMultiBodyDynamicsWorld world_;
  btMultiBody body_;
  btBoxShape bar_{vec3(halfLength, halfWidth, halfWidth)};
  btBoxShape block_{vec3(halfBlock, halfBlock, halfBlock)};
  std::vector<std::unique_ptr<btMultiBodyLinkCollider>> colliders_;  // of the base, then of links
  btCollisionWorld* shownIn_ = &world_;
};

TEST(ArticulatedBody, LinksAreSeenWhereItsJointsPutThem) {
  constexpr Size size{240, 135};
  auto held = std::make_shared<Pendulum>();
  Pendulum& pendulum = *held;
  pendulum.swing(0.5);
  ASSERT_LT(pendulum.centre(Pendulum::links - 1).y(), -0.5) << "it swings";

  auto world = std::make_unique<World>();
  pendulum.showIn(world->dynamics());
  world->keep(std::move(held));  // goes before the world in which it is shown
  Wish wish;
  wish.direction = Eigen::Vector3d::UnitZ();
  const Shot shot(std::move(world), 0, size, wish);
  ASSERT_EQ(shot.film.things.size(), 1u + Pendulum::links);
  for (int link = -1; link < Pendulum::links; ++link) {
    const auto seen = shot.view.project(pendulum.centre(link), size);
    ASSERT_TRUE(seen.has_value());
    EXPECT_EQ(shot.drawing.number(int(seen->x()), int(seen->y())), std::uint32_t(link + 2));
    EXPECT_EQ(shot.film.things[std::size_t(link + 1)].mass, link < 0 ? 0 : 1);
  }
}

}  // namespace
}  // namespace demos::render
