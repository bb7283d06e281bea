#pragma once

#include <cstddef>

#include "BulletDynamics/Featherstone/btMultiBodyConstraint.h"
#include "delassus/articulation.h"
#include "delassus/kept_list.h"
#include "delassus/types.h"

class btMultiBodyLinkCollider;

namespace delassus {
struct StepReport;
}

namespace delassus::bullet {

struct Answer;
struct Group;
struct GroupInput;

/// The articulated bodies of a group.
///
/// A btMultiBody is a tree. Its velocities are those of its base (angular, linear) and of its
/// joints, with the forces of the step included. M⁻¹ is read from Bullet's articulated-body
/// algorithm, one unit force at a time. Links that touch something are the tree's limbs.
class MultiBodyTrees {
 public:
  struct TreeSource {
    btMultiBody* body;
    int tree;  ///< in the articulation, or leftOut
    int stem;  ///< the body that stands for the tree
    MatrixXd inverseMass;
    RootFinder root;
  };

  /// Bullet uses the scratch space of `data`, which outlives this.
  explicit MultiBodyTrees(btMultiBodyJacobianData& data) : data_(data) {}

  /// Adds the links that touch something. The links of a tree that is not finite are left out, and
  /// the report names them.
  void gather(Group& group, const GroupInput& input, StepReport& report);
  /// The source of the body's tree, which joins the group if it is new; good until the next call.
  const TreeSource& treeOf(Group& group, btMultiBody& body);

  /// Adds to the links the forces of contacts and turning friction over a time step, s, for joint
  /// feedback.
  void writeForces(const Group& group, const Answer& answer, double timeStep) const;
  /// Adds the velocity changes that the reactions caused.
  void writeGains(const TreeGains& gains);

  void release();
  std::size_t bytes() const;

 private:
  struct LimbSource {
    btMultiBody* body;
    int link;    ///< −1 for the base
    Matrix6X L;  ///< velocity of the limb = L v
  };

  int addTree(Group& group, TreeSource& source);
  void findInverseMass(const btMultiBody& body, MatrixXd& inverseMass);
  static int addLimb(Group& group, int tree, const LimbSource& source);
  void addLink(Group& group, const btMultiBodyLinkCollider& collider, StepReport& report);
  void findMotion(const btMultiBodyLinkCollider& collider, Matrix6X& L);

  btMultiBodyJacobianData& data_;
  KeptList<TreeSource> trees_;
  KeptList<LimbSource> limbs_;  ///< in the articulation's order; stems have no body
  btAlignedObjectArray<btScalar> unit_, response_;
};

/// The object as a link of an articulated body. Null if it is none, or if its body is gone; then it
/// is ground.
const btMultiBodyLinkCollider* linkOf(const btCollisionObject* object);

/// Adds a force and a torque on a link (−1: the base), N and N·m in world axes, for joint feedback.
void addForce(btMultiBody& body, int link, const btVector3& force, const btVector3& torque);

}  // namespace delassus::bullet
