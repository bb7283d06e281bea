#include "tests/support/random_piles.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

namespace delassus::test {

PileIsland::PileIsland(Pile p) : pile(std::move(p)) {
  island = splitIslands(pile.bodies, pile.contacts, pile.rows).at(0);
  problem = assemble(pile.bodies, pile.contacts, pile.rows, island);
  target.resize(problem.size());
  int at = 0;
  for (const int i : island.frictional) {
    target.segment<3>(at) = pile.contacts[i].target;
    at += 3;
  }
  for (const int i : island.frictionless) target[at++] = pile.contacts[i].target[0];
  for (const int i : island.rows) target[at++] = pile.rows[i].target;
}

std::vector<Body> PileIsland::after(const VectorXd& r) const {
  std::vector<Body> bodies = pile.bodies;
  applyReaction(bodies, pile.contacts, pile.rows, island, r);
  return bodies;
}

std::vector<double> randomMasses(int n, double ratio, Random& random) {
  std::vector<double> masses;
  for (int i = 0; i < n; ++i) masses.push_back(std::pow(ratio, uniform(random, 0, 1)));
  return masses;
}

void mixFriction(Pile& pile, double largest, Random& random) {
  for (Contact& c : pile.contacts)
    c.friction = uniform(random, 0, 1) < 0.1 ? 0 : uniform(random, 0, largest);
}

Pile withoutFriction(Pile pile) {
  for (Contact& c : pile.contacts) c.friction = 0;
  return pile;
}

Pile inOtherUnits(Pile pile, int lengths, int masses) {
  const double m = std::ldexp(1, lengths), perKg = std::ldexp(1, -masses);
  for (Body& body : pile.bodies) {
    body.inverseMass *= perKg;
    body.inverseInertia *= perKg / (m * m);
    body.velocity.head<3>() *= m;
  }
  for (Contact& contact : pile.contacts) {
    contact.armA *= m;
    contact.armB *= m;
    contact.target *= m;
    contact.compliance *= perKg;
    contact.slipCompliance *= perKg;
  }
  return pile;
}

Problem withEntries(const Problem& problem) {
  Problem copy = problem;
  copy.W = DelassusMatrix(DelassusMatrix::Sparse(problem.W.dense().sparseView()));
  return copy;
}

double kineticEnergy(const std::vector<Body>& bodies) {
  double energy = 0;
  for (const Body& body : bodies) {
    const Vec3 v = body.velocity.head<3>(), w = body.velocity.tail<3>();
    energy += 0.5 * v.dot(v.cwiseQuotient(body.inverseMass));
    energy += 0.5 * w.dot(body.inverseInertia.inverse() * w);
  }
  return energy;
}

double motionDistance(const PileIsland& pile, const VectorXd& r, const VectorXd& s) {
  std::vector<Body> difference = pile.after(r);
  const std::vector<Body> other = pile.after(s);
  for (std::size_t i = 0; i < other.size(); ++i) difference[i].velocity -= other[i].velocity;
  return std::sqrt(kineticEnergy(difference) / kineticEnergy(pile.pile.bodies));
}

Solution startFrom(const Problem& problem, const NaturalMap& map, const VectorXd& r) {
  Solution start;
  start.r = r;
  start.u = problem.W * r + problem.q;
  start.residual = map.residual(start.r, start.u).max;
  start.activeSet.contacts.resize(problem.contacts());
  start.activeSet.rows.resize(problem.rows());
  return start;
}

double infeasibility(const Problem& problem, const VectorXd& r) {
  double worst = 0;
  for (int i = 0; i < problem.contacts(); ++i) {
    const Vec3 ri = r.segment<3>(3 * i);
    worst = std::max({worst, -ri[0], std::hypot(ri[1], ri[2]) - problem.friction[i] * ri[0]});
  }
  for (int i = 0; i < problem.rows(); ++i) {
    const double ri = r[3 * problem.contacts() + i];
    worst = std::max({worst, problem.lower[i] - ri, ri - problem.upper[i]});
  }
  for (const Disk& disk : problem.disks)
    worst = std::max(worst, disk.of(r).norm() - disk.radiusAt(r));
  return worst;
}

VectorXd randomReactions(const Problem& problem, double scale, Random& random) {
  VectorXd r(problem.size());
  for (int i = 0; i < problem.contacts(); ++i) {
    const double normal = scale * uniform(random, 0, 1), angle = uniform(random, 0, 7);
    const double t = problem.friction[i] * normal * uniform(random, 0, 1);
    r.segment<3>(3 * i) << normal, t * std::cos(angle), t * std::sin(angle);
  }
  for (int i = 0; i < problem.rows(); ++i)
    r[3 * problem.contacts() + i] =
        std::clamp(scale * uniform(random, -1, 1), problem.lower[i], problem.upper[i]);
  return r;
}

}  // namespace delassus::test
