#include "demos/scenes/judge.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <utility>

#include "bullet_ext/convert.h"
#include "delassus/island.h"
#include "delassus/residual.h"
#include "demos/scenes/measures.h"
#include "demos/scenes/statistics.h"
#include "demos/scenes/watched_joints.h"

namespace demos {

using namespace delassus;
using delassus::bullet::toCore;

namespace {

/// The reaction that the solver wrote at a contact point, in the contact's frame, N·s.
Vec3 inFrame(const Contact& contact, const btManifoldPoint& point) {
  Vec3 r = contact.frame.transpose() * toCore(writtenReaction(point));
  r[0] = point.m_appliedImpulse;
  return r;
}

/// The x of least norm that brings A x closest to b.
VectorXd leastNorm(const MatrixXd& A, const VectorXd& b) {
  return A.completeOrthogonalDecomposition().solve(b);
}

}  // namespace

double StepResidual::rms() const { return count > 0 ? std::sqrt(sumOfSquares / double(count)) : 0; }

StepResidual JudgedSolver::takeResidual() { return std::exchange(residual_, {}); }

void JudgedSolver::beforeGroup(const GroupInput& arguments) {
  btContactSolverInfo info = *arguments.info;
  info.m_globalCfm = cfm_;
  GroupInput judged = arguments;
  judged.info = &info;
  StepReport ignored;
  const WatchedJoints watched(arguments.constraints, arguments.constraintCount);
  bullet::gatherGroup(group_, judged, ignored);
  lendFeedback(arguments);
}

void JudgedSolver::afterGroup(const GroupInput& arguments) {
  const std::vector<double> rows = rowReactions(arguments.info->m_timeStep);
  takeFeedbackBack();

  const auto written = [&](int contact) {
    const auto& source = group_.contactSources[contact];
    return inFrame(group_.contacts[contact], source.manifold->getContactPoint(source.point));
  };
  for (const Island& island : splitIslands(group_.bodies, group_.contacts, group_.rows)) {
    const Problem problem = assemble(group_.bodies, group_.contacts, group_.rows, island);
    VectorXd r(problem.size());
    island.eachContactAt(
        [&](int i, int at, int unknowns) { r.segment(at, unknowns) = written(i).head(unknowns); });
    island.eachRowAt([&](int i, int at) { r[at] = rows[i]; });
    if (!problem.disks.empty()) addTurning(island, problem, r);

    const VelocityResidual residual = naturalResidual(problem, r);
    const long count = problem.contacts() + problem.rows();
    residual_.max = largerOf(residual_.max, residual.max);
    residual_.sumOfSquares += residual.rms * residual.rms * double(count);
    residual_.count += count;
  }
}

/// Adds the reactions of the disks: they bring the rotations from what the other reactions `r`
/// leave to what the bodies have now. Where several disks share the work, each takes part in
/// proportion to its radius κ r_n, as far as possible: Σ (‖r_d‖ / κ r_n)² is least.
void JudgedSolver::addTurning(const Island& island, const Problem& problem, VectorXd& r) const {
  std::vector<Body> after = group_.bodies;
  for (const int i : island.bodies) {
    const btRigidBody& rigid = *group_.bodySources[i].rigid;
    after[i].velocity = toCore(rigid.getLinearVelocity(), rigid.getAngularVelocity());
  }
  const int begin = problem.disksBegin(), count = problem.size() - begin;
  const VectorXd missing =
      (assemble(after, group_.contacts, group_.rows, island).q - problem.q - problem.W * r)
          .tail(count);
  VectorXd radius(count);
  for (const Disk& disk : problem.disks)
    radius.segment(disk.first - begin, disk.unknowns).setConstant(disk.radiusAt(r));
  // A solver that does not know better may let an unloaded contact turn bodies, too: then it shows
  // as an error.
  constexpr double unloaded = 1e-6;
  const double largest = radius.maxCoeff();
  radius = largest > 0 ? VectorXd(radius.cwiseMax(unloaded * largest)) : VectorXd::Ones(count);
  const MatrixXd W = problem.W.dense().bottomRightCorner(count, count);
  r.tail(count) = radius.cwiseProduct(leastNorm(W * radius.asDiagonal(), missing));
}

void JudgedSolver::lendFeedback(const GroupInput& arguments) {
  lent_.clear();
  lent_.resize(std::size_t(arguments.constraintCount));
  borrowers_.clear();
  for (int i = 0; i < arguments.constraintCount; ++i) {
    btTypedConstraint* joint = arguments.constraints[i];
    if (joint->getJointFeedback() != nullptr) continue;
    joint->setJointFeedback(&lent_[i]);
    borrowers_.push_back(joint);
  }
}

void JudgedSolver::takeFeedbackBack() {
  for (btTypedConstraint* joint : borrowers_) joint->setJointFeedback(nullptr);
}

std::vector<double> JudgedSolver::rowReactions(double timeStep) const {
  std::vector<double> reactions(group_.rows.size(), 0);
  for (const auto& joint : group_.joints) {
    // The feedback is Σ Jᵀ r / h on either body, with the locked axes of the body left out.
    const btJointFeedback& feedback = *joint.constraint->getJointFeedback();
    Eigen::Matrix<double, 12, 1> impulse;
    impulse << toCore(feedback.m_appliedForceBodyA, feedback.m_appliedTorqueBodyA),
        toCore(feedback.m_appliedForceBodyB, feedback.m_appliedTorqueBodyB);
    Eigen::Matrix<double, 12, 1> factor;
    const btRigidBody &a = joint.constraint->getRigidBodyA(),
                      &b = joint.constraint->getRigidBodyB();
    factor << toCore(a.getLinearFactor(), a.getAngularFactor()),
        toCore(b.getLinearFactor(), b.getAngularFactor());

    MatrixXd directions(12, joint.rowCount);
    for (int i = 0; i < joint.rowCount; ++i) {
      const Row& row = group_.rows[joint.firstRow + i];
      directions.col(i) << row.jacobianA.transpose(), row.jacobianB.transpose();
    }
    const VectorXd r = leastNorm(factor.asDiagonal() * directions, impulse * timeStep);
    std::copy(r.begin(), r.end(), reactions.begin() + joint.firstRow);
  }
  return reactions;
}

}  // namespace demos
