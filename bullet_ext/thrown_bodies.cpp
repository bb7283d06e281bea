#include "bullet_ext/thrown_bodies.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "BulletDynamics/ConstraintSolver/btTypedConstraint.h"
#include "BulletDynamics/Dynamics/btRigidBody.h"
#include "bullet_ext/convert.h"
#include "bullet_ext/group.h"
#include "bullet_ext/solve_group.h"

namespace delassus::bullet {
namespace {

/// How fast the body, or its point at `arm`, is, m/s.
double speedOf(const std::vector<Body>& bodies, int body, const Vec3& arm) {
  if (body == fixedWorld) return 0;
  const Vec6& v = bodies[body].velocity;
  return std::max(v.head<3>().norm(), v.tail<3>().norm() * arm.norm());
}

double fasterOf(const std::vector<Body>& bodies, const Contact& c) {
  return std::max(speedOf(bodies, c.a, c.armA), speedOf(bodies, c.b, c.armB));
}

/// How far the bodies of a joint are from each other, m.
double lengthOf(const JointSource& joint) {
  const btTypedConstraint& constraint = *joint.constraint;
  return (toCore(constraint.getRigidBodyA().getWorldTransform().getOrigin()) -
          toCore(constraint.getRigidBodyB().getWorldTransform().getOrigin()))
      .norm();
}

/// Of the bodies of the island, before its reactions.
struct Inertia {
  double mass = 0, energy = 0;  ///< kg; of what does not turn, J
};
Inertia inertiaOf(const Group& group, const Island& island) {
  Inertia sum;
  for (const int body : island.bodies) {
    const double inverse = group.bodies[body].inverseMass.maxCoeff();
    if (!(inverse > 0)) continue;
    sum.mass += 1 / inverse;
    sum.energy += 0.5 / inverse * group.bodies[body].velocity.head<3>().squaredNorm();
  }
  return sum;
}

/// What is done to hold an island, and the most that is asked for there.
struct Hold {
  double work = 0;            ///< r (u + u⁺)/2 of all that holds, J
  double push = 0, turn = 0;  ///< targets, m/s and rad/s
};
/// No work where no joint holds, whatever contacts do.
Hold holdOf(const Group& group, const Island& island, const Problem& problem,
            const Solution& solution) {
  const VectorXd &r = solution.r, &compliance = problem.W.bodySpace().compliance;
  Hold sum;
  const auto add = [&](int at, double target) {
    sum.work += r[at] * (0.5 * (problem.q[at] + solution.u[at] - compliance[at] * r[at]) + target);
  };
  bool jointsHold = false;
  const auto contacts = static_cast<int>(r.size() - island.rows.size());
  for (std::size_t i = 0; i < island.rows.size(); ++i) {
    const int at = contacts + static_cast<int>(i);
    const Row& row = group.rows[island.rows[i]];
    if (row.governor >= 0 || r[at] == 0 || std::isfinite(r[at] > 0 ? row.upper : row.lower))
      continue;
    add(at, row.target);
    const bool turns = row.jacobianA.head<3>().isZero(0) && row.jacobianB.head<3>().isZero(0);
    double& asked = turns ? sum.turn : sum.push;
    asked = std::max(asked, std::abs(row.target));
    jointsHold = true;
  }
  if (!jointsHold) return {};

  int at = 0;
  const auto addContact = [&](double target) {
    add(at++, target);
    sum.push = std::max(sum.push, std::abs(target));
  };
  for (const int k : island.frictional)
    for (const double target : group.contacts[k].target) addContact(target);
  for (const int k : island.frictionless) addContact(group.contacts[k].target[0]);
  return sum;
}

/// How far the bodies of the island's joints are from each other at most, m.
double longestJoint(const Group& group, const Island& island) {
  double length = 0;
  for (const JointSource& joint : group.joints)
    if (joint.rowCount > 0 &&
        std::binary_search(island.rows.begin(), island.rows.end(), joint.firstRow))
      length = std::max(length, lengthOf(joint));
  return length;
}

}  // namespace

bool contactsThrowOne(const Group& group, const Island& island, double demand,
                      const Answer& answer) {
  double before = demand, after = 0;
  island.eachContact([&](int k) {
    before = std::max(before, fasterOf(group.bodies, group.contacts[k]));
    if (answer.contacts[k][0] > 0)
      after = std::max(after, fasterOf(answer.bodies, group.contacts[k]));
  });
  return after > reach * before;
}

bool jointsThrowOne(const Group& group, const Island& island, const Problem& problem,
                    const Solution& solution) {
  const Hold hold = holdOf(group, island, problem, solution);
  if (!(hold.work > 0)) return false;
  const Inertia inertia = inertiaOf(group, island);
  const auto exceeds = [&](double asked) {
    return hold.work >
           jointReach * jointReach * (inertia.energy + 0.5 * inertia.mass * asked * asked);
  };
  if (!exceeds(hold.push)) return false;  // few go on, so that all joints may be gone through
  return exceeds(hold.push + hold.turn * longestJoint(group, island));
}

void soften(const std::vector<Body>& bodies, Contact& contact) {
  constexpr double softness = 0.5 / (reach * reach);
  const auto response = [&](int index, const Vec3& arm) {
    if (index == fixedWorld) return 0.0;
    const Body& body = bodies[index];
    const Vec3 turn = arm.cross(Vec3(contact.frame.col(0)));
    return body.inverseMass.maxCoeff() + turn.dot(body.inverseInertia * turn);
  };
  contact.compliance +=
      softness * (response(contact.a, contact.armA) + response(contact.b, contact.armB));
}

void soften(const std::vector<Body>& bodies, Row& row) {
  constexpr double softness = 0.5 / (jointReach * jointReach);
  const auto response = [&](int index, const Row6& J) {
    if (index < 0) return 0.0;
    const Body& body = bodies[index];
    const Vec3 turn = J.tail<3>().transpose();
    return body.inverseMass.maxCoeff() * J.head<3>().squaredNorm() +
           turn.dot(body.inverseInertia * turn);
  };
  row.compliance += softness * (response(row.a, row.jacobianA) + response(row.b, row.jacobianB));
}

}  // namespace delassus::bullet
