#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "LinearMath/btScalar.h"
#include "bullet_ext/address_table.h"
#include "bullet_ext/contact_event.h"
#include "bullet_ext/held_contacts.h"
#include "bullet_ext/joined_bodies.h"
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

/// Stands where a body index is expected for a body that is not fit to take part.
constexpr int leftOut = -2;

/// Numbers beyond this (kg, 1/kg, m, s, N) are mistakes: squares of their products, or the answers
/// in Bullet's precision, would overflow. A mass beyond is Bullet's "infinity".
constexpr double largestNumber = sizeof(btScalar) == sizeof(double) ? 1e40 : 1e30;

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
  bool isSoft = false;     ///< asks for a compliance of its own
  /// What its rows pushed its bodies with in the last step, in world axes, N·s; for
  /// GeometricStiffness alone. Last reactions do not tell: Bullet turns the rows of a hinge about.
  Vec3 lastPullOnA = Vec3::Zero(), lastPullOnB = Vec3::Zero();
};

/// What one step leaves to the next to know of an island.
struct IslandMarks {
  bool isRestless = false;  ///< its reactions changed the motion
  bool isJammed = false;    ///< soft_answer.h
  int lostSteps = 0;        ///< in a row, that ended out of budget
  double lost = 0;          ///< residual, m/s, that the last whole search of these was left with
  bool any() const { return isRestless || isJammed || lostSteps > 0; }
  void add(const IslandMarks& other) {
    isRestless |= other.isRestless;
    isJammed |= other.isJammed;
    if (other.lostSteps == 0) return;
    lost = lostSteps == 0 ? other.lost : std::min(lost, other.lost);
    lostSteps = std::max(lostSteps, other.lostSteps);
  }
  bool operator==(const IslandMarks& other) const {
    return isRestless == other.isRestless && isJammed == other.isJammed &&
           lostSteps == other.lostSteps && lost == other.lost;
  }
};

constexpr int noDof = -1;

/// A row that an Extension has added.
struct MultiBodyRowSource {
  int row;  ///< among Group::rows
  btMultiBodyConstraint* constraint;
  int asked;     ///< among the rows that the constraints made
  int dof;       ///< the constraint's own number of it; noDof if it keeps no impulse of it
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
  /// What is known of the island in which the bodies of each contact were in the last step, if the
  /// contact is one by which it is known again; empty if nothing is.
  std::vector<IslandMarks> marks;
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
  JointLoops loops;
  OpposedContacts opposed;
  HeldContacts held;
  std::vector<InfoRow> asked;  ///< of the joint that is being gathered

  void clear();
  std::size_t bytes() const;
  bool movable(int body) const { return body >= 0 && bodies[body].movable(); }
  bool isLimb(int body) const { return body >= 0 && !bodySources[body].rigid; }
};

}  // namespace delassus::bullet
