#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "LinearMath/btScalar.h"
#include "bullet_ext/address_table.h"
#include "bullet_ext/contact_event.h"
#include "bullet_ext/held_contacts.h"
#include "bullet_ext/joined_bodies.h"
#include "bullet_ext/joint_load.h"
#include "bullet_ext/joint_loops.h"
#include "bullet_ext/opposed_contacts.h"
#include "delassus/articulation.h"
#include "delassus/body.h"
#include "delassus/contact.h"
#include "delassus/row.h"

class btCollisionObject;
class btMultiBodyConstraint;
class btPersistentManifold;
class btRigidBody;
class btTypedConstraint;

namespace delassus::bullet {

/// Takes the place of the index of a body that is left out.
constexpr int leftOut = -2;

/// Numbers beyond this (kg, 1/kg, m, s, N) are taken for mistakes: squares of their products, or
/// the answers in Bullet's precision, would overflow. A mass beyond it is Bullet's "infinity".
constexpr double largestNumber = sizeof(btScalar) == sizeof(double) ? 1e40 : 1e30;

/// Where the gathered parts come from in Bullet. Pointers are good until the end of the group.
struct BodySource {
  btRigidBody* rigid;  ///< null for a limb of an articulated body
  Vec6 before;         ///< velocity at the step's start, before forces; of a limb, after them
};
struct PointSource {
  btPersistentManifold* manifold;
  int point;
  Trouble trouble = Trouble::None;  ///< of a point that takes no part
  bool fresh = false;               ///< the point is new in the manifold
  /// The bodies of the manifold, copied here: after the solve the manifold is far from the cache.
  const btCollisionObject *bodyA = nullptr, *bodyB = nullptr;
};
struct JointSource {
  btTypedConstraint* constraint;
  int firstRow, rowCount;  ///< among Group::rows
  int lastRow;             ///< the joint's own last row, or -1 if that row takes no part
  double lastImpulse;      ///< that the last step left in the joint, N·s or N·m·s
  bool isSoft = false;     ///< the joint asks for a compliance of its own
  /// What its rows did in the last step. The last reactions do not tell it, since Bullet turns the
  /// rows of a hinge.
  JointLoad lastLoad = {};
};

/// What one step tells the next about an island.
struct IslandMarks {
  bool isRestless = false;  ///< its reactions changed the motion
  bool isJammed = false;    ///< soft_answer.h
  /// Steps in a row that quarrelled (quarrels.h) and whose exact answer was not found, or not
  /// sought.
  int quarrelSteps = 0;
  int loadedSteps = 0;      ///< steps in a row that looked like a quarrel and were none
  int lostSteps = 0;        ///< steps in a row that ended out of budget
  double lostResidual = 0;  ///< m/s, that the last whole search of these steps left
  bool any() const {
    return isRestless || isJammed || quarrelSteps > 0 || loadedSteps > 0 || lostSteps > 0;
  }
  void add(const IslandMarks& other) {
    isRestless |= other.isRestless;
    isJammed |= other.isJammed;
    quarrelSteps = std::max(quarrelSteps, other.quarrelSteps);
    loadedSteps = std::max(loadedSteps, other.loadedSteps);
    if (other.lostSteps == 0) return;
    lostResidual = lostSteps == 0 ? other.lostResidual : std::min(lostResidual, other.lostResidual);
    lostSteps = std::max(lostSteps, other.lostSteps);
  }
  bool operator==(const IslandMarks& other) const {
    return isRestless == other.isRestless && isJammed == other.isJammed &&
           quarrelSteps == other.quarrelSteps && loadedSteps == other.loadedSteps &&
           lostSteps == other.lostSteps && lostResidual == other.lostResidual;
  }
};

constexpr int noDof = -1;

/// A row that an Extension has added.
struct MultiBodyRowSource {
  int row;  ///< among Group::rows
  btMultiBodyConstraint* constraint;
  int asked;     ///< among the rows that the constraints made
  int dof;       ///< the constraint's number of the row's impulse; noDof if it keeps none
  double guess;  ///< the impulse that the last step left there, N·s, or N·m·s about an axis
  double arc;    ///< arcs.h, m
};

/// A joint's answer for one row. An axis has four scalars, and the row this alignment, because some
/// joints write whole btVector3.
struct alignas(16) InfoRow {
  btScalar linearA[4], angularA[4], linearB[4], angularB[4];
  btScalar error, cfm, lower, upper;
};

/// A body that turns as if it had more inertia in this step (geometric_stiffness.h).
struct SlowedBody {
  int body;
  Mat3 ownInverseInertia;
};

/// One solveGroup call in the core's terms. The order follows Bullet's arrays, never addresses.
struct Group {
  double h = 0;              ///< the step, s
  std::vector<Body> bodies;  ///< dynamic and kinematic bodies; all others are the fixed world
  std::vector<BodySource> bodySources;
  std::vector<SlowedBody> slowed;  ///< in the order of their bodies

  std::vector<Contact> contacts;
  std::vector<PointSource> contactSources;
  std::vector<double> pushes;  ///< wanted normal push velocity of each contact, m/s (split impulse)
  std::vector<Vec3> guess;     ///< reaction of each contact to start from, N·s
  std::vector<PointSource> idle;  ///< points that were passed but take no part
  /// For each contact, the marks that the last step left on the island of its bodies; none if no
  /// body of it carries marks. Empty if no body carries any.
  std::vector<IslandMarks> marks;
  int bouncing = 0;  ///< contacts with restitution
  int turning = 0;   ///< contacts with rolling or spinning friction

  std::vector<Row> rows;            ///< of joints, then of an Extension, then of turning friction
  int turningRows = 0;              ///< how many of the last rows are turning friction
  int softRows = 0;                 ///< rows whose joint asks for a compliance
  std::vector<double> arcs;         ///< ℓ of each row (arcs.h); empty until these are set
  std::vector<double> rowGuess;     ///< reaction of each row to start from, N·s
  std::vector<JointSource> joints;  ///< enabled joints that have rows
  std::vector<btTypedConstraint*> obsolete;  ///< enabled constraints without rows in getInfo1

  Articulation articulation;                      ///< parts that an Extension has added
  std::vector<MultiBodyRowSource> multiBodyRows;  ///< the rows that an Extension has added

  AddressTable indexOf;
  JoinedBodies joined;
  JointLoops loops;
  OpposedContacts opposed;
  HeldContacts held;
  std::vector<InfoRow> asked;  ///< of the joint that is being gathered

  void clear();
  std::size_t bytes() const;
  bool movable(int body) const { return body >= 0 && bodies[body].movable(); }
  /// The radius of the arc along which a row is stated, m; 1 of rows along an axis.
  double arcOf(int row) const { return arcs.empty() ? 1 : arcs[row]; }
  const Mat3& ownInverseInertia(int body) const;
  bool isRigid(int body) const { return movable(body) && !isLimb(body); }
  bool isLimb(int body) const { return body >= 0 && !bodySources[body].rigid; }
};

/// The joint that has asked for this row; null if none has.
const JointSource* jointOf(const Group& group, int row);

}  // namespace delassus::bullet
