#pragma once

#include <string>
#include <vector>

#include "LinearMath/btScalar.h"
#include "bullet_ext/address_table.h"
#include "bullet_ext/contact_event.h"
#include "bullet_ext/group_input.h"
#include "bullet_ext/joined_bodies.h"
#include "bullet_ext/step_report.h"
#include "delassus/articulation.h"
#include "delassus/body.h"
#include "delassus/contact.h"
#include "delassus/row.h"

class btMultiBodyConstraint;
class btRigidBody;

namespace delassus::bullet {

class Extension;

/// Stands where a body index is expected for a body that is not fit to take part.
constexpr int leftOut = -2;

/// Numbers beyond this (kg, 1/kg, m, s, N) are mistakes: squares of their products, or the answers
/// in Bullet's precision, would overflow. A mass beyond is Bullet's "infinity".
constexpr double largestNumber = sizeof(btScalar) == sizeof(double) ? 1e40 : 1e30;

/// How much rows of joints give at least, as a share of their W_ii. Poses are rounded, and axes are
/// often given in few digits, so that joints which share a freedom (two hinges of a door)
/// contradict each other a little; taken at their word they would lock it. A contradiction δ (rad,
/// or relative) slows the freedom by δ²/softness of itself a step, and a joint that carries M times
/// the mass of its lighter body slips by M times this of what it stops. ODE softens all of its
/// joints alike (its default CFM).
constexpr double leastSoftness = sizeof(btScalar) == sizeof(double) ? 1e-10 : 1e-8;

/// A push moves a body in vain if that is no more than this share of what it would move if no axis
/// were locked: what leans by less than 1e-4 rad lies in a locked axis. The exact answer there is
/// an impulse 1e8 times as large as without the lock.
constexpr double inVain = 1e-8;

/// How much contacts of bodies give that a joint holds to each other, as a share of what the one of
/// them adds to W_nn that adds less.
constexpr double joinedSoftness = 1e-2;

/// That of a row with Bullet's `cfm` (a fault of which stays one) and this W_ii.
inline double complianceOf(double cfm, double response) {
  return (cfm >= 0 && cfm < leastSoftness ? leastSoftness : cfm) * response;
}

/// What the gathered parts were in Bullet. Pointers are good until the end of the group.
struct BodySource {
  btRigidBody* rigid;  ///< null for a limb of an articulated body
  Vec6 before;         ///< velocity at the start of the step, before forces; of a limb, after them
};
struct PointSource {
  btPersistentManifold* manifold;
  int point;
  Trouble trouble = Trouble::None;  ///< of a point that takes no part
  bool fresh = false;               ///< the manifold has just got it
  /// The bodies of the manifold: read again when all has been solved, it would come from far away.
  const btCollisionObject *bodyA = nullptr, *bodyB = nullptr;
};
struct JointSource {
  btTypedConstraint* constraint;
  int firstRow, rowCount;  ///< among Group::rows
  int lastRow;             ///< the joint's own last row, or -1 if that row takes no part
  double lastImpulse;      ///< that the last step left in the joint, N·s
};

/// A row that an Extension has added.
struct MultiBodyRowSource {
  int row;  ///< among Group::rows
  btMultiBodyConstraint* constraint;
  int asked;     ///< among the rows that the constraints made
  int dof;       ///< the constraint's own number of it
  double guess;  ///< the impulse that the last step left there
};

/// What a joint writes for one row. Four scalars an axis and this alignment, because some joints
/// write whole btVector3.
struct alignas(16) InfoRow {
  btScalar linearA[4], angularA[4], linearB[4], angularB[4];
  btScalar error, cfm, lower, upper;
};

/// One solveGroup call in the core's words. Order follows Bullet's arrays, never addresses.
struct Group {
  std::vector<Body> bodies;  ///< dynamic and kinematic ones; everything else is the fixed world
  std::vector<BodySource> bodySources;

  std::vector<Contact> contacts;
  std::vector<PointSource> contactSources;
  std::vector<double> pushes;  ///< wanted normal push velocity of each contact, m/s (split impulse)
  std::vector<Vec3> guess;     ///< reaction of each contact to start from, N·s
  std::vector<PointSource> idle;  ///< points that were passed but take no part
  /// Contacts of one body of each island whose last reactions changed the motion; empty if there
  /// are none.
  std::vector<char> restless;
  int bouncing = 0;  ///< contacts with restitution
  int turning = 0;   ///< contacts with rolling or spinning friction

  std::vector<Row> rows;                     ///< of joints, then of turning friction
  int turningRows = 0;                       ///< the last of them
  int softRows = 0;                          ///< those whose joint asks for a compliance
  std::vector<double> rowGuess;              ///< reaction of each row to start from, N·s
  std::vector<JointSource> joints;           ///< enabled joints that have rows
  std::vector<btTypedConstraint*> obsolete;  ///< enabled constraints without rows in getInfo1

  Articulation articulation;                      ///< what an Extension has added
  std::vector<MultiBodyRowSource> multiBodyRows;  ///< the same, in the order of the rows

  AddressTable indexOf;
  JoinedBodies joined;
  std::vector<InfoRow> asked;  ///< of the joint that is being gathered

  void clear();
  std::size_t bytes() const;
  bool movable(int body) const { return body >= 0 && bodies[body].movable(); }
  bool isLimb(int body) const { return body >= 0 && !bodySources[body].rigid; }
};

/// Reads a whole solveGroup call into `group`, which forgets what it was. An extension is asked for
/// its parts in between; `asStock`: see gatherTurningFriction. Of Bullet's objects only joints are
/// written to: their impulses and feedback are cleared. The functions below are its parts, in their
/// order.
void gatherGroup(Group& group, const GroupInput& input, StepReport& report,
                 Extension* extension = nullptr, bool asStock = false);

/// Index of the object in `group`, which it joins if it is new: a body, fixedWorld or leftOut.
///
/// A body, contact or row whose numbers are not finite or absurd is left out: the rest is solved as
/// if it were not there, and the report names it.
///
/// Its free velocity over the step h is that of Bullet's solvers, with gyroscopic terms Δω taken at
/// the start of the step and locked axes kept still (L, A: linear and angular factor; F and T carry
/// them already; [A ≠ 0] is 1 for an axis that is not locked, else 0):
///
///     v + h F/m,   ω + [A ≠ 0] (h I⁻¹ T + Δω),   M⁻¹ = diag(L/m, A I⁻¹ A)
int bodyIndex(Group& group, btCollisionObject& object, const btContactSolverInfo& info,
              StepReport& report);

/// Bodies, then contacts with the target velocities of Bullet's sequential impulse solver:
///
///     d = distance + slop        e' = max(0, −e a) if |a| ≥ threshold, else 0
///     d > 0:  target = e' − d/h              the contact may close its gap, no more
///     d ≤ 0:  target = e' + erp (−d)/h
///        or:  target = e',  push = erp (−d)/h    where the impulse is split
///     compliance = cfm/h;  with stiffness k and damping c:  cfm = 1/(h k + c),  erp = h k cfm
///
/// where a is the relative velocity before forces; with a link, whose velocity has them already,
/// after them, as in Bullet. Of points that move no further in a step than four roundings of their
/// places in Bullet's precision (in float at 10 m: 1e-5 m), a distance d of no more than that is
/// none: they touch (but those of links, whose forces move them further). Taken at its word it
/// would have every pile of boxes that has fallen share its loads anew in every step, at the whim
/// of the last digit. A contact with its own softness is never split: the spring would be lost to
/// the push. One whose push moves neither body (inVain), or that of what keeps its place with what
/// stands, is idle. Friction: see contact_frame.h.
///
/// Bodies that a joint holds to each other (gatherJoined comes first) collide all the same, unless
/// the joint was added to the world as one whose bodies do not. Their contacts give by
/// joinedSoftness and are never split: where they contradict the joint, both would be met, as rigid
/// as they are, by 1e9 N·s.
void gatherBodies(Group& group, btCollisionObject** bodies, int count,
                  const btContactSolverInfo& info, StepReport& report);
void gatherJoined(Group& group, btTypedConstraint** constraints, int count);
void gatherContacts(Group& group, btPersistentManifold** manifolds, int count,
                    const btContactSolverInfo& info, btDispatcher* dispatcher, StepReport& report);

/// Whether the step starts from the reactions of the last one. An exact answer needs no damping of
/// where it starts from: m_warmstartingFactor only says whether to start there.
bool warmStarts(const btContactSolverInfo& info);

/// Rows of the joints as their getInfo1 and getInfo2 answer. With the joint's damping D and its
/// dimensionless softness χ:
///
///     target = error + (1 − D) J v_f,   compliance = max(χ, leastSoftness) W_ii
///
/// W_ii is that of the masses without linear and angular factors, as in Bullet's solvers. A row
/// whose impulse could move nothing, since its bodies are locked along it, takes no part (Bullet's
/// gains no more than a little a sweep there). A disabled joint has no rows. Impulses and feedback
/// are cleared.
void gatherJoints(Group& group, btTypedConstraint** constraints, int count,
                  const btContactSolverInfo& info, StepReport& report);

/// Rows against rolling and spinning, of the contacts that ask for it; call it when all other rows
/// are gathered. With Bullet's combined coefficients, read from the point and in m:
///
///     |τ_n| ≤ spinning r_n,   ‖τ_t‖ ≤ rolling r_n   (turning_friction.h; axes: contact_frame.h)
///
/// Bullet's solver bounds these impulses by the coefficients themselves too, in N·m·s, so that a
/// heavy body hardly feels them, and knows no spinning friction without rolling friction. `asStock`
/// has both of rigid bodies (those of links are as above in Bullet too). A coefficient that is no
/// number is none: Bullet's rule, κ_A μ_B + κ_B μ_A, makes that of a friction μ without limit.
void gatherTurningFriction(Group& group, bool asStock = false);

/// What is wrong with a row, or null.
const char* faultOfRow(const Row& row);

/// How messages call an object: by its place in the world. Contacts and joints: by their bodies. A
/// link: by its number and its multibody too, which is called by the name of its base, or by the
/// place of its first collider.
std::string nameOf(const btCollisionObject& object);
std::string nameOf(const PointSource& source);
std::string nameOf(const btTypedConstraint& joint);
std::string nameOf(btMultiBodyConstraint& constraint);

}  // namespace delassus::bullet
