/// Random worlds, stepped: the laws hold in every step, the status is honest, the same input gives the same bits, and
/// numbers that are none stay where they are.

#include <gtest/gtest.h>

#include <cstdio>
#include <cstring>
#include <map>

#include "tests/fuzz/watching_solver.h"

namespace delassus::testing {
namespace {

struct Run {
  std::vector<btScalar> motion;
  std::set<std::string> faults;
  long solved = 0, outOfBudget = 0, incompatible = 0, leftOut = 0, contacts = 0;
};

Run run(int round, bool breaking) {
  Random random = fuzzRandom(round);
  RandomWorld made(random);
  BulletWorld& world = made.world();
  WatchingSolver watching(world.delassus(), made.traits());
  world->setConstraintSolver(&watching);
  Run out;
  const int steps = pick(random, 2, 8), breakAt = pick(random, 0, steps - 1);
  for (int step = 0; step < steps; ++step) {
    if (breaking && step == breakAt) made.breakSomething();
    world->stepSimulation(made.timeStep(), 0);
    const StepReport& report = world.report();
    out.solved += report.solved;
    out.outOfBudget += report.outOfBudget;
    out.incompatible += report.incompatible;
    out.leftOut += report.leftOut;
    out.contacts += report.contacts;
    const int unsolved = report.outOfBudget + report.incompatible;
    if ((unsolved + report.leftOut > 0) != !report.messages.empty())
      out.faults.insert("messages do not go with the counts");
    if (report.solved + unsolved + report.nonFinite != report.islands)
      out.faults.insert("an island has no status");
  }
  world->setConstraintSolver(&world.delassus());
  for (int i = 0; i < world->getNumCollisionObjects(); ++i) {
    const btRigidBody& body = *btRigidBody::upcast(world->getCollisionObjectArray()[i]);
    for (const btVector3& v : {body.getWorldTransform().getOrigin(), body.getLinearVelocity(),
                               body.getAngularVelocity()})
      out.motion.insert(out.motion.end(), {v.x(), v.y(), v.z()});
  }
  out.faults.insert(watching.faults().begin(), watching.faults().end());
  return out;
}

void fuzz(const char* name, bool breaking, int usualRounds) {
  std::map<std::string, long> shares;
  const int rounds = fuzzRounds(usualRounds);
  for (int round = 0; round < rounds; ++round) {
    Run first = run(round, breaking);
    const Run again = run(round, breaking);
    if (first.motion.size() != again.motion.size() ||
        std::memcmp(first.motion.data(), again.motion.data(),
                    first.motion.size() * sizeof(btScalar)) != 0)
      first.faults.insert("another run gives other bits");
    for (const std::string& fault : first.faults) {
      ADD_FAILURE() << name << " round " << round << ": " << fault;
      ++shares[fault];
    }
    shares["islands solved"] += first.solved;
    shares["islands out of budget"] += first.outOfBudget;
    shares["islands incompatible"] += first.incompatible;
    shares["parts left out"] += first.leftOut;
    shares["contacts"] += first.contacts;
  }
  EXPECT_GT(shares["contacts"], 10 * rounds) << "the worlds are not empty";
  if (!isLongFuzz()) return;
  for (const auto& [what, count] : shares) std::printf("%s: %s %ld\n", name, what.c_str(), count);
}

TEST(WorldFuzz, LawsHoldInEveryStep) { fuzz("worlds", false, 60); }
TEST(WorldFuzz, BrokenNumbersStayWhereTheyAre) { fuzz("broken", true, 60); }

}  // namespace
}  // namespace delassus::testing
