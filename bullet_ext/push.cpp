#include "bullet_ext/push.h"

namespace delassus::bullet {
namespace {

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
  islands = 0;
  counts = {};
}

std::size_t Pushes::bytes() const { return bytesOf(bodies, contacts) + assembler.bytes(); }

void solvePushes(const Group& group, bool all, Workshop& workshop, Pushes& pushes) {
  pushes.clear();
  const std::vector<Contact>& contacts = pushes.contacts;
  findContacts(group, all, pushes.contacts);
  pushes.bodies = group.bodies;
  for (Body& body : pushes.bodies) body.velocity.setZero();

  const std::vector<Row> noRows;
  const VectorXd fromRest;
  pushes.assembler.split(pushes.bodies, contacts, noRows);
  pushes.islands = pushes.assembler.islands();
  workshop.clearCounts();
  const auto weight = [&](int i) { return pushes.assembler.island(i).unknowns(); };
  workshop.shareSolving(pushes.islands, weight, [&](Bench& bench, int i) {
    const Island& island = pushes.assembler.island(i);
    const Problem& problem = bench.assembler.assemble(pushes.bodies, contacts, noRows, island);
    bench.solver.solve(problem, fromRest, bench.solution);
    bench.counts.add(bench.solution);
    const VectorXd& r = bench.solution.r;
    if (r.allFinite()) applyReaction(pushes.bodies, contacts, noRows, island, r);
  });
  pushes.counts = workshop.counts();
}

}  // namespace delassus::bullet
