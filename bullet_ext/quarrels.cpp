#include "bullet_ext/quarrels.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "bullet_ext/contradictions.h"
#include "bullet_ext/group.h"
#include "bullet_ext/response.h"
#include "bullet_ext/thrown_bodies.h"
#include "bullet_ext/workshop.h"
#include "delassus/contact_motion.h"

namespace delassus::bullet {
namespace {

/// Whether the row is of a joint that is no spring.
bool isHard(const Group& group, int row) {
  const JointSource* joint = group.rows[row].governor < 0 ? jointOf(group, row) : nullptr;
  return joint && !joint->isSoft && !isSpring(group, group.rows[row]);
}

/// Whether this reaction of the row is that of a joint that holds: neither that of a spring nor of
/// what drives the joint.
bool holds(const Group& group, int row, double reaction) {
  return isHard(group, row) && !drives(group, row, reaction > 0);
}

double strainOfContacts(const Group& group, const Island& island, const VectorXd& r) {
  double furthest = 0;
  island.eachContactAt([&](int k, int at, int) {
    furthest = std::max(furthest, r[at] * diagonal(group.bodies, group.contacts[k], 0));
  });
  return furthest;
}

double strainOfJoints(const Group& group, const Island& island, const VectorXd& r) {
  double furthest = 0;
  island.eachRowAt([&](int k, int at) {
    if (holds(group, k, r[at]))
      furthest = std::max(furthest, std::abs(r[at]) * diagonal(group.bodies, group.rows[k]));
  });
  return furthest;
}

/// The largest velocity, m/s, that a spring gives its bodies, or that a drive may give them.
double strengthOfDrives(const Group& group, const Island& island, const VectorXd& r) {
  double most = 0;
  island.eachRowAt([&](int k, int at) {
    const Row& row = group.rows[k];
    double strength = isHard(group, k) ? 0 : std::abs(r[at]);
    if (drives(group, k, true)) strength = std::max(strength, row.upper);
    if (drives(group, k, false)) strength = std::max(strength, -row.lower);
    most = std::max(most, strength * diagonal(group.bodies, row));
  });
  return most;
}

/// Whether a row that holds reaches the threshold at which its joint breaks.
bool breaksJoints(const Group& group, const Island& island, const VectorXd& r) {
  constexpr double rounding = 1e-9;
  bool breaks = false;
  island.eachRowAt([&](int k, int at) {
    const double reaction = r[at];
    const double bound = reaction > 0 ? group.rows[k].upper : -group.rows[k].lower;
    if (reaction != 0 && std::abs(reaction) >= (1 - rounding) * bound)
      breaks |= holds(group, k, reaction);
  });
  return breaks;
}

bool isMotor(const Group& group, int row) {
  return drives(group, row, true) && drives(group, row, false);
}

/// The largest velocity of recovery that a contact or joint asks for, m/s.
double mostAsked(const Group& group, const Island& island) {
  double most = 0;
  island.eachContact([&](int k) { most = std::max(most, group.contacts[k].target[0]); });
  for (const int k : island.rows)
    if (isHard(group, k) && !isMotor(group, k))
      most = std::max(most, std::abs(group.rows[k].target));
  return most;
}

}  // namespace

double strainOf(const Group& group, const Island& island, const Solution& solution) {
  const double ofContacts = strainOfContacts(group, island, solution.r);
  return island.rows.empty() ? ofContacts
                             : std::min(ofContacts, strainOfJoints(group, island, solution.r));
}

Quarrel quarrelOf(const Group& group, const Island& island, double demand,
                  const Solution& solution) {
  constexpr double times = 1e3;
  const bool hasJoints = !island.rows.empty();
  if (!island.hasContacts()) return Quarrel::None;
  if (solution.status == Status::Incompatible) return hasJoints ? Quarrel::Strained : Quarrel::None;
  const auto isLocked = [&](int k) { return hasLockedAxis(group.bodies[k]); };
  const bool isHeld =
      hasJoints || std::any_of(island.bodies.begin(), island.bodies.end(), isLocked);
  const auto isMuch = [&](double strain) {
    return strain > times * demand && strain > times * askedByRounding(group, island);
  };
  // Contacts first: in most islands they are not strained.
  if (isHeld && isMuch(strainOfContacts(group, island, solution.r)) &&
      (!hasJoints || isMuch(strainOfJoints(group, island, solution.r))))
    return Quarrel::Strained;
  return breaksJoints(group, island, solution.r) ? Quarrel::Breaking : Quarrel::None;
}

bool isWedged(const Group& group, const Island& island, double demand, const Solution& solution) {
  constexpr double timesDemand = 1e7, timesDrives = 10;
  const double strain = strainOf(group, island, solution);
  return strain > timesDemand * demand &&
         strain > timesDrives * strengthOfDrives(group, island, solution.r);
}

const Problem& recoveryProblem(const Group& group, const Island& island, Bench& bench) {
  // In the end, bodies rather leave their joints than lie in each other, as with stock.
  constexpr double contactSoftness = 1e-3, jointSoftness = 1e-2;
  bench.softBodies.resize(group.bodies.size());  // those of other islands are not read
  const auto stop = [&](int body) {
    if (body == fixedWorld) return;
    bench.softBodies[body] = group.bodies[body];
    bench.softBodies[body].velocity.setZero();
  };
  bench.changeContacts(group.contacts, island, [&](Contact& contact) {
    contact.friction = 0;
    contact.compliance += contactSoftness * lesserResponse(group, contact);
    stop(contact.a);
    stop(contact.b);
  });
  bench.changeRows(group.rows, island, [&](Row& row, int k) {
    if (row.governor >= 0) {
      row.jacobianA.setZero();
      row.jacobianB.setZero();
    } else if (isMotor(group, k)) {
      row.lower = row.upper = 0;
    } else if (isHard(group, k)) {
      row.compliance += jointSoftness * diagonal(group.bodies, row);
      // No joint breaks as it recovers.
      if (!drives(group, k, true)) row.upper = infinity;
      if (!drives(group, k, false)) row.lower = -infinity;
    }
    stop(row.a);
    stop(row.b);
  });
  return bench.assembler.assemble(bench.softBodies, bench.softContacts, bench.softRows, island);
}

void recover(const Group& group, const Island& island, const VectorXd& r, Bench& bench) {
  std::vector<Body>& bodies = bench.softBodies;
  applyReaction(bodies, bench.softContacts, bench.softRows, island, r);
  const double energy = energyOf(group, island, bodies), atHand = energyAtHand(group, island);
  if (energy <= atHand) return;
  const double share = std::sqrt(atHand / energy);
  for (const int body : island.bodies) bodies[body].velocity *= share;
}

const Problem& recoveringProblem(const Group& group, const Island& island, Friction friction,
                                 Bench& bench) {
  bench.changeContacts(group.contacts, island, [&](Contact& contact) {
    if (isSpring(group, contact)) return;
    const Vec3 reached = contact.frame.transpose() * slip(bench.softBodies, contact);
    contact.target[0] = std::min(contact.target[0], reached[0]);
    if (friction == Friction::OfOtherSlip) contact.target.tail<2>() += reached.tail<2>();
  });
  bench.changeRows(group.rows, island, [&](Row& row, int k) {
    if (!isHard(group, k) || isMotor(group, k)) return;
    const double reached = row.target + relativeVelocity(bench.softBodies, row);
    const bool isMet =
        row.lower == 0 ? reached > row.target : row.upper == 0 && reached < row.target;
    if (!isMet) row.target = reached;
  });
  return bench.assembler.assemble(group.bodies, bench.softContacts, bench.softRows, island);
}

double shareCut(const Group& group, const Island& island, double demand, const Bench& bench) {
  constexpr double negligible = 1e-5;
  double cut = 0;
  island.eachContact([&](int k) {
    cut = std::max(cut, group.contacts[k].target[0] - bench.softContacts[k].target[0]);
  });
  for (const int k : island.rows)
    if (isHard(group, k) && !isMotor(group, k))
      cut = std::max(cut, std::abs(group.rows[k].target - bench.softRows[k].target));
  return cut > 0 ? cut / std::max(mostAsked(group, island), negligible * demand) : 0;
}

}  // namespace delassus::bullet
