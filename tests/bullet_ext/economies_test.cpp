/// A step does no work that its scene does not need. The tests count the work, and compare the
/// motion with that of a step that does the work all the same.

#include <BulletDynamics/ConstraintSolver/btFixedConstraint.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "tests/support/bullet_world.h"

namespace delassus::test {
namespace {

using Build = std::function<void(BulletWorld&)>;
using Look = std::function<void(const StepReport& report)>;

std::unique_ptr<btDelassusConstraintSolver> solverWithout(bool Economies::*economy) {
  Options options = optionsOfPrecision();
  if (economy) options.economies.*economy = false;
  return std::make_unique<btDelassusConstraintSolver>(options);
}

double difference(BulletWorld& a, BulletWorld& b) {
  double largest = 0;
  for (int i = 0; i < a->getNumCollisionObjects(); ++i) {
    const btRigidBody &left = *btRigidBody::upcast(a->getCollisionObjectArray()[i]),
                      &right = *btRigidBody::upcast(b->getCollisionObjectArray()[i]);
    for (const btVector3& d :
         {btVector3(left.getLinearVelocity() - right.getLinearVelocity()),
          btVector3(left.getAngularVelocity() - right.getAngularVelocity()),
          btVector3(left.getWorldTransform().getOrigin() - right.getWorldTransform().getOrigin())})
      largest = std::max<double>(largest, d.length());
  }
  return largest;
}

/// Steps the scene with all economies, and without `economy`: the motion must be the same. Shows
/// the reports to `with` and `without` after each step.
void compare(bool Economies::*economy, int steps, const Build& build, const Look& with,
             const Look& without) {
  BulletWorld lean(solverWithout(nullptr)), lavish(solverWithout(economy));
  build(lean);
  build(lavish);
  for (int i = 0; i < steps; ++i) {
    SCOPED_TRACE("step " + std::to_string(i));
    lean.advance();
    lavish.advance();
    EXPECT_LE(lean.report().residualMax, tolerance(1e-8, 1e-5));
    EXPECT_LE(lavish.report().residualMax, tolerance(1e-8, 1e-5));
    EXPECT_LT(difference(lean, lavish), tolerance(1e-6, 1e-4));
    with(lean.report());
    without(lavish.report());
  }
}

void addTower(BulletWorld& world, int height = 3) {
  world.addGround();
  for (int i = 0; i < height; ++i) world.addCube({0, btScalar(0.5) + i, 0});
}

TEST(Economies, NoTangentsWithoutFriction) {
  const Build glide = [](BulletWorld& world) {
    world.addGround();
    btRigidBody& box = world.addCube({0, btScalar(0.5), 0});
    box.setFriction(0);
    box.setLinearVelocity({btScalar(0.01), 0, 0});
    world.addCube({5, btScalar(0.5), 0});
  };
  compare(
      &Economies::tangents, 30, glide,
      [](const StepReport& report) {
        EXPECT_EQ(report.plan.frictional, 4);
        EXPECT_GT(report.plan.frictionless, 0);
        EXPECT_EQ(report.plan.unknowns, 3 * 4 + report.plan.frictionless);
      },
      [](const StepReport& report) {
        EXPECT_EQ(report.plan.unknowns, 3 * (4 + report.plan.frictionless));
      });
}

TEST(Economies, NoPushProblemWithoutDeepPenetrations) {
  const auto atHeight = [](btScalar height) {
    return [height](BulletWorld& world) {
      world.addGround();
      world.addCube({0, height, 0});
    };
  };
  compare(
      &Economies::pushes, 10, atHeight(btScalar(0.5)),
      [](const StepReport& report) {
        EXPECT_EQ(report.plan.deep, 0);
        EXPECT_EQ(report.plan.pushContacts, 0);
        EXPECT_EQ(report.pushIslands, 0);
        EXPECT_EQ(report.secondsPush, 0);
      },
      [](const StepReport& report) {
        EXPECT_EQ(report.plan.pushContacts, 4);
        EXPECT_EQ(report.pushIslands, 1);
      });
  const Look pushed = [](const StepReport& report) {
    EXPECT_EQ(report.plan.deep, 4);
    EXPECT_EQ(report.plan.pushContacts, 4);
    EXPECT_EQ(report.pushIslands, 1);
  };
  const auto withOneOnIt = [](BulletWorld& world) {
    world.addGround();
    for (const double y : {0.4, 1.4}) world.addCube({0, btScalar(y), 0});
  };
  compare(&Economies::pushes, 1, atHeight(btScalar(0.4)), pushed, pushed);
  compare(&Economies::pushes, 1, withOneOnIt, pushed, pushed);
}

TEST(Economies, NoMatrixWithoutApproachingContacts) {
  const Build parting = [](BulletWorld& world) {
    addTower(world, 2);
    // All boxes leave the ground, and the upper box leaves the lower one.
    for (int i = 1; i <= 2; ++i)
      btRigidBody::upcast(world->getCollisionObjectArray()[i])
          ->setLinearVelocity({0, btScalar(0.5) * btScalar(i), btScalar(0.1)});
  };
  compare(
      &Economies::freeIslands, 1, parting,
      [](const StepReport& report) {
        EXPECT_EQ(report.contacts, 8);
        EXPECT_EQ(report.open, 8);
        EXPECT_EQ(report.freeIslands, report.islands);
        EXPECT_EQ(report.matrices, 0);
        EXPECT_EQ(report.residualMax, 0);
      },
      [](const StepReport& report) {
        EXPECT_EQ(report.open, 8);
        EXPECT_EQ(report.matrices, report.islands);
      });
}

TEST(Economies, WhatStandsIsOnlyChecked) {
  int step = 0;
  const auto settled = [&step] { return step > 5; };
  compare(
      &Economies::keptIslands, 40, [](BulletWorld& world) { addTower(world); },
      [&](const StepReport& report) {
        ++step;
        if (!settled()) return;
        EXPECT_EQ(report.islands, 1);
        EXPECT_EQ(report.keptIslands, 1);
        EXPECT_EQ(report.matrices + report.sweeps + report.regions + report.factorisations, 0);
        EXPECT_EQ(report.stick, 12);
        EXPECT_EQ(report.secondsSolve, 0);
      },
      [&](const StepReport& report) {
        if (!settled()) return;
        EXPECT_EQ(report.matrices, 1);
        EXPECT_EQ(report.walks, 1);
        EXPECT_GT(report.regions, 0);
      });
}

// Holds in both precisions, at the solver's own tolerance.
TEST(Economies, WhatStandsIsKeptToTheTolerance) {
  DelassusWorld world;
  addTower(world, 10);
  world.advance(10);
  int kept = 0;
  constexpr int steps = 60;
  for (int i = 0; i < steps; ++i) {
    world.advance();
    kept += world.report().keptIslands;
    EXPECT_LE(world.report().residualMax, 1e-8);
  }
  EXPECT_GE(kept, steps * 9 / 10);
}

// A disturbance of more than the tolerance makes an island be solved again; each by itself.
TEST(Economies, WhatIsDisturbedIsSolvedAgain) {
  BulletWorld world(solverWithout(nullptr));
  world.addGround();
  btRigidBody* boxes[3];
  for (int i = 0; i < 3; ++i) boxes[i] = &world.addCube({btScalar(3 * i), btScalar(0.5), 0});
  world.advance(10);
  for (const double force : {0.01, 1.0}) {
    boxes[1]->applyCentralForce({btScalar(force), 0, 0});
    world.advance();
    EXPECT_EQ(world.report().keptIslands, 2) << force;
    EXPECT_EQ(world.report().matrices, 1) << force;
    world.advance(5);
  }
}

// A step that is not to start from the last one has nothing to check. Bullet has two ways to say
// so, and both count.
TEST(Economies, NothingStandsWithoutWarmStarting) {
  for (const bool byFlag : {false, true}) {
    DelassusWorld world;
    addTower(world);
    btRigidBody& ball = world.addSphere(btScalar(0.2), {5, 4, 0});
    world.addJoint<btPoint2PointConstraint>(ball, btVector3(0, 1, 0));
    world.advance(60);
    EXPECT_GT(world.report().keptIslands, 1);
    if (byFlag)
      world.info().m_solverMode &= ~SOLVER_USE_WARMSTARTING;
    else
      world.info().m_warmstartingFactor = 0;
    world.advance();
    EXPECT_EQ(world.report().keptIslands, 0);
    EXPECT_EQ(world.report().solved, 2);
  }
}

TEST(Economies, ASingleContactTakesAFormula) {
  int formulas = 0, walks = 0;
  compare(
      &Economies::closedForms, 20,
      [](BulletWorld& world) {
        world.addGround();
        world.addSphere(btScalar(0.5), {0, btScalar(0.5), 0}).setLinearVelocity({2, 0, 0});
      },
      [&](const StepReport& report) {
        if (report.contacts > 1) return;  // Bullet keeps a point of the last step for a while
        formulas += report.closedForms;
        EXPECT_EQ(report.walks + report.factorisations, 0);
      },
      [&](const StepReport& report) {
        EXPECT_EQ(report.closedForms, 0);
        if (report.contacts > 1) return;
        walks += report.walks;
        EXPECT_EQ(report.walks, report.matrices);
      });
  EXPECT_GT(formulas, 0);
  EXPECT_EQ(walks, formulas);
}

// Bodies that fall together, and whose demands are as nothing beside what they gain by falling.
TEST(Economies, WhatFallsTogetherIsNotToldApart) {
  const double little = 1e-14 * BulletWorld::gravity;
  compare(
      nullptr, 5,
      [&](BulletWorld& world) {
        world.addCube({0, 0, 0});
        world.addCube({0, 1, 0}).setLinearVelocity({0, btScalar(-little), 0});
      },
      [](const StepReport& report) {
        EXPECT_EQ(report.regions, 0);
        EXPECT_EQ(report.solved, report.islands);
      },
      [](const StepReport&) {});
}

// A tower of welded bricks is one body: only the lowest touches anything else.
TEST(Economies, WeldedBricksHaveNoContactsBetweenThem) {
  constexpr int height = 4;
  compare(
      &Economies::weldedContacts, 10,
      [](BulletWorld& world) {
        world.addGround();
        btRigidBody* last = nullptr;
        for (int i = 0; i < height; ++i) {
          btRigidBody& brick = world.addCube({0, btScalar(0.5) + i, 0});
          if (last)
            world.addJoint<btFixedConstraint>(*last, brick, BulletWorld::at({0, 0.5, 0}),
                                              BulletWorld::at({0, -0.5, 0}));
          last = &brick;
        }
      },
      [](const StepReport& report) { EXPECT_EQ(report.contacts, 4); },
      [](const StepReport& report) { EXPECT_EQ(report.contacts, 4 * height); });
}

TEST(Economies, NoRowsWithoutRollingAndSpinningFriction) {
  for (const bool rolls : {false, true})
    for (const bool spins : {false, true}) {
      BulletWorld world(solverWithout(nullptr));
      world.addGround();
      btRigidBody& ball = world.addSphere(btScalar(0.5), {0, btScalar(0.5), 0});
      if (rolls) ball.setRollingFriction(btScalar(0.1));
      if (spins) ball.setSpinningFriction(btScalar(0.1));
      world.addCube({5, btScalar(0.5), 0});
      world.advance();
      const Plan& plan = world.report().plan;
      EXPECT_EQ(plan.rolling, int(rolls));
      EXPECT_EQ(plan.spinning, int(spins));
      EXPECT_EQ(plan.rows + world.report().rows, 0);
      EXPECT_EQ(plan.unknowns, 3 * 5 + 2 * rolls + spins);
      EXPECT_EQ(world.report().closedForms, rolls || spins ? 0 : 1)
          << "no formula for a contact that resists turning";
    }
}

// A ball that spins down has the same reactions in each step: the memory knows them.
TEST(Economies, WhatSpinsDownIsOnlyChecked) {
  BulletWorld world(solverWithout(nullptr));
  world.addGround();
  btRigidBody& ball = world.addSphere(btScalar(0.5), {0, btScalar(0.5), 0});
  ball.setRollingFriction(btScalar(0.01));
  ball.setSpinningFriction(btScalar(0.01));
  ball.setAngularVelocity({0, 2, 0});
  int kept = 0;
  for (int i = 0; i < 40; ++i) {
    world.advance();
    kept += world.report().keptIslands;
  }
  EXPECT_GE(kept, 30);
  EXPECT_GT(ball.getAngularVelocity().y(), 1);
}

TEST(Economies, NoEventsUnheard) {
  int changes = 0;
  const Build drop = [](BulletWorld& world) {
    world.addGround();
    world.addCube({0, btScalar(0.6), 0});
  };
  compare(
      &Economies::events, 20, drop,
      [&](const StepReport& report) {
        changes += report.modeChanges;
        EXPECT_FALSE(report.plan.heard);
        EXPECT_EQ(report.events, 0);
      },
      [](const StepReport& report) { EXPECT_EQ(report.events, report.modeChanges); });
  EXPECT_GT(changes, 0);

  BulletWorld world(solverWithout(nullptr));
  drop(world);
  int told = 0;
  world.delassus().setContactListener([&](const ContactEvent&) { ++told; });
  int made = 0;
  for (int i = 0; i < 20; ++i) {
    world.advance();
    EXPECT_TRUE(world.report().plan.heard);
    made += world.report().events;
  }
  EXPECT_EQ(told, changes);
  EXPECT_EQ(made, changes);
}

TEST(Economies, AListenerMayEndItself) {
  BulletWorld world(solverWithout(nullptr));
  world.addGround();
  for (int i = 0; i < 3; ++i) world.addCube({btScalar(2 * i), btScalar(0.5), 0});
  int told = 0;
  std::vector<int> heap(100, 1);  // so that the function has storage of its own
  world.delassus().setContactListener([&world, &told, heap](const ContactEvent&) {
    world.delassus().setContactListener({});
    told += heap.at(50);
  });
  world.advance(5);
  EXPECT_EQ(told, 12) << "those of one step, to the last";
}

TEST(Economies, KeptStorageDoesNotShow) {
  const Look nothing = [](const StepReport&) {};
  compare(
      &Economies::storage, 30,
      [](BulletWorld& world) {
        addTower(world);
        btRigidBody& ball = world.addSphere(btScalar(0.2), {btScalar(0.4), 4, 0});
        world.addJoint<btPoint2PointConstraint>(ball, btVector3(0, 1, 0));
      },
      nothing, nothing);
}

TEST(Plan, CountsWhatTheSceneAsksFor) {
  DelassusWorld world;
  world.addGround();
  btRigidBody& soft = world.addCube({0, btScalar(0.5), 0});
  soft.setContactStiffnessAndDamping(1000, 10);
  btRigidBody& bouncing = world.addCube({5, btScalar(0.5), 0});
  bouncing.setRestitution(btScalar(0.5));
  btRigidBody* ground = btRigidBody::upcast(world->getCollisionObjectArray()[0]);
  ground->setRestitution(1);
  btRigidBody& door = world.addSphere(btScalar(0.2), {0, 5, 5});
  auto& hinge = world.addJoint<btHingeConstraint>(door, btVector3(1, 0, 0), btVector3(0, 0, 1));
  hinge.enableAngularMotor(true, 1, 1);
  world.advance();

  const Plan& plan = world.report().plan;
  EXPECT_EQ(plan.frictional, 8);
  EXPECT_EQ(plan.frictionless, 0);
  EXPECT_EQ(plan.bouncing, 4);
  EXPECT_EQ(plan.soft, 4);
  EXPECT_EQ(plan.joints, 1);
  EXPECT_EQ(plan.rows, 6);
  EXPECT_EQ(plan.boundedRows, 1);  // the motor
  EXPECT_EQ(plan.obsolete, 0);
  EXPECT_EQ(plan.islands, 3);
  EXPECT_EQ(plan.largestIsland, 12);
  EXPECT_EQ(plan.unknowns, 3 * 8 + 6);
  EXPECT_EQ(plan.contacts(), world.report().contacts);
  EXPECT_EQ(plan.rows, world.report().rows);
}

}  // namespace
}  // namespace delassus::test
