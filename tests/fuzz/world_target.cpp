/// Random worlds, stepped: the laws hold in every step, the status is honest, the same input gives
/// the same bits, and NaN stays where it is.

#include <cstring>

#include "tests/fuzz/target.h"
#include "tests/fuzz/watching_solver.h"

namespace delassus::test {
namespace {

struct Run {
  std::vector<btScalar> motion;
  Outcome outcome;
};

Run run(const std::string& bytes) {
  ByteDraws draws(bytes);
  const bool breaking = chance(draws, 0.5);
  RandomWorld made(draws);
  BulletWorld& world = made.world();
  WatchingSolver watching(world.delassus(), made.traits());
  world->setConstraintSolver(&watching);
  Run out;
  auto& [faults, counts] = out.outcome;
  const int steps = pick(draws, 2, 8), breakAt = pick(draws, 0, steps - 1);
  for (int step = 0; step < steps; ++step) {
    if (breaking && step == breakAt) made.breakSomething();
    world->stepSimulation(made.timeStep(), 0);
    const StepReport& report = world.report();
    counts["islands solved"] += report.solved;
    counts["islands out of budget"] += report.outOfBudget;
    counts["islands incompatible"] += report.incompatible;
    counts["parts left out"] += report.leftOut;
    counts["contacts"] += report.contacts;
    const int unsolved = report.outOfBudget + report.incompatible;
    if ((unsolved + report.leftOut > 0) != !report.messages.empty())
      faults.insert("messages do not go with the counts");
    if (report.solved + unsolved + report.nonFinite != report.islands)
      faults.insert("an island has no status");
  }
  world->setConstraintSolver(&world.delassus());
  for (int i = 0; i < world->getNumCollisionObjects(); ++i) {
    const btRigidBody& body = *btRigidBody::upcast(world->getCollisionObjectArray()[i]);
    for (const btVector3& v : {body.getWorldTransform().getOrigin(), body.getLinearVelocity(),
                               body.getAngularVelocity()})
      out.motion.insert(out.motion.end(), {v.x(), v.y(), v.z()});
  }
  faults.insert(watching.faults().begin(), watching.faults().end());
  return out;
}

Outcome ask(const std::string& bytes) {
  Run first = run(bytes);
  const Run again = run(bytes);
  if (first.motion.size() != again.motion.size() ||
      std::memcmp(first.motion.data(), again.motion.data(),
                  first.motion.size() * sizeof(btScalar)) != 0)
    first.outcome.faults.insert("another run gives other bits");
  return first.outcome;
}

std::string randomBytes(Random& random, int count) {
  std::string bytes;
  for (int i = 0; i < count; ++i) bytes += char(pick(random, 0, 255));
  return bytes;
}

std::string seed(Random& random) { return randomBytes(random, 1500); }

/// Draws anew everything that is chosen after some point.
std::string mutated(std::string bytes, Random& random) {
  if (bytes.empty()) return seed(random);
  const int kept = pick(random, 0, int(bytes.size()) - 1);
  return bytes.substr(0, std::size_t(kept)) + randomBytes(random, int(bytes.size()) - kept);
}

}  // namespace

const Target target{"world", ask, seed, mutated, 120, {{"contacts", 10}, {"parts left out", 0.2}}};

}  // namespace delassus::test
