#include "demos/report/captured_step.h"

#include <cstdint>

namespace demos::report {

namespace {

template <class Visit>
void forEachPoint(const CapturedStep& step, const Visit& visit) {
  for (const CapturedStep::Group& group : step.groups)
    for (btPersistentManifold* manifold : group.manifolds)
      for (int i = 0; i < manifold->getNumContacts(); ++i) visit(manifold->getContactPoint(i));
}

}  // namespace

delassus::bullet::GroupInput CapturedStep::Group::input(const btContactSolverInfo& info,
                                                        btDispatcher* dispatcher) const {
  // Bullet's arrays are not const, though solvers do not change them.
  auto& open = const_cast<Group&>(*this);
  return {open.bodies.data(),
          int(bodies.size()),
          open.manifolds.data(),
          int(manifolds.size()),
          open.constraints.data(),
          int(constraints.size()),
          &info,
          dispatcher};
}

void CapturedStep::solve(btConstraintSolver& solver, const btContactSolverInfo& settings) const {
  for (const Group& group : groups) {
    const auto input = group.input(settings, dispatcher);
    solver.solveGroup(input.bodies, input.bodyCount, input.manifolds, input.manifoldCount,
                      input.constraints, input.constraintCount, settings, nullptr, dispatcher);
  }
}

void StepCapture::prepareSolve(int bodyCount, int manifoldCount) {
  step_.groups.clear();
  inner_.prepareSolve(bodyCount, manifoldCount);
}

btScalar StepCapture::solveGroup(btCollisionObject** bodies, int bodyCount,
                                 btPersistentManifold** manifolds, int manifoldCount,
                                 btTypedConstraint** constraints, int constraintCount,
                                 const btContactSolverInfo&, btIDebugDraw*,
                                 btDispatcher* dispatcher) {
  step_.dispatcher = dispatcher;
  step_.groups.push_back({{bodies, bodies + bodyCount},
                          {manifolds, manifolds + manifoldCount},
                          {constraints, constraints + constraintCount}});
  return 0;
}

void StepCapture::allSolved(const btContactSolverInfo& info, btIDebugDraw* debugDrawer) {
  step_.info = &info;
  if (beforeSolve) beforeSolve(step_);
  step_.solve(inner_, info);
  if (afterSolve) afterSolve(step_);
  inner_.allSolved(info, debugDrawer);
}

SavedState::SavedState(const CapturedStep& step) {
  for (const CapturedStep::Group& group : step.groups) {
    for (btCollisionObject* object : group.bodies)
      if (btRigidBody* body = btRigidBody::upcast(object))
        bodies_.push_back({body, body->getWorldTransform(), body->getLinearVelocity(),
                           body->getAngularVelocity()});
    for (btTypedConstraint* joint : group.constraints) {
      const btJointFeedback* feedback = joint->getJointFeedback();
      joints_.push_back({joint, joint->isEnabled(), joint->internalGetAppliedImpulse(),
                         feedback != nullptr ? *feedback : btJointFeedback{}});
    }
  }
  forEachPoint(step, [this](btManifoldPoint& point) { points_.push_back({&point, point}); });
}

void SavedState::restore() const {
  for (const BodyState& state : bodies_) {
    state.body->setWorldTransform(state.pose);
    state.body->setLinearVelocity(state.linear);
    state.body->setAngularVelocity(state.angular);
  }
  for (const JointState& state : joints_) {
    state.joint->setEnabled(state.enabled);
    state.joint->internalSetAppliedImpulse(state.impulse);
    if (btJointFeedback* feedback = state.joint->getJointFeedback()) *feedback = state.feedback;
  }
  for (const PointState& state : points_) *state.place = state.point;
}

StepMemory readMemory(const CapturedStep& step) {
  StepMemory memory;
  forEachPoint(step, [&memory](const btManifoldPoint& point) {
    memory.push_back({point.m_appliedImpulse, point.m_appliedImpulseLateral1,
                      point.m_appliedImpulseLateral2, point.m_prevRHS, point.m_lateralFrictionDir1,
                      point.m_lateralFrictionDir2});
  });
  return memory;
}

void writeMemory(const CapturedStep& step, const StepMemory& memory) {
  auto next = memory.begin();
  forEachPoint(step, [&next](btManifoldPoint& point) {
    const PointMemory& known = *next++;
    point.m_appliedImpulse = known.normal;
    point.m_appliedImpulseLateral1 = known.lateral1;
    point.m_appliedImpulseLateral2 = known.lateral2;
    point.m_prevRHS = known.mode;
    point.m_lateralFrictionDir1 = known.direction1;
    point.m_lateralFrictionDir2 = known.direction2;
  });
}

// The number is kept in the point's user data, which Bullet carries along when it moves or updates
// a point, and clears in a new one. None of our scenes uses that.
void numberPoints(const CapturedStep& step) {
  std::intptr_t next = 0;
  forEachPoint(step, [&next](btManifoldPoint& point) {
    point.m_userPersistentData = reinterpret_cast<void*>(++next);
  });
}

std::vector<int> earlierNumbers(const CapturedStep& step) {
  std::vector<int> numbers;
  forEachPoint(step, [&numbers](const btManifoldPoint& point) {
    numbers.push_back(int(reinterpret_cast<std::intptr_t>(point.m_userPersistentData)) - 1);
  });
  return numbers;
}

StepMemory carried(const StepMemory& before, const std::vector<int>& earlier) {
  StepMemory memory;
  for (const int number : earlier)
    memory.push_back(number >= 0 && number < int(before.size()) ? before[std::size_t(number)]
                                                                : PointMemory{});
  return memory;
}

}  // namespace demos::report
