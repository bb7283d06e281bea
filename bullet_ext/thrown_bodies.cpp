#include "bullet_ext/thrown_bodies.h"

#include <Eigen/Geometry>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "BulletDynamics/ConstraintSolver/btTypedConstraint.h"
#include "bullet_ext/arcs.h"
#include "bullet_ext/convert.h"
#include "bullet_ext/group.h"
#include "bullet_ext/solve_group.h"
#include "delassus/contact_motion.h"

namespace delassus::bullet {
namespace {

constexpr double asSoftAsSprings = 1e-3;  ///< of the response

/// The speed of the body, or of its point at `arm` if that is faster, m/s.
double speedOf(const std::vector<Body>& bodies, int body, const Vec3& arm) {
  if (body == fixedWorld) return 0;
  const Vec6& v = bodies[body].velocity;
  return std::max(v.head<3>().norm(), v.tail<3>().norm() * arm.norm());
}

double fasterOf(const std::vector<Body>& bodies, const Contact& c) {
  return std::max(speedOf(bodies, c.a, c.armA), speedOf(bodies, c.b, c.armB));
}

/// The longest way from the centre of a body to a contact of the island, m.
double longestArm(const Group& group, const Island& island) {
  double arm = 0;
  island.eachContact([&](int k) {
    const Contact& c = group.contacts[k];
    if (c.a != fixedWorld) arm = std::max(arm, c.armA.norm());
    if (c.b != fixedWorld) arm = std::max(arm, c.armB.norm());
  });
  return arm;
}

/// How fast contacts of the island go round its bodies if these turn as joints ask, m/s. A motor of
/// little force asks for little, whatever its speed.
double askedByTurns(const Group& group, const Island& island) {
  double turn = 0;
  for (const int k : island.rows) {
    const Row& row = group.rows[k];
    if (row.governor < 0 && turns(row))
      turn = std::max(turn, demandOf(-row.target, row.lower, row.upper, [&] {
                              return diagonal(group.bodies, row);
                            }) / group.arcOf(k));
  }
  return turn * longestArm(group, island);
}

/// The reaction of this row at which its joint breaks; infinite if no joint has asked for the row.
double breakingImpulseOf(const Group& group, int row) {
  const JointSource* joint = jointOf(group, row);
  return joint ? toCoreBound(joint->constraint->getBreakingImpulseThreshold()) / group.arcOf(row)
               : infinity;
}

/// The largest impulse that may push the row up, or down.
double boundOf(const Row& row, bool up) { return up ? row.upper : -row.lower; }

/// The work that is done to the bodies of an island, J.
struct Hold {
  double work = 0;   ///< r (u + u⁺)/2 of all that holds
  double asked = 0;  ///< r·target of all that holds
  double alone = 0;  ///< ½ target²/W_ii: the work, if each target were met alone
  double drive = 0;  ///< work of what drives joints
  double brake = 0;  ///< what drives take up, as a motor whose arm is pushed back
};
/// All zero where no joint holds, whatever contacts do.
Hold holdOf(const Group& group, const std::vector<Contact>& contacts, const std::vector<Row>& rows,
            const Island& island, const Problem& problem, const Solution& solution) {
  const VectorXd &r = solution.r, &compliance = problem.W.bodySpace().compliance;
  Hold sum;
  const auto workOf = [&](int at, double target) {
    return r[at] * (0.5 * (problem.q[at] + solution.u[at] - compliance[at] * r[at]) + target);
  };
  const auto add = [&](int at, double target, double response) {
    sum.work += workOf(at, target);
    if (!(r[at] * target > 0) || !(response > 0)) return;
    sum.asked += r[at] * target;
    sum.alone += 0.5 * target * target / response;
  };
  // Of what drives or brakes: more than that only comes to it from what throws.
  const auto aloneOf = [&](int at, const Row& row) {
    return std::abs(r[at] * (problem.q[at] + row.target)) +
           0.5 * r[at] * r[at] * diagonal(group.bodies, row);
  };
  bool jointsHold = false;
  island.eachRowAt([&](int k, int at) {
    const Row& row = rows[k];
    if (row.governor >= 0 || r[at] == 0) return;
    const bool up = r[at] > 0;
    if (std::abs(r[at]) >= boundOf(row, up) || drives(group, k, up)) {
      const double work = workOf(at, row.target), most = aloneOf(at, row);
      sum.drive += std::clamp(work, 0.0, most);
      sum.brake += std::clamp(-work, 0.0, most);
      return;
    }
    add(at, row.target, diagonal(group.bodies, row));
    jointsHold = true;
  });
  if (!jointsHold) return {};

  island.eachContactAt([&](int k, int at, int unknowns) {
    const Contact& c = contacts[k];
    for (int axis = 0; axis < unknowns; ++axis)
      add(at + axis, c.target[axis], diagonal(group.bodies, c, axis));
  });
  return sum;
}

/// The energy that forces take from the island's bodies in this step, or would give them from rest
/// if that is more, J.
double workOfForces(const Group& group, const Island& island) {
  double taken = 0, given = 0;
  for (const int body : island.bodies) {
    const double inverse = group.bodies[body].inverseMass.maxCoeff();
    if (!(inverse > 0)) continue;
    const Vec3 before = group.bodySources[body].before.head<3>();
    const Vec3 gain = group.bodies[body].velocity.head<3>() - before;
    taken -= before.dot(gain) / inverse;
    given += 0.5 * gain.squaredNorm() / inverse;
  }
  return std::max(taken, given);
}

/// The largest speed of bodies that touch the island and do not give way, m/s.
double driveOf(const Group& group, const Island& island) {
  double drive = 0;
  island.eachContact([&](int k) {
    const Contact& c = group.contacts[k];
    if (!group.movable(c.a)) drive = std::max(drive, speedOf(group.bodies, c.a, c.armA));
    if (!group.movable(c.b)) drive = std::max(drive, speedOf(group.bodies, c.b, c.armB));
  });
  return drive;
}

}  // namespace

bool contactsThrowOne(const Group& group, const Island& island, double demand, const Answer& answer,
                      double times) {
  double before = demand, after = 0;
  island.eachContact([&](int k) {
    before = std::max(before, fasterOf(group.bodies, group.contacts[k]));
    if (answer.contacts[k][0] > 0)
      after = std::max(after, fasterOf(answer.bodies, group.contacts[k]));
  });
  return after > times * before && after > times * (before + askedByTurns(group, island));
}

bool isSpring(const Group& group, const Contact& contact) {
  return contact.compliance >= asSoftAsSprings * diagonal(group.bodies, contact, 0);
}
bool isSpring(const Group& group, const Row& row) {
  return row.compliance >= asSoftAsSprings * diagonal(group.bodies, row);
}

bool drives(const Group& group, int row, bool up) {
  const double bound = boundOf(group.rows[row], up);
  return std::isfinite(bound) && bound < breakingImpulseOf(group, row);
}

TargetWork workOfTargets(const Group& group, const std::vector<Contact>& contacts,
                         const std::vector<Row>& rows, const Island& island, const Problem& problem,
                         const Solution& solution) {
  const Hold hold = holdOf(group, contacts, rows, island, problem, solution);
  constexpr double ofEnergy = 0.25;
  TargetWork work;
  // Without rounding the work would be no more than what is asked for. What a motor or a spring
  // takes up at the same time throws nothing: it is pushed back.
  work.done = std::min(hold.work, hold.asked) - hold.brake;
  work.fair = hold.alone + hold.drive;
  work.allowed = timesAlone * hold.alone + 2 * hold.drive;
  if (work.done <= work.allowed) return work;  // as most do: the energy is expensive
  const double forces = 2 * workOfForces(group, island);
  work.fair += forces;
  work.allowed = std::max(work.allowed, ofEnergy * energyOf(group, island, group.bodies) + forces);
  return work;
}

double energyOf(const Group& group, const Island& island, const std::vector<Body>& bodies,
                double leastSpeed) {
  double sum = 0;
  for (const int k : island.bodies) {
    const Body& body = bodies[k];
    const Mat3 inertia =
        group.ownInverseInertia(k).completeOrthogonalDecomposition().pseudoInverse();
    const Vec3 turn = body.velocity.tail<3>();
    sum += 0.5 * turn.dot(inertia * turn);
    const double inverse = body.inverseMass.maxCoeff();
    const double speed = std::max(body.velocity.head<3>().norm(), leastSpeed);
    if (inverse > 0) sum += 0.5 / inverse * speed * speed;
  }
  return sum;
}

bool hasLockedAxis(const Body& body) {
  return body.inverseMass.minCoeff() == 0 || body.inverseInertia.determinant() == 0;
}

bool mayBeSqueezed(const Group& group, const Island& island) {
  constexpr double rounding = 1e-3;  // of poses: share of the speed
  const double drive = driveOf(group, island);
  if (drive == 0) return false;
  const double little = rounding * drive, arm = longestArm(group, island);
  constexpr int none = fixedWorld - 1;
  int carrier = none;
  Vec6 way = Vec6::Zero();
  const auto isTurning = [&](const Vec6& v) { return v.tail<3>().norm() * arm > little; };
  const auto goesAnotherWay = [&](int body) {
    if (group.movable(body) || body == carrier) return false;
    const Vec6 own = body == fixedWorld ? Vec6(Vec6::Zero()) : group.bodies[body].velocity;
    if (carrier == none) {
      carrier = body;
      way = own;
      return false;
    }
    return isTurning(way) || isTurning(own) || (own - way).head<3>().norm() > little;
  };
  bool isSqueezed = false;
  island.eachContact([&](int k) {
    const Contact& c = group.contacts[k];
    isSqueezed = isSqueezed || goesAnotherWay(c.a) || goesAnotherWay(c.b);
  });
  for (const int k : island.rows)
    isSqueezed = isSqueezed || goesAnotherWay(group.rows[k].a) || goesAnotherWay(group.rows[k].b);
  const auto cannotGoAlong = [&](int k) {
    const Body& body = group.bodies[k];
    if (!hasLockedAxis(body)) return false;
    const auto locked = body.inverseMass.array() == 0;
    return isTurning(way) || (locked && way.head<3>().array().abs() > little).any();
  };
  return isSqueezed || std::any_of(island.bodies.begin(), island.bodies.end(), cannotGoAlong);
}

double energyAtHand(const Group& group, const Island& island) {
  double drive = driveOf(group, island);
  island.eachContact([&](int k) { drive = std::max(drive, group.contacts[k].target.norm()); });
  for (const int k : island.rows)
    if (const Row& row = group.rows[k]; row.governor < 0 && !turns(row))
      drive = std::max(drive, std::abs(row.target));
  return energyOf(group, island, group.bodies, drive + askedByTurns(group, island));
}

void soften(const std::vector<Body>& bodies, Contact& contact, double share) {
  constexpr double softness = 0.5 / (reach * reach);
  const auto response = [&](int index, const Vec3& arm) {
    if (index == fixedWorld) return 0.0;
    const Body& body = bodies[index];
    const Vec3 turn = arm.cross(Vec3(contact.frame.col(0)));
    return body.inverseMass.maxCoeff() + turn.dot(body.inverseInertia * turn);
  };
  contact.compliance +=
      share * softness * (response(contact.a, contact.armA) + response(contact.b, contact.armB));
}

}  // namespace delassus::bullet
