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

void findContacts(const Group& group, bool all, std::vector<Contact>& found) {
  for (std::size_t i = 0; i < group.contacts.size(); ++i) {
    if (!(group.pushes[i] > 0) && !all) continue;
    Contact& contact = found.emplace_back(group.contacts[i]);
    contact.friction = 0;
    contact.target = {group.pushes[i], 0, 0};
  }
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

void solvePushes(const Group& group, bool all, Workshop& workshop, Pushes& pushes) {
  pushes.clear();
  std::vector<Contact>& contacts = pushes.contacts;
  findContacts(group, all, pushes.contacts);
  pushes.bodies = group.bodies;
  for (Body& body : pushes.bodies) body.velocity.setZero();

  const std::vector<Row> noRows;
  const VectorXd fromRest;
  pushes.assembler.split(pushes.bodies, contacts, noRows);
  pushes.islands = pushes.assembler.islands();
  workshop.clearCounts();
  const auto weight = [&](int i) { return pushes.assembler.island(i).unknowns(); };
  const auto push = [&](Bench& bench, const Island& island) {
    const Problem& problem = bench.assembler.assemble(pushes.bodies, contacts, noRows, island);
    bench.solver.solve(problem, fromRest, bench.solution);
    bench.counts.add(bench.solution);
    const VectorXd& r = bench.solution.r;
    if (r.allFinite()) applyReaction(pushes.bodies, contacts, noRows, island, r);
  };
  const auto throwsOne = [&](const Island& island) {
    double largest = 0, fastest = 0;
    for (const int k : island.frictionless) {
      largest = std::max(largest, contacts[k].target[0]);
      fastest = std::max(fastest, slipOf(pushes.bodies, contacts[k]));
    }
    return fastest > reach * largest;
  };
  pushes.isSoftened.assign(pushes.islands, 0);
  workshop.shareSolving(pushes.islands, weight, [&](Bench& bench, int i) {
    const Island& island = pushes.assembler.island(i);
    push(bench, island);
    if (!throwsOne(island)) return;
    pushes.isSoftened[i] = 1;
    for (const int k : island.frictionless) soften(pushes.bodies, contacts[k]);
    for (const int body : island.bodies) pushes.bodies[body].velocity.setZero();
    push(bench, island);
  });
  pushes.softened =
      static_cast<int>(std::count(pushes.isSoftened.begin(), pushes.isSoftened.end(), 1));
  pushes.counts = workshop.counts();
}

}  // namespace delassus::bullet
