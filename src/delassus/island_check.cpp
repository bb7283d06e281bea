#include "delassus/island_check.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "delassus/cone.h"
#include "delassus/contact_motion.h"
#include "delassus/disk.h"
#include "delassus/kept_law.h"

namespace delassus {
namespace {

/// The difference that rounding can leave where two velocities cancel.
double roundOff(double a, double b) {
  return 4 * std::numeric_limits<double>::epsilon() * std::max(std::abs(a), std::abs(b));
}

void moveIntoDisk(const Disk& disk, VectorXd& r) {
  disk.put(projectOnDisk(disk.of(r), disk.radiusAt(r)), r);
}

/// The square of, roughly, the largest radius of gyration; 0 if the body cannot turn.
double squaredReachOf(const Body& body) {
  double least = infinity;
  for (int i = 0; i < 3; ++i)
    if (body.inverseInertia(i, i) > 0) least = std::min(least, body.inverseInertia(i, i));
  return least < infinity ? body.inverseMass.maxCoeff() / least : 0;
}

/// Whether no body moves faster than `speed`, nor turns so fast that the island's longest arm, of a
/// contact or a row, would. The arm of a row about an axis is that of its arc.
bool isSlower(const std::vector<Body>& bodies, const std::vector<Contact>& contacts,
              const std::vector<Row>& rows, const Island& island, double speed) {
  const double square = speed * speed;
  double squaredTurn = 0, squaredReach = 0;
  for (int i : island.bodies) {
    const Vec6& v = bodies[i].velocity;
    if (!(v.head<3>().squaredNorm() <= square)) return false;
    squaredTurn = std::max(squaredTurn, v.tail<3>().squaredNorm());
    squaredReach = std::max(squaredReach, squaredReachOf(bodies[i]));
  }
  const auto reachTo = [&](int body, double squaredArm) {
    if (body >= 0 && bodies[body].movable()) squaredReach = std::max(squaredReach, squaredArm);
  };
  island.eachContact([&](int i) {
    reachTo(contacts[i].a, contacts[i].armA.squaredNorm());
    reachTo(contacts[i].b, contacts[i].armB.squaredNorm());
  });
  const auto squaredArm = [](const Row6& J) {
    const double along = J.head<3>().squaredNorm();
    return J.tail<3>().squaredNorm() / (along > 0 ? along : 1);
  };
  for (int i : island.rows) {
    reachTo(rows[i].a, squaredArm(rows[i].jacobianA));
    reachTo(rows[i].b, squaredArm(rows[i].jacobianB));
  }
  return squaredTurn * squaredReach <= square;
}

void makeReady(const Island& island, Tier tier, Solution& solution) {
  const auto scalars = island.frictionless.size() + island.rows.size();
  solution.u.resize(static_cast<int>(3 * island.frictional.size() + scalars));
  solution.activeSet.contacts.resize(island.frictional.size());
  solution.activeSet.rows.resize(scalars);
  solution.activeSet.disks.clear();
  solution.status = Status::Solved;
  solution.tier = tier;
  solution.startResidual = infinity;  // never needed for kept reactions
  solution.takeWork({});
  solution.blamed.clear();
}

}  // namespace

bool IslandCheck::isFree(const std::vector<Body>& bodies, const std::vector<Contact>& contacts,
                         const std::vector<Row>& rows, const Island& island,
                         Solution& solution) const {
  Residuals residuals(infinity);
  const auto leaves = [&](int i) {
    const Contact& c = contacts[i];
    const double q = normalVelocity(bodies, c);
    // The solver names what is no number.
    if (!std::isfinite(q + c.compliance + c.slipCompliance) || !(c.friction >= 0)) return false;
    if (q >= 0) return residuals.add(0);
    const auto normal = [&](int body, const Vec3& arm) {
      return c.frame.col(0).dot(velocityAt(bodies, body, arm));
    };
    return -q <= roundOff(normal(c.a, c.armA), normal(c.b, c.armB)) && residuals.add(-q);
  };
  const auto rests = [&](int i) {
    const Row& c = rows[i];
    if (c.governor >= 0) return residuals.add(0);  // its disk is a point
    if (!(c.lower <= 0 && c.upper >= 0)) return false;
    const double q = relativeVelocity(bodies, c);
    if (!std::isfinite(q + c.compliance)) return false;
    const double missed = std::max(c.lower < 0 ? q : 0, c.upper > 0 ? -q : 0);
    return missed <= roundOff(along(bodies, c.a, c.jacobianA), along(bodies, c.b, c.jacobianB)) &&
           residuals.add(std::max(missed, 0.0));
  };
  if (!std::all_of(island.frictional.begin(), island.frictional.end(), leaves) ||
      !std::all_of(island.frictionless.begin(), island.frictionless.end(), leaves) ||
      !std::all_of(island.rows.begin(), island.rows.end(), rests))
    return false;

  makeReady(island, Tier::Free, solution);
  solution.r.setZero(solution.u.size());
  residuals.write(solution);
  std::fill(solution.activeSet.contacts.begin(), solution.activeSet.contacts.end(), Mode::Open);
  int at = 0, state = 0;
  for (int i : island.frictional) {
    solution.u.segment<3>(at) = relativeVelocity(bodies, contacts[i]);
    at += 3;
  }
  for (int i : island.frictionless) {
    solution.u[at++] = normalVelocity(bodies, contacts[i]);
    solution.activeSet.rows[state++] = RowState::AtLower;
  }
  for (int i : island.rows) {
    solution.u[at++] = relativeVelocity(bodies, rows[i]);
    if (rows[i].governor >= 0) {
      solution.activeSet.rows[state++] = RowState::Free;
      if (!rows[i].paired) solution.activeSet.disks.push_back(Mode::Open);
      continue;
    }
    solution.activeSet.rows[state++] = rows[i].lower == 0   ? RowState::AtLower
                                       : rows[i].upper == 0 ? RowState::AtUpper
                                                            : RowState::Free;
  }
  return true;
}

/// Projects r, gives the bodies their velocities after r, and returns the largest demand.
double IslandCheck::move(const std::vector<Body>& bodies, const std::vector<Contact>& contacts,
                         const std::vector<Row>& rows, const Island& island,
                         std::vector<Body>& moved, VectorXd& r) {
  impulses_.resize(bodies.size(), Vec6::Zero());
  for (int body : island.bodies) impulses_[body].setZero();
  double demand = leastDemandOf(bodies, contacts, rows, island);
  const auto moves = [&](int body) { return body >= 0 && bodies[body].movable(); };
  const auto push = [&](const Contact& c, const Vec3& impulse) {
    if (moves(c.a)) {
      impulses_[c.a].head<3>() += impulse;
      impulses_[c.a].tail<3>() += c.armA.cross(impulse);
    }
    if (moves(c.b)) {
      impulses_[c.b].head<3>() -= impulse;
      impulses_[c.b].tail<3>() -= c.armB.cross(impulse);
    }
  };
  int at = 0;
  for (int i : island.frictional) {
    const Contact& c = contacts[i];
    const Vec3 q = relativeVelocity(bodies, c);
    demand = std::max(demand, contactDemand(q, c.friction));
    r.segment<3>(at) = projectOnCone(r.segment<3>(at), c.friction);
    push(c, c.frame * r.segment<3>(at));
    at += 3;
  }
  for (int i : island.frictionless) {
    const Contact& c = contacts[i];
    demand = std::max(demand, -normalVelocity(bodies, c));
    r[at] = std::max(r[at], 0.0);
    push(c, c.frame.col(0) * r[at++]);
  }
  const int rowsBegin = at;
  for (int i : island.rows) {
    const Row& c = rows[i];
    const double q = relativeVelocity(bodies, c);
    if (std::abs(q) > demand || (c.governor < 0 && isForced(c.lower, c.upper)))
      demand = std::max(demand, c.governor >= 0 ? std::abs(q) : demandOf(q, c.lower, c.upper, [&] {
                          return diagonal(bodies, c) + c.compliance;
                        }));
    if (c.governor < 0)
      r[at] = std::clamp(r[at], c.lower, c.upper);
    else if (!c.paired)
      moveIntoDisk(diskAt(rows, island, at - rowsBegin, rowsBegin), r);
    ++at;
  }
  at = rowsBegin;
  for (int i : island.rows) {
    const Row& c = rows[i];
    if (moves(c.a)) impulses_[c.a] += c.jacobianA.transpose() * r[at];
    if (moves(c.b)) impulses_[c.b] += c.jacobianB.transpose() * r[at];
    ++at;
  }
  for (int body : island.bodies) {
    const Body& free = bodies[body];
    Vec6& v = moved[body].velocity;
    v.head<3>() += free.inverseMass.cwiseProduct(impulses_[body].head<3>());
    v.tail<3>() += free.inverseInertia * impulses_[body].tail<3>();
  }
  return demand;
}

bool IslandCheck::isKept(const std::vector<Body>& bodies, const std::vector<Contact>& contacts,
                         const std::vector<Row>& rows, const Island& island, double share,
                         std::vector<Body>& moved, Solution& solution) {
  const double demand = move(bodies, contacts, rows, island, moved, solution.r);
  makeReady(island, Tier::Kept, solution);
  if (!KeptLaw(moved, contacts, rows, island, options_, share, demand, solution).holds()) {
    for (int body : island.bodies) moved[body].velocity = bodies[body].velocity;
    return false;
  }
  // At most rounding, whatever the user's tolerance: forces that nothing resists add up.
  const double still = share * std::min(options_.tolerance, Options().tolerance) * demand;
  if (isSlower(moved, contacts, rows, island, still))
    for (int body : island.bodies) moved[body].velocity.setZero();
  return true;
}

}  // namespace delassus
