#include "bullet_ext/joint_load.h"

#include <Eigen/Cholesky>
#include <cmath>

#include "BulletDynamics/Dynamics/btRigidBody.h"
#include "bullet_ext/convert.h"
#include "bullet_ext/group.h"

namespace delassus::bullet {
namespace {

/// One of a joint's bodies: the first one that moves.
struct Side {
  Row6 Row::*jacobian;
  Vec6 JointLoad::*load;
  Vec6 scale;  ///< the diagonal of S, by which impulses and moments are compared
};

Side sideOf(const Group& group, const JointSource& joint) {
  const Row& row = group.rows[joint.firstRow];
  const bool isA = group.movable(row.a);
  const btRigidBody& body = *group.bodySources[isA ? row.a : row.b].rigid;
  const double turning = toCore(body.getInvInertiaTensorWorld()).trace() / 3;
  Vec6 scale;
  scale << Vec3::Constant(std::sqrt(body.getInvMass())), Vec3::Constant(std::sqrt(turning));
  return {isA ? &Row::jacobianA : &Row::jacobianB, isA ? &JointLoad::onA : &JointLoad::onB, scale};
}

/// A row of J̃ = J S.
Vec6 scaledRow(const Group& group, const JointSource& joint, int i, const Side& side) {
  return (group.rows[joint.firstRow + i].*side.jacobian).transpose().cwiseProduct(side.scale);
}

}  // namespace

JointLoad loadOf(const Group& group, const JointSource& joint,
                 const std::vector<double>& reactions) {
  JointLoad load;
  for (int i = joint.firstRow; i < joint.firstRow + joint.rowCount; ++i) {
    load.onA += reactions[i] * group.rows[i].jacobianA.transpose();
    load.onB += reactions[i] * group.rows[i].jacobianB.transpose();
  }
  return load;
}

bool makesLoad(const Group& group, const JointSource& joint, const double* reactions,
               const JointLoad& load) {
  constexpr double nearly = 0.1;
  if (joint.rowCount == 0) return true;
  const Side side = sideOf(group, joint);
  Vec6 missed = -(load.*side.load).cwiseProduct(side.scale);
  double squares = 0;  // rows may push against each other, and make no load
  for (int i = 0; i < joint.rowCount; ++i) {
    const Vec6 push = reactions[i] * scaledRow(group, joint, i, side);
    missed += push;
    squares += push.squaredNorm();
  }
  return missed.squaredNorm() <= nearly * nearly * squares;
}

void takeLoad(const Group& group, const JointSource& joint, const JointLoad& load,
              double* reactions) {
  constexpr double rounding = 1e-9;  // ε
  if (joint.rowCount == 0) return;
  const Side side = sideOf(group, joint);
  const auto scaled = [&](int i) { return scaledRow(group, joint, i, side); };
  // With each row divided by its length, r = J̃ (J̃ᵀ J̃ + ε)⁻¹ f̃.
  Mat6 K = rounding * Mat6::Identity();
  for (int i = 0; i < joint.rowCount; ++i) {
    const Vec6 J = scaled(i);
    if (const double length = J.squaredNorm(); length > 0) K += J / length * J.transpose();
  }
  const Vec6 y = K.llt().solve((load.*side.load).cwiseProduct(side.scale));
  for (int i = 0; i < joint.rowCount; ++i) {
    const Vec6 J = scaled(i);
    const double length = J.squaredNorm();
    reactions[i] = length > 0 ? J.dot(y) / length : 0;
  }
}

}  // namespace delassus::bullet
