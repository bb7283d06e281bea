#include "bullet_ext/push.h"

#include <algorithm>

#include "BulletCollision/NarrowPhaseCollision/btPersistentManifold.h"
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

/// Lets a contact of the group take part. `target`: its least normal velocity, m/s.
void add(const Group& group, std::size_t i, double target, Pushes& pushes) {
  Contact& contact = pushes.contacts.emplace_back(group.contacts[i]);
  contact.friction = 0;
  contact.target = {target, 0, 0};
  pushes.takesPart[i] = 1;
}

void findContacts(const Group& group, Pushes& pushes) {
  const auto asksForPush = [](double push) { return push > 0; };
  const bool all = std::none_of(group.pushes.begin(), group.pushes.end(), asksForPush);
  pushes.takesPart.assign(group.contacts.size(), 0);
  for (std::size_t i = 0; i < group.contacts.size(); ++i)
    if (all || asksForPush(group.pushes[i])) add(group, i, group.pushes[i], pushes);
}

/// How far the bodies of a contact are apart, m; 0 if they overlap.
double gapOf(const PointSource& source) {
  return std::max<double>(source.manifold->getContactPoint(source.point).getDistance(), 0);
}

/// Lets those contacts take part that pushes would close faster than any contact beside them is to
/// open: pushes add up along a column, and would drive its foot through the floor. False if there
/// are none. With `all`, lets all others take part if there are any.
bool addClosed(const Group& group, double h, bool all, Pushes& pushes) {
  pushes.largest.assign(group.bodies.size(), 0);
  for (int i = 0; i < pushes.islands; ++i) {
    const Island& island = pushes.assembler.island(i);
    double largest = 0;
    for (const int k : island.frictionless)
      largest = std::max(largest, pushes.contacts[k].target[0]);
    for (const int body : island.bodies) pushes.largest[body] = largest;
  }
  const auto largestOf = [&](int body) { return body >= 0 ? pushes.largest[body] : 0; };
  const auto allowed = [&](std::size_t i) { return gapOf(group.contactSources[i]) / h; };
  const std::size_t before = pushes.contacts.size();
  for (std::size_t i = 0; i < group.contacts.size(); ++i) {
    const Contact& c = group.contacts[i];
    const double most = std::max(largestOf(c.a), largestOf(c.b));
    if (most == 0 || pushes.takesPart[i]) continue;
    const double closes = -c.frame.col(0).dot(slip(pushes.bodies, c));
    if (closes > most && closes > allowed(i) + most) add(group, i, -allowed(i), pushes);
  }
  const bool found = pushes.contacts.size() > before;
  for (std::size_t i = 0; all && found && i < group.contacts.size(); ++i)
    if (!pushes.takesPart[i]) add(group, i, -allowed(i), pushes);
  return found;
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

void pushIsland(const Island& island, const std::vector<Contact>& contacts, Bench& bench,
                Pushes& pushes) {
  const std::vector<Row> noRows;
  const VectorXd fromRest;
  const Problem& problem = bench.assembler.assemble(pushes.bodies, contacts, noRows, island);
  bench.solver.solve(problem, fromRest, bench.solution);
  bench.counts.add(bench.solution);
  const VectorXd& r = bench.solution.r;
  if (r.allFinite()) applyReaction(pushes.bodies, contacts, noRows, island, r);
}

/// Solves the push problem of the contacts that take part.
void solve(const Group& group, Workshop& workshop, Pushes& pushes) {
  pushes.bodies = group.bodies;
  for (std::size_t i = 0; i < pushes.bodies.size(); ++i) {
    Body& body = pushes.bodies[i];
    body.velocity.setZero();
    if (!group.isLimb(static_cast<int>(i))) continue;
    body.inverseMass.setZero();
    body.inverseInertia.setZero();
  }
  pushes.assembler.split(pushes.bodies, pushes.contacts, {});
  pushes.islands = pushes.assembler.islands();
  pushes.isSoftened.assign(pushes.islands, 0);
  workshop.shareSolving(
      pushes.islands, [&](int i) { return pushes.assembler.island(i).unknowns(); },
      [&](Bench& bench, int i) {
        const Island& island = pushes.assembler.island(i);
        pushIsland(island, pushes.contacts, bench, pushes);
        if (!throwsOne(pushes, island)) return;
        pushes.isSoftened[i] = 1;
        bench.changeContacts(pushes.contacts, island,
                             [&](Contact& contact) { soften(pushes.bodies, contact); });
        for (const int body : island.bodies) pushes.bodies[body].velocity.setZero();
        pushIsland(island, bench.softContacts, bench, pushes);
      });
  pushes.softened =
      static_cast<int>(std::count(pushes.isSoftened.begin(), pushes.isSoftened.end(), 1));
  const Bench::Counts counts = workshop.takeCounts();
  pushes.counts.add(counts);
  pushes.counts.unsolved = counts.unsolved;
}

}  // namespace

void Pushes::clear() {
  contacts.clear();
  bodies.clear();
  islands = softened = 0;
  counts = {};
}

std::size_t Pushes::bytes() const {
  return bytesOf(bodies, contacts, isSoftened, takesPart, largest) + assembler.bytes();
}

void solvePushes(const Group& group, double h, Workshop& workshop, Pushes& pushes) {
  // Each time, bodies that lie on what moves may begin to move, too. After a few times all do.
  constexpr int few = 5;
  pushes.clear();
  findContacts(group, pushes);
  solve(group, workshop, pushes);
  for (int times = 1; addClosed(group, h, times >= few, pushes); ++times)
    solve(group, workshop, pushes);
}

}  // namespace delassus::bullet
