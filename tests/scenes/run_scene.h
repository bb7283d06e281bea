#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "bullet_ext/btDelassusConstraintSolver.h"
#include "demos/scenes/catalogue.h"
#include "demos/scenes/measures.h"
#include "demos/scenes/simulate.h"

namespace demos {

constexpr bool doublePrecision = sizeof(btScalar) == sizeof(double);
constexpr double hz = 60, h = 1 / hz;

/// `inDouble` or `inFloat`, by the build of Bullet.
inline double byPrecision(double inDouble, double inFloat) {
  return doublePrecision ? inDouble : inFloat;
}

/// A world on our solver.
struct OnRegions {
  btDelassusConstraintSolver solver;  // outlives the world
  std::unique_ptr<World> world;

  explicit OnRegions(std::unique_ptr<World> built) : world(std::move(built)) {
    world->setSolver(solver);
  }
  explicit OnRegions(const std::string& scene) : OnRegions(findScene(scene).build()) {}

  btRigidBody& body(int i = 0) const { return *world->movableBodies()[std::size_t(i)]; }
};

/// What `delassus run` would report of a world on the solver of this name at 60 steps a second.
inline RunSummary runFor(World& world, const std::string& solver, double seconds) {
  NamedSolver named(solver);
  return simulate(world, named, {seconds, 60}, [](double) {});
}
inline RunSummary runFor(const std::unique_ptr<World>& world, const std::string& solver,
                         double seconds) {
  return runFor(*world, solver, seconds);
}

/// All numbers that say where the bodies are and how they move.
inline std::vector<btScalar> stateOf(const World& world) {
  std::vector<btScalar> state;
  for (const btRigidBody* body : world.movableBodies()) {
    const btTransform& pose = body->getWorldTransform();
    for (int i = 0; i < 3; ++i) {
      state.push_back(pose.getOrigin()[i]);
      state.push_back(body->getLinearVelocity()[i]);
      state.push_back(body->getAngularVelocity()[i]);
      for (int j = 0; j < 3; ++j) state.push_back(pose.getBasis()[i][j]);
    }
  }
  return state;
}

inline bool allFinite(const std::vector<btScalar>& state) {
  for (const btScalar number : state)
    if (!std::isfinite(number)) return false;
  return true;
}

}  // namespace demos
