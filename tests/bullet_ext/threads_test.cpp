/// Islands are solved side by side: the bits, the report and the events are the same for any number
/// of threads.

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <cstring>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "bullet_ext/workshop.h"
#include "tests/support/bullet_world.h"

namespace delassus::test {
namespace {

/// All that a user sees of a number of steps.
struct History {
  std::vector<btScalar> numbers;
  std::vector<std::string> messages;
  int walks = 0, pushIslands = 0, mostIslands = 0, mostContacts = 0;

  void add(const btCollisionObject& object) {
    const btTransform& pose = object.getWorldTransform();
    for (int i = 0; i < 3; ++i) {
      numbers.push_back(pose.getOrigin()[i]);
      for (int j = 0; j < 3; ++j) numbers.push_back(pose.getBasis()[i][j]);
    }
  }
  void add(const StepReport& report) {
    for (const int count :
         {report.islands, report.contacts, report.open, report.stick, report.modeChanges,
          report.keptIslands, report.walks, report.matrices, report.regions, report.factorisations,
          report.sweeps, report.solved, report.outOfBudget, report.pushIslands})
      numbers.push_back(btScalar(count));
    numbers.push_back(btScalar(report.residualMax));
    numbers.push_back(btScalar(report.residualRms));
    messages.insert(messages.end(), report.messages.begin(), report.messages.end());
    walks += report.walks;
    pushIslands += report.pushIslands;
    mostIslands = std::max(mostIslands, report.islands);
    mostContacts = std::max(mostContacts, report.contacts);
  }
  void add(const ContactEvent& event) {
    for (const int number : {event.point, int(event.from), int(event.to), int(event.trouble)})
      numbers.push_back(btScalar(number));
  }
};

void expectSame(const History& a, const History& b) {
  ASSERT_EQ(a.numbers.size(), b.numbers.size());
  EXPECT_EQ(std::memcmp(a.numbers.data(), b.numbers.data(), a.numbers.size() * sizeof(btScalar)),
            0);
  EXPECT_EQ(a.messages, b.messages);
}

using Build = std::function<void(BulletWorld&)>;
/// The number of threads in each step.
using Threads = std::function<int(int step)>;

Threads always(int threads) {
  return [threads](int) { return threads; };
}

History run(const Build& build, int steps, const Threads& threads, const Options& options = {}) {
  BulletWorld world(std::make_unique<btDelassusConstraintSolver>(options));
  build(world);
  History history;
  const auto listen = [&](const ContactEvent& event) { history.add(event); };
  world.delassus().setContactListener(listen);
  world.delassus().setTroubleListener(listen);
  int now = 1;
  for (int step = 0; step < steps; ++step) {
    if (threads(step) != now) world.delassus().setThreads(now = threads(step));
    world.advance();
    history.add(world.report());
    for (int i = 0; i < world->getNumCollisionObjects(); ++i)
      history.add(*world->getCollisionObjectArray()[i]);
  }
  return history;
}

/// Stacks of one to three boxes that are dropped, pushed and turned, each in another way.
void buildStacks(BulletWorld& world) {
  world.addGround();
  for (int stack = 0; stack < 25; ++stack)
    for (int i = 0; i <= stack % 3; ++i) {
      btRigidBody& box =
          world.addCube({btScalar(4 * (stack % 5)), btScalar(0.6) + btScalar(1.02) * i,
                         btScalar(4 * (stack / 5))},
                        btScalar(1 + stack % 4));
      box.setLinearVelocity({btScalar(0.1) * (stack % 7), -1, btScalar(0.2) * i});
      box.setAngularVelocity({0, btScalar(0.3) * (stack % 5), btScalar(0.1) * i});
    }
}

/// Dolls of a trunk and four limbs on hinges and cone-twists, let fall.
void buildDolls(BulletWorld& world) {
  world.addGround();
  for (int doll = 0; doll < 8; ++doll) {
    const btVector3 at(btScalar(3 * (doll % 4)), btScalar(0.8) + btScalar(0.1) * doll,
                       btScalar(3 * (doll / 4)));
    btRigidBody& trunk = world.addBox({btScalar(0.2), btScalar(0.4), btScalar(0.1)}, at, 10);
    for (int limb = 0; limb < 4; ++limb) {
      const btScalar side = limb % 2 ? btScalar(0.3) : btScalar(-0.3);
      const btScalar up = limb < 2 ? btScalar(0.3) : btScalar(-0.3);
      btRigidBody& arm = world.addBox({btScalar(0.06), btScalar(0.25), btScalar(0.06)},
                                      at + btVector3(side, up, 0), 2);
      arm.setLinearVelocity({side, 0, btScalar(0.1) * doll});
      const btVector3 onTrunk(side, up + btScalar(0.2), 0), onArm(0, btScalar(0.2), 0);
      if (limb < 2)
        world.addJoint<btHingeConstraint>(trunk, arm, onTrunk, onArm, btVector3(0, 0, 1),
                                          btVector3(0, 0, 1));
      else
        world.addJoint<btConeTwistConstraint>(trunk, arm, BulletWorld::at(onTrunk),
                                              BulletWorld::at(onArm));
    }
  }
}

/// Spheres of several sizes that rain on each other: islands merge and part.
void buildRain(BulletWorld& world) {
  world.addGround();
  for (int i = 0; i < 90; ++i)
    world
        .addSphere(btScalar(0.2) + btScalar(0.05) * (i % 4),
                   {btScalar(0.55) * (i % 6) + btScalar(0.02) * (i % 5),
                    btScalar(0.3) + btScalar(0.5) * (i / 18),
                    btScalar(0.6) * (i / 6 % 3) + btScalar(0.03) * (i % 3)})
        .setLinearVelocity({0, btScalar(-1) - btScalar(0.1) * (i % 9), 0});
}

/// Boxes that are put into the ground, out of which split impulse moves them.
void buildSunk(BulletWorld& world) {
  world.addGround();
  for (int i = 0; i < 20; ++i)
    world.addCube(
        {btScalar(3 * (i % 5)), btScalar(0.3) + btScalar(0.01) * i, btScalar(3 * (i / 5))});
}

/// So many boxes at rest that even their check alone is shared.
void buildField(BulletWorld& world) {
  world.addGround();
  for (int i = 0; i < 625; ++i)
    world.addCube({btScalar(2 * (i % 25)), btScalar(0.5), btScalar(2 * (i / 25))});
}

/// A block of touching spheres, shaken, beside single ones: one island of more than a thousand
/// contacts, on which all hands work.
void buildBlock(BulletWorld& world) {
  world.addGround();
  for (int i = 0; i < 486; ++i)
    world
        .addSphere(btScalar(0.25),
                   {btScalar(0.499) * (i % 9), btScalar(0.249) + btScalar(0.499) * (i / 81),
                    btScalar(0.499) * (i / 9 % 9)})
        .setLinearVelocity({btScalar(0.1) * (i % 5), btScalar(-0.1) * (i % 7), 0});
  for (int i = 0; i < 8; ++i) world.addCube({btScalar(3 * i), btScalar(0.5), -5});
}

TEST(Threads, TheMotionTheReportAndTheEventsAreTheSame) {
  const std::pair<Build, int> worlds[] = {
      {buildStacks, 60}, {buildDolls, 60}, {buildRain, 60}, {buildSunk, 10}, {buildField, 8}};
  for (const auto& [build, steps] : worlds) {
    const History serial = run(build, steps, always(1));
    EXPECT_GT(serial.mostIslands, 4);
    EXPECT_GT(serial.walks, 0);
    for (int threads : {2, 3, 4}) expectSame(run(build, steps, always(threads)), serial);
  }
  EXPECT_GT(run(buildSunk, 2, always(1)).pushIslands, 10);
  EXPECT_GT(run(buildField, 2, always(1)).mostContacts, 2000);
}

// With sweeps alone, and with some regions, whose factors they share.
TEST(Threads, AllOfThemWorkOnALargeIslandWithTheSameMotion) {
  for (const int regions : {0, 10}) {
    Options options;
    options.newtonBudget = regions;
    options.sweepBudget = 100;
    const History serial = run(buildBlock, 4, always(1), options);
    EXPECT_GT(serial.mostContacts, 1000);
    EXPECT_GT(serial.walks, 0);
    for (int threads : {2, 3}) expectSame(run(buildBlock, 4, always(threads), options), serial);
  }
}

// An island that weighs more than three times all others comes first, on the caller's bench; then
// the others come, each once.
TEST(Threads, APredominantIslandComesFirst) {
  constexpr int islands = 20, heavy = 7;
  bullet::Workshop workshop{Options()};
  for (int threads : {1, 3}) {
    workshop.setThreads(threads);
    for (int weightOfHeavy : {1, 40 * islands}) {
      std::atomic<int> turn{0};
      std::vector<int> turnOf(islands, -1);
      const auto weight = [&](int i) { return i == heavy ? weightOfHeavy : 10; };
      workshop.shareSolving(islands, weight, [&](bullet::Bench&, int i) {
        EXPECT_EQ(turnOf[i], -1) << i;
        turnOf[i] = turn++;
      });
      EXPECT_EQ(turn, islands);
      if (threads > 1 && weightOfHeavy > 1) {
        EXPECT_EQ(turnOf[heavy], 0);
      }
    }
  }
}

TEST(Threads, MessagesComeInTheOrderOfTheIslands) {
  Options options;
  options.newtonBudget = options.sweepBudget = 1;
  const History serial = run(buildStacks, 20, always(1), options);
  EXPECT_GT(serial.messages.size(), 20u);
  for (int threads : {2, 4}) expectSame(run(buildStacks, 20, always(threads), options), serial);
}

TEST(Threads, TheirNumberMayChangeBetweenSteps) {
  const History serial = run(buildStacks, 40, always(1));
  expectSame(run(buildStacks, 40, [](int step) { return 1 + step / 3 % 4; }), serial);
  expectSame(run(buildStacks, 40, [](int step) { return 4 - step % 4; }), serial);
  // Fewer than one thread counts as one.
  expectSame(run(buildStacks, 40, [](int step) { return step % 2 ? -1 : 0; }), serial);
}

TEST(Threads, ResetKeepsThemAndForgetsTheRest) {
  btDelassusConstraintSolver solver;
  solver.setThreads(3);
  solver.reset();
  EXPECT_EQ(solver.report().islands, 0);
  const auto withReset = [](int threads) {
    BulletWorld world(std::make_unique<btDelassusConstraintSolver>());
    buildStacks(world);
    world.delassus().setThreads(threads);
    History history;
    for (int step = 0; step < 20; ++step) {
      if (step % 5 == 4) world.delassus().reset();
      world.advance();
      history.add(world.report());
    }
    return history;
  };
  expectSame(withReset(3), withReset(1));
}

TEST(Threads, FourSolversInFourThreadsWithTheirOwn) {
  const History serial = run(buildStacks, 40, always(1));
  std::vector<History> together(4);
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i)
    threads.emplace_back([i, &together] { together[i] = run(buildStacks, 40, always(1 + i)); });
  for (std::thread& thread : threads) thread.join();
  for (const History& history : together) expectSame(history, serial);
}

// Worlds of several threads share the body that Bullet gives to joints with the world.
TEST(Threads, NothingIsWrittenToTheBodyThatWorldsShare) {
  DelassusWorld world;
  btRigidBody& hanging = world.addCube({0, 0, 0});
  world.addJoint<btPoint2PointConstraint>(hanging, btVector3(0, 0.5, 0));
  world.advance();
  // Bullet sets its mass and inertia anew whenever it is asked for it.
  btRigidBody& shared = btTypedConstraint::getFixedBody();
  shared.setInvInertiaDiagLocal({1, 1, 1});
  world.advance();
  EXPECT_EQ(shared.getInvInertiaDiagLocal().x(), 1);
  btTypedConstraint::getFixedBody();
  EXPECT_EQ(shared.getInvInertiaDiagLocal().x(), 0);
}

}  // namespace
}  // namespace delassus::test
