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
  islands = unsolved = regions = factorisations = sweeps = 0;
}

std::size_t Pushes::bytes() const {
  return bodies.capacity() * sizeof(Body) + contacts.capacity() * sizeof(Contact);
}

void solvePushes(const Group& group, bool all, Solver& solver, Pushes& pushes) {
  pushes.clear();
  const std::vector<Contact>& contacts = pushes.contacts;
  findContacts(group, all, pushes.contacts);
  pushes.bodies = group.bodies;
  for (Body& body : pushes.bodies) body.velocity.setZero();

  const std::vector<Row> noRows;
  const VectorXd fromRest;
  Solution& solution = pushes.solution;
  pushes.assembler.split(pushes.bodies, contacts, noRows);
  for (int i = 0; i < pushes.assembler.islands(); ++i) {
    const Island& island = pushes.assembler.island(i);
    solver.solve(pushes.assembler.assemble(pushes.bodies, contacts, noRows, island), fromRest,
                 solution);
    ++pushes.islands;
    if (solution.status != Status::Solved) ++pushes.unsolved;
    pushes.regions += solution.regions;
    pushes.factorisations += solution.factorisations;
    pushes.sweeps += solution.sweeps;
    if (solution.r.allFinite()) applyReaction(pushes.bodies, contacts, noRows, island, solution.r);
  }
}

}  // namespace delassus::bullet
