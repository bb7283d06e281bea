#pragma once
/// Watches while a world is solved, and checks the laws of every group. It uses the velocities and
/// impulses that were written, whatever the solver says of itself.

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>
#include <set>
#include <string>

#include "BulletCollision/NarrowPhaseCollision/btPersistentManifold.h"
#include "bullet_ext/convert.h"
#include "bullet_ext/gather.h"
#include "delassus/cone.h"
#include "demos/scenes/watched_joints.h"
#include "tests/fuzz/random_world.h"

namespace delassus::test {

class WatchingSolver : public btConstraintSolver {
 public:
  WatchingSolver(btDelassusConstraintSolver& inner, const WorldTraits& traits)
      : inner_(inner), traits_(traits) {}

  /// The broken laws, one line each; empty if there are none.
  const std::set<std::string>& faults() const { return faults_; }

  void prepareSolve(int bodies, int manifolds) override { inner_.prepareSolve(bodies, manifolds); }
  void allSolved(const btContactSolverInfo& info, btIDebugDraw* drawer) override {
    inner_.allSolved(info, drawer);
  }
  void reset() override { inner_.reset(); }
  btConstraintSolverType getSolverType() const override { return inner_.getSolverType(); }

  btScalar solveGroup(btCollisionObject** bodies, int bodyCount, btPersistentManifold** manifolds,
                      int manifoldCount, btTypedConstraint** joints, int jointCount,
                      const btContactSolverInfo& info, btIDebugDraw* drawer,
                      btDispatcher* dispatcher) override {
    {
      const demos::WatchedJoints watched(joints, jointCount);
      StepReport ignored;
      bullet::gatherGroup(
          group_,
          {bodies, bodyCount, manifolds, manifoldCount, joints, jointCount, &info, dispatcher},
          ignored, nullptr, {false, true});
    }
    const int islands = inner_.report().islands;
    inner_.solveGroup(bodies, bodyCount, manifolds, manifoldCount, joints, jointCount, info, drawer,
                      dispatcher);
    if (inner_.report().nonFinite > 0) faults_.insert("an island is called non-finite");
    if (inner_.report().islands < islands) faults_.insert("islands are lost");
    readBack(joints, jointCount);
    askContacts();
    if (jointCount == 0 && !traits_.lockedAxes) {
      askMomentum();
      askEnergy();
    }
    return 0;
  }

 private:
  static constexpr double rounding = 256 * SIMD_EPSILON;

  void readBack(btTypedConstraint** joints, int jointCount) {
    after_.clear();
    pulls_.clear();
    for (std::size_t i = 0; i < group_.bodies.size(); ++i) {
      const btRigidBody& rigid = *group_.bodySources[i].rigid;
      pulls_.push_back(0);
      for (int k = 0; k < jointCount; ++k)
        if (&joints[k]->getRigidBodyA() == &rigid || &joints[k]->getRigidBodyB() == &rigid)
          pulls_.back() = std::max(pulls_.back(), std::abs(double(joints[k]->getAppliedImpulse())));
      after_.push_back(bullet::toCore(rigid.getLinearVelocity(), rigid.getAngularVelocity()));
      if (!after_.back().allFinite()) faults_.insert("a velocity is not finite");
    }
    reactions_.clear();
    for (const bullet::PointSource& source : group_.contactSources) {
      const btManifoldPoint& point = source.manifold->getContactPoint(source.point);
      reactions_.push_back(
          {point.m_appliedImpulse, point.m_appliedImpulseLateral1, point.m_appliedImpulseLateral2});
      if (!reactions_.back().allFinite()) faults_.insert("an impulse is not finite");
    }
  }

  double pullOn(int body) const { return body < 0 ? 0 : pulls_[std::size_t(body)]; }
  Vec3 pointVelocity(int body, const Vec3& arm) const {
    if (body < 0) return Vec3::Zero();
    return after_[body].head<3>() + after_[body].tail<3>().cross(arm);
  }
  double pointSpeed(int body, const Vec3& arm) const {
    if (body < 0) return 0;
    const Vec6& free = group_.bodies[body].velocity;
    return after_[body].head<3>().norm() + after_[body].tail<3>().norm() * arm.norm() +
           free.head<3>().norm() + free.tail<3>().norm() * arm.norm();
  }
  Mat3 response(int body, const Vec3& arm) const {
    if (!group_.movable(body)) return Mat3::Zero();
    Mat3 cross;
    cross << 0, -arm[2], arm[1], arm[2], 0, -arm[0], -arm[1], arm[0], 0;
    return Mat3(group_.bodies[body].inverseMass.asDiagonal()) -
           cross * group_.bodies[body].inverseInertia * cross;
  }

  /// Reactions are in their cones, and each contact keeps its law as well as the report says.
  void askContacts() {
    const StepReport& report = inner_.report();
    const double said = report.residualMax, largest = largestReaction();
    // The walk leaves round-off of the largest reactions, also of joints, in reactions that carry
    // nothing. The compromise between incompatible demands leaves more.
    const double digits = report.solved == report.islands ? 1e-12 : 1e-10;
    const double noise = std::max(digits, rounding) * std::max(largest, largestMomentum());
    for (std::size_t i = 0; i < group_.contacts.size(); ++i) {
      const Contact& c = group_.contacts[i];
      const Vec3& r = reactions_[i];
      const double t = std::hypot(r[1], r[2]);
      if (r[0] < -noise || t > c.friction * r[0] + noise)
        faults_.insert("a reaction is outside its cone");

      Mat3 W = c.frame.transpose() * (response(c.a, c.armA) + response(c.b, c.armB)) * c.frame;
      W.diagonal() += Vec3(c.compliance, c.slipCompliance, c.slipCompliance);
      const double size = c.friction > 0 ? spectralNorm(W) : W(0, 0);
      if (!(size > 0)) continue;
      Vec3 u = c.frame.transpose() * (pointVelocity(c.a, c.armA) - pointVelocity(c.b, c.armB)) -
               c.target;
      u += Vec3(c.compliance, c.slipCompliance, c.slipCompliance).cwiseProduct(r);
      if (c.friction == 0) u.tail<2>().setZero();  // no law holds for them
      const Vec3 v = correctedVelocity(u, c.friction);
      const double residual = size * (r - projectOnCone(r - v / size, c.friction)).norm();
      const double speed = pointSpeed(c.a, c.armA) + pointSpeed(c.b, c.armB) + c.target.norm();
      // Joints that contradict each other pull at a body with far more than moves it. Along locked
      // axes they pull without end and without effect, so the rounding of an infinite inertia
      // counts.
      const double pull = std::max(pullOn(c.a), pullOn(c.b));
      const double slack = rounding * (1 + c.friction) * (speed + size * std::max(largest, pull));
      // A compromise is judged with the inertia that geometric stiffness gives.
      const bool isJudgedOtherwise = report.stiffened > 0 && report.incompatible > 0;
      if (!(residual <= 1.01 * said + slack) && !(traits_.lockedAxes && pull > 0) &&
          !isJudgedOtherwise)
        faults_.insert("a contact is further from its law than the report says");
    }
  }

  static double spectralNorm(const Mat3& W) {
    const Eigen::SelfAdjointEigenSolver<Mat3> eigen(W, Eigen::EigenvaluesOnly);
    return eigen.eigenvalues().cwiseAbs().maxCoeff();
  }

  double largestMomentum() const {
    double largest = 0;
    for (const Body& body : group_.bodies)
      if (body.inverseMass[0] > 0)
        largest = std::max(largest, body.velocity.head<3>().norm() / body.inverseMass[0]);
    return largest;
  }

  double largestReaction() const {
    double largest = 0;
    for (const Vec3& r : reactions_) largest = std::max(largest, r.cwiseAbs().maxCoeff());
    return largest;
  }

  /// Σ m (v − v_f) is the impulse that the immovable world gives.
  void askMomentum() {
    Vec3 gain = Vec3::Zero(), given = Vec3::Zero();
    double scale = 0;
    for (std::size_t i = 0; i < after_.size(); ++i) {
      if (!group_.movable(int(i))) continue;
      const double mass = 1 / group_.bodies[i].inverseMass[0];
      const Vec3 v = after_[i].head<3>(), free = group_.bodies[i].velocity.head<3>();
      gain += mass * (v - free);
      scale += mass * (v.norm() + free.norm());
    }
    for (std::size_t i = 0; i < group_.contacts.size(); ++i) {
      const Contact& c = group_.contacts[i];
      const Vec3 onA = c.frame * reactions_[i];
      if (!group_.movable(c.b)) given += onA;
      if (!group_.movable(c.a)) given -= onA;
      scale += reactions_[i].norm();
    }
    if (!((gain - given).norm() <= rounding * scale)) faults_.insert("momentum is not conserved");
  }

  /// E(v) − E(v_f) ≤ Σ r·target: reactions feed in only what was asked for (algorithms 9.5). Bodies
  /// that do not move by themselves, and driven (kinematic) ones, do work too.
  void askEnergy() {
    double gain = 0, fed = 0, scale = 0;
    for (std::size_t i = 0; i < after_.size(); ++i) {
      if (!group_.movable(int(i))) {
        if (group_.bodies[i].velocity.any()) return;
        continue;
      }
      const Body& body = group_.bodies[i];
      const btVector3& turns = group_.bodySources[i].rigid->getInvInertiaDiagLocal();
      if (!(turns[turns.minAxis()] > 1e-9 * turns[turns.maxAxis()])) return;  // as good as locked
      const Mat3 inertia = body.inverseInertia.inverse();
      const auto energy = [&](const Vec6& v) {
        const Vec3 linear = v.head<3>(), angular = v.tail<3>();
        return linear.squaredNorm() / body.inverseMass[0] / 2 + angular.dot(inertia * angular) / 2;
      };
      gain += energy(after_[i]) - energy(body.velocity);
      scale += energy(after_[i]) + energy(body.velocity);
    }
    for (std::size_t i = 0; i < group_.contacts.size(); ++i) {
      const Contact& c = group_.contacts[i];
      fed += reactions_[i].dot(c.target);
      scale += std::abs(reactions_[i].dot(c.target));
      scale += reactions_[i].norm() * (pointSpeed(c.a, c.armA) + pointSpeed(c.b, c.armB));
      // The energy that an inexact answer may add.
      fed += 2 * (1 + c.friction) * reactions_[i].norm() * inner_.report().residualMax;
    }
    if (!(gain <= fed + rounding * scale)) faults_.insert("energy is gained");
  }

  btDelassusConstraintSolver& inner_;
  const WorldTraits& traits_;
  bullet::Group group_;
  std::vector<Vec6> after_;
  std::vector<Vec3> reactions_;
  std::vector<double> pulls_;  ///< the largest impulse of a joint on each body
  std::set<std::string> faults_;
};

}  // namespace delassus::test
