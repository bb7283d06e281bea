#include "bullet_ext/joint_load.h"

#include <Eigen/Cholesky>
#include <cmath>

#include "BulletDynamics/Dynamics/btRigidBody.h"

namespace delassus::bullet {
namespace {

/// J of a joint's row for the body that is loaded.
const Row6& jacobianOf(const Row& row, bool isOnA) { return isOnA ? row.jacobianA : row.jacobianB; }

Vec6 wrenchOf(const Group& group, const JointSource& joint, const double* reactions, bool isOnA) {
  Vec6 sum = Vec6::Zero();
  for (int i = 0; i < joint.rowCount; ++i)
    sum += reactions[i] * jacobianOf(group.rows[joint.firstRow + i], isOnA).transpose();
  return sum;
}

/// The diagonal of S, by which forces and moments of the body are compared.
Vec6 scaleOf(const Group& group, const JointSource& joint, bool isOnA) {
  const Row& row = group.rows[joint.firstRow];
  const btRigidBody& body = *group.bodySources[isOnA ? row.a : row.b].rigid;
  const btMatrix3x3& inertia = body.getInvInertiaTensorWorld();
  const double turning = static_cast<double>(inertia[0][0]) + inertia[1][1] + inertia[2][2];
  Vec6 scale;
  scale.head<3>().setConstant(std::sqrt(body.getInvMass()));
  scale.tail<3>().setConstant(std::sqrt(turning / 3));
  return scale;
}

/// The body that is told the load: the joint's first one, if it moves.
bool loadsA(const Group& group, const JointSource& joint) {
  return group.movable(group.rows[joint.firstRow].a);
}

}  // namespace

JointLoad loadOf(const Group& group, const JointSource& joint,
                 const std::vector<double>& reactions) {
  if (joint.rowCount == 0) return {};
  const bool onA = loadsA(group, joint);
  return {wrenchOf(group, joint, reactions.data() + joint.firstRow, onA), onA};
}

bool makesLoad(const Group& group, const JointSource& joint, const double* reactions,
               const JointLoad& load) {
  constexpr double nearly = 0.1;
  if (joint.rowCount == 0 || load.isOnA != loadsA(group, joint)) return false;
  const Vec6 scale = scaleOf(group, joint, load.isOnA);
  const Vec6 missed = wrenchOf(group, joint, reactions, load.isOnA) - load.wrench;
  return missed.cwiseProduct(scale).squaredNorm() <=
         nearly * nearly * load.wrench.cwiseProduct(scale).squaredNorm();
}

void takeLoad(const Group& group, const JointSource& joint, const JointLoad& load,
              double* reactions) {
  constexpr double rounding = 1e-9;  // ε
  for (int i = 0; i < joint.rowCount; ++i) reactions[i] = 0;
  if (joint.rowCount == 0 || load.isOnA != loadsA(group, joint)) return;
  const Vec6 scale = scaleOf(group, joint, load.isOnA);
  const auto scaled = [&](int i) -> Vec6 {
    return jacobianOf(group.rows[joint.firstRow + i], load.isOnA).transpose().cwiseProduct(scale);
  };
  // With each row divided by its length, r = J̃ (J̃ᵀ J̃ + ε)⁻¹ f̃.
  Mat6 K = rounding * Mat6::Identity();
  for (int i = 0; i < joint.rowCount; ++i) {
    const Vec6 J = scaled(i);
    if (const double length = J.squaredNorm(); length > 0) K += J / length * J.transpose();
  }
  const Vec6 y = K.llt().solve(load.wrench.cwiseProduct(scale));
  for (int i = 0; i < joint.rowCount; ++i) {
    const Vec6 J = scaled(i);
    if (const double length = J.squaredNorm(); length > 0) reactions[i] = J.dot(y) / length;
  }
}

}  // namespace delassus::bullet
