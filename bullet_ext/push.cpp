#include "bullet_ext/push.h"

#include "delassus/island.h"

namespace delassus::bullet {
namespace {

void findDeepContacts(const Group& group, std::vector<Contact>& deep) {
  deep.clear();
  for (std::size_t i = 0; i < group.contacts.size(); ++i) {
    if (!(group.pushes[i] > 0)) continue;
    Contact contact = group.contacts[i];
    contact.friction = 0;
    contact.target = {group.pushes[i], 0, 0};
    deep.push_back(contact);
  }
}

}  // namespace

std::size_t Pushes::bytes() const {
  return bodies.capacity() * sizeof(Body) + deep.capacity() * sizeof(Contact);
}

void solvePushes(const Group& group, Solver& solver, Pushes& pushes) {
  pushes.bodies.clear();
  pushes.islands = pushes.unsolved = pushes.regions = pushes.factorisations = 0;
  std::vector<Contact>& deep = pushes.deep;
  findDeepContacts(group, deep);
  if (deep.empty()) return;

  pushes.bodies = group.bodies;
  for (Body& body : pushes.bodies) body.velocity.setZero();
  for (const Island& island : splitIslands(pushes.bodies, deep, {})) {
    const Solution solution = solver.solve(assemble(pushes.bodies, deep, {}, island));
    ++pushes.islands;
    if (solution.status != Status::Solved) ++pushes.unsolved;
    pushes.regions += solution.regions;
    pushes.factorisations += solution.factorisations;
    if (solution.r.allFinite()) applyReaction(pushes.bodies, deep, {}, island, solution.r);
  }
}

}  // namespace delassus::bullet
