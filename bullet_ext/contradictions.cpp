#include "bullet_ext/contradictions.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "BulletDynamics/ConstraintSolver/btTypedConstraint.h"
#include "BulletDynamics/Dynamics/btRigidBody.h"
#include "bullet_ext/convert.h"
#include "bullet_ext/group.h"
#include "bullet_ext/solve_group.h"
#include "delassus/contact_motion.h"

namespace delassus::bullet {
namespace {

/// The largest speed of a row's bodies, before the reactions or after them, since a resting body
/// may be struck, m/s; turns along the row's arc.
double speedOf(const Group& group, const Answer& answer, int row) {
  double largest = 0;
  for (const int body : {group.rows[row].a, group.rows[row].b})
    if (body >= 0)
      for (const std::vector<Body>* bodies : {&group.bodies, &answer.bodies}) {
        const Vec6 speed = (*bodies)[body].velocity.cwiseAbs();
        largest = std::max(
            {largest, speed.head<3>().maxCoeff(), group.arcOf(row) * speed.tail<3>().maxCoeff()});
      }
  return largest;
}

/// The largest change of relative velocity that the joint's rows ask for, m/s.
double askedBy(const Group& group, const JointSource& joint) {
  double largest = 0;
  for (int i = joint.firstRow; i < joint.firstRow + joint.rowCount; ++i)
    largest = std::max(largest, std::abs(relativeVelocity(group.bodies, group.rows[i])));
  return largest;
}

/// The velocity that the rounding of poses may ask for, m/s, of bodies no further than `places`
/// from the origin, or with arcs as long. It does not fall below that at 1 m.
double askedByRounding(const Group& group, double places) {
  constexpr double roundings = 4;
  return roundings * SIMD_EPSILON * std::max(places, 1.0) / group.h;
}

double placeOf(const btRigidBody& body) {
  return toCore(body.getWorldTransform().getOrigin()).cwiseAbs().maxCoeff();
}

double placesOf(const JointSource& joint) {
  return std::max(placeOf(joint.constraint->getRigidBodyA()),
                  placeOf(joint.constraint->getRigidBodyB()));
}

double placesOf(const Group& group, const Island& island) {
  double places = 0;
  for (const int body : island.bodies)
    if (const btRigidBody* rigid = group.bodySources[body].rigid)
      places = std::max(places, placeOf(*rigid));
  return places;
}

/// The velocity that the reaction of a row would give its bodies alone, m/s.
double pushOf(const Group& group, const Answer& answer, int row) {
  return std::abs(answer.rows[row]) * diagonal(group.bodies, group.rows[row]);
}

/// Whether no more than what drives joints, and pushes with all its force, loads this row. It may
/// have a longer arm.
bool isDriven(const Group& group, const Island& island, int row, const Answer& answer) {
  constexpr double times = 10;
  double drive = 0;
  for (const int k : island.rows) {
    const double r = answer.rows[k];
    if (group.rows[k].governor >= 0) continue;
    if (r >= group.rows[k].upper || r <= group.rows[k].lower) drive += pushOf(group, answer, k);
  }
  return pushOf(group, answer, row) <= times * drive;
}

/// Makes the island of this row incompatible, and blames the row by its place among the unknowns.
void blame(const Group& group, int row, double missed, Answer& answer) {
  for (int i = 0; i < answer.islands.count(); ++i) {
    const Island& island = answer.islands[i];
    const auto found = std::find(island.rows.begin(), island.rows.end(), row);
    if (found == island.rows.end()) continue;
    IslandResult& result = answer.results[i];
    if (result.status != Status::Solved) return;  // the island is already blamed for more
    if (isDriven(group, island, row, answer)) return;
    result.status = Status::Incompatible;
    result.residualMax = std::max(result.residualMax, missed);
    result.residualRms = std::hypot(result.residualRms, missed / std::sqrt(result.parts));
    result.blamed = {static_cast<int>(3 * island.frictional.size() + island.frictionless.size() +
                                      (found - island.rows.begin()))};
    return;
  }
}

/// Sets islands to solved if they miss no more than the rounding of poses asks for.
void forgiveRounding(const Group& group, Answer& answer) {
  for (int i = 0; i < answer.islands.count(); ++i) {
    IslandResult& result = answer.results[i];
    const Island& island = answer.islands[i];
    if (result.status != Status::Incompatible || result.isSoftened ||
        result.residualMax > askedByRounding(group, island))
      continue;
    result.status = Status::Solved;
    result.blamed.clear();
    island.eachContact([&](int contact) { answer.troubles[contact] = Trouble::None; });
  }
}

/// Blames the joint's row that gives most, if it gives much.
void judgeJoint(const Group& group, const JointSource& joint, Answer& answer) {
  constexpr double share = 0.1;
  const auto missedBy = [&](int row) {
    return group.rows[row].compliance * std::abs(answer.rows[row]);
  };
  int worst = joint.firstRow;
  for (int i = joint.firstRow + 1; i < joint.firstRow + joint.rowCount; ++i)
    if (missedBy(i) > missedBy(worst)) worst = i;
  const double missed = missedBy(worst);
  if (missed > share * speedOf(group, answer, worst) &&
      missed > askedByRounding(group, std::max(placesOf(joint), group.arcOf(worst))) &&
      missed > share * askedBy(group, joint))
    blame(group, worst, missed, answer);
}

}  // namespace

double askedByRounding(const Group& group, const Island& island) {
  return askedByRounding(group, placesOf(group, island));
}

void judgeContradictions(const Group& group, Answer& answer) {
  forgiveRounding(group, answer);
  for (const JointSource& joint : group.joints)
    if (!joint.isSoft && joint.rowCount > 0) judgeJoint(group, joint, answer);
}

}  // namespace delassus::bullet
