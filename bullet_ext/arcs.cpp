#include "bullet_ext/arcs.h"

#include <algorithm>
#include <cmath>

#include "BulletDynamics/Dynamics/btRigidBody.h"
#include "bullet_ext/convert.h"
#include "bullet_ext/group.h"
#include "delassus/articulation.h"

namespace delassus::bullet {
namespace {

/// How a row's bodies respond to an impulse, and to one about the row's axis.
struct Response {
  double linear = 0;   ///< Σ m⁻¹, 1/kg
  double angular = 0;  ///< Σ a·I⁻¹a, 1/(kg m²)

  double arc() const { return std::sqrt(linear / angular); }
};

void add(const btRigidBody& body, const Vec3& axis, Response& sum) {
  // About an axis about which nothing turns it, I⁻¹ is rounding.
  constexpr double rounding = std::max(1e-8, 16.0 * SIMD_EPSILON);
  const Mat3 inverseInertia = toCore(body.getInvInertiaTensorWorld());
  const double angular = axis.dot(inverseInertia * axis);
  if (!(angular > rounding * inverseInertia.trace() * axis.squaredNorm())) return;
  sum.linear += body.getInvMass();
  sum.angular += angular;
}

void add(const Articulation::Limb& limb, const Vec3& axis, Response& sum) {
  const double linear = limb.motion.topRows<3>().squaredNorm() / 3;
  const double angular = (axis.transpose() * limb.motion.bottomRows<3>()).squaredNorm();
  if (!(linear > 0 && angular > 0)) return;
  sum.linear += linear;
  sum.angular += angular;
}

void add(const Group& group, const Row& row, Response& sum) {
  if (!turns(row)) return;
  const auto addBody = [&](int body, const Vec3& axis) {
    if (!group.movable(body)) return;
    if (const Articulation::Limb* limb = group.articulation.limbOf(body))
      add(*limb, axis, sum);
    else
      add(*group.bodySources[body].rigid, axis, sum);
  };
  addBody(row.a, row.jacobianA.tail<3>());
  addBody(row.b, row.jacobianB.tail<3>());
}

void stateAlongArc(Group& group, std::size_t k, double arc) {
  group.arcs[k] = arc;
  Row& row = group.rows[k];
  row.jacobianA *= arc;
  row.jacobianB *= arc;
  row.target *= arc;
  row.lower /= arc;
  row.upper /= arc;
  row.compliance *= arc * arc;
}

/// The rows of the constraints of articulated bodies.
void stateJointRows(Group& group) {
  for (const MultiBodyRowSource& source : group.multiBodyRows)
    stateAlongArc(group, source.row, source.arc);
  KeptList<Articulation::JointRow>& jointRows = group.articulation.jointRows;
  for (std::size_t i = 0; i < jointRows.size(); ++i)
    jointRows[i].effect *= group.arcs[jointRows[i].row];
}

}  // namespace

bool turns(const Row& row) {
  return row.jacobianA.head<3>().isZero(0) && row.jacobianB.head<3>().isZero(0);
}

void stateAlongArcs(Group& group) {
  const std::size_t rows = group.rows.size();
  group.arcs.assign(rows, 1);
  stateJointRows(group);
  const auto isOfLimbs = [&](const Row& row) { return group.isLimb(row.a) || group.isLimb(row.b); };
  for (std::size_t k = 0; k < rows; ++k) {
    if (group.rows[k].governor < 0 && isOfLimbs(group.rows[k])) continue;
    // The rows of a disk have one arc, or it would be an ellipse.
    const std::size_t last = k + group.rows[k].paired;
    Response sum;
    for (std::size_t i = k; i <= last; ++i) add(group, group.rows[i], sum);
    if (sum.linear > 0)
      for (std::size_t i = k; i <= last; ++i) stateAlongArc(group, i, sum.arc());
    k = last;
  }
}

}  // namespace delassus::bullet
