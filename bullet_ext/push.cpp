#include "bullet_ext/push.h"

#include <algorithm>

#include "bullet_ext/group.h"
#include "bullet_ext/thrown_bodies.h"
#include "delassus/bytes.h"
#include "delassus/contact_motion.h"

namespace delassus::bullet {
namespace {

/// How fast two bodies slip past each other, m/s.
double slipOf(const std::vector<Body>& bodies, const Contact& c) {
  const Vec3 v = slip(bodies, c), n = c.frame.col(0);
  return (v - n.dot(v) * n).norm();
}

void findContacts(const Group& group, std::vector<Contact>& found) {
  const auto asksForPush = [](double push) { return push > 0; };
  const bool all = std::none_of(group.pushes.begin(), group.pushes.end(), asksForPush);
  for (std::size_t i = 0; i < group.contacts.size(); ++i) {
    if (!all && !asksForPush(group.pushes[i])) continue;
    Contact& contact = found.emplace_back(group.contacts[i]);
    contact.friction = 0;
    contact.target = {group.pushes[i], 0, 0};
  }
}

/// Whether bodies of the island slip past each other faster than pushes may move them.
bool throwsOne(const Pushes& pushes, const Island& island) {
  double largest = 0, fastest = 0;
  for (const int k : island.frictionless) {
    largest = std::max(largest, pushes.contacts[k].target[0]);
    fastest = std::max(fastest, slipOf(pushes.bodies, pushes.contacts[k]));
  }
  return fastest > reach * largest;
}

void pushIsland(const Island& island, Bench& bench, Pushes& pushes) {
  const std::vector<Row> noRows;
  const VectorXd fromRest;
  const Problem& problem = bench.assembler.assemble(pushes.bodies, pushes.contacts, noRows, island);
  bench.solver.solve(problem, fromRest, bench.solution);
  bench.counts.add(bench.solution);
  const VectorXd& r = bench.solution.r;
  if (r.allFinite()) applyReaction(pushes.bodies, pushes.contacts, noRows, island, r);
}

}  // namespace

void Pushes::clear() {
  contacts.clear();
  bodies.clear();
  islands = softened = 0;
  counts = {};
}

std::size_t Pushes::bytes() const {
  return bytesOf(bodies, contacts, isSoftened) + assembler.bytes();
}

void solvePushes(const Group& group, Workshop& workshop, Pushes& pushes) {
  pushes.clear();
  findContacts(group, pushes.contacts);
  pushes.bodies = group.bodies;
  for (Body& body : pushes.bodies) body.velocity.setZero();

  pushes.assembler.split(pushes.bodies, pushes.contacts, {});
  pushes.islands = pushes.assembler.islands();
  pushes.isSoftened.assign(pushes.islands, 0);
  workshop.shareSolving(
      pushes.islands, [&](int i) { return pushes.assembler.island(i).unknowns(); },
      [&](Bench& bench, int i) {
        const Island& island = pushes.assembler.island(i);
        pushIsland(island, bench, pushes);
        if (!throwsOne(pushes, island)) return;
        pushes.isSoftened[i] = 1;
        for (const int k : island.frictionless) soften(pushes.bodies, pushes.contacts[k]);
        for (const int body : island.bodies) pushes.bodies[body].velocity.setZero();
        pushIsland(island, bench, pushes);
      });
  pushes.softened =
      static_cast<int>(std::count(pushes.isSoftened.begin(), pushes.isSoftened.end(), 1));
  pushes.counts = workshop.takeCounts();
}

}  // namespace delassus::bullet
