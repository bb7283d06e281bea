#include "demos/report/step_problem.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "bullet_ext/convert.h"
#include "delassus/island.h"
#include "delassus/solver.h"
#include "demos/report/refined_answer.h"
#include "demos/scenes/watched_joints.h"

namespace demos::report {

using namespace delassus;

namespace {

/// 1/x, and zero for an axis that is locked.
double inverse(double x, double largest) { return x > 1e-12 * largest ? 1 / x : 0; }

/// √m along the world axes, √I along the principal ones.
Vec6 rootMass(const Body& body, const Vec3& inverseInertia) {
  Vec6 root;
  for (int i = 0; i < 3; ++i) {
    root[i] = std::sqrt(inverse(body.inverseMass[i], body.inverseMass.maxCoeff()));
    root[3 + i] = std::sqrt(inverse(inverseInertia[i], inverseInertia.maxCoeff()));
  }
  return root;
}

Vec3 velocityAt(const Motion& motion, int body, const Vec3& arm) {
  if (body < 0) return Vec3::Zero();
  const Vec6& v = motion[std::size_t(body)];
  return v.head<3>() + v.tail<3>().cross(arm);
}

Mode modeOf(const Contact& contact, const Motion& motion) {
  constexpr double standstill = 1e-3;  // m/s
  const Vec3 u = contact.frame.transpose() * (velocityAt(motion, contact.a, contact.armA) -
                                              velocityAt(motion, contact.b, contact.armB)) -
                 contact.target;
  if (u[0] > standstill) return Mode::Open;
  const bool slides = contact.friction == 0 || std::hypot(u[1], u[2]) > standstill;
  return slides ? Mode::Slide : Mode::Stick;
}

/// Replaces the motion that `reactions` cause in an island by the refined one. Returns false if
/// there is none.
bool moveRefined(std::vector<Body>& bodies, const bullet::Group& group, const Island& island,
                 const VectorXd& reactions, int mostRefined) {
  const auto turns = [&](int row) { return group.rows[std::size_t(row)].governor >= 0; };
  if (island.unknowns() > mostRefined ||
      std::any_of(island.rows.begin(), island.rows.end(), turns) || !reactions.allFinite())
    return false;
  const RefinedAnswer answer = refine(group.bodies, group.contacts, group.rows, island, reactions);
  if (!answer.certified()) return false;
  for (std::size_t i = 0; i < island.bodies.size(); ++i)
    bodies[std::size_t(island.bodies[i])].velocity = answer.motion.segment<6>(6 * int(i));
  return true;
}

/// The result of one solve of all groups.
struct TightAnswer {
  double residual = 0, unsolved = 0, unrefined = 0;  ///< the last two: islands
  Motion motion;

  std::vector<double> numbers() const {
    std::vector<double> all{residual, unsolved, unrefined};
    for (const Vec6& velocity : motion) all.insert(all.end(), velocity.begin(), velocity.end());
    return all;
  }
  static TightAnswer from(const std::vector<double>& numbers) {
    TightAnswer answer{numbers[0], numbers[1], numbers[2], {}};
    for (std::size_t at = 3; at + 6 <= numbers.size(); at += 6)
      answer.motion.push_back(Eigen::Map<const Vec6>(&numbers[at]));
    return answer;
  }
  bool betterThan(const TightAnswer& other) const {
    const bool refined = unrefined == 0, otherRefined = other.unrefined == 0;
    return refined != otherRefined ? refined : residual < other.residual;
  }
};

TightAnswer solveTightly(const StepProblem& problem, bool fromStoredImpulses, int mostRefined) {
  Options options;
  options.tolerance = 1e-12;
  options.newtonBudget *= 5;
  options.sweepBudget *= 5;
  Solver solver(options);
  TightAnswer answer;
  for (const bullet::Group& group : problem.groups()) {
    std::vector<Body> bodies = group.bodies;
    for (const Island& island : splitIslands(group.bodies, group.contacts, group.rows)) {
      const Problem part = assemble(group.bodies, group.contacts, group.rows, island);
      VectorXd guess = VectorXd::Zero(part.size());
      if (fromStoredImpulses)
        for (std::size_t i = 0; i < island.frictional.size(); ++i)
          guess.segment<3>(3 * int(i)) = group.guess[std::size_t(island.frictional[i])];
      const Solution solution = solver.solve(part, guess);
      answer.residual = std::max(answer.residual, solution.residual);
      answer.unsolved += solution.status != Status::Solved;
      if (moveRefined(bodies, group, island, solution.r, mostRefined)) continue;
      ++answer.unrefined;
      applyReaction(bodies, group.contacts, group.rows, island, solution.r);
    }
    for (const Body& body : bodies) answer.motion.push_back(body.velocity);
  }
  return answer;
}

}  // namespace

StepProblem::StepProblem(const CapturedStep& step, double cfm) : cfm_(cfm) {
  btContactSolverInfo info = *step.info;
  info.m_globalCfm = btScalar(cfm);
  StepReport ignored;
  for (const CapturedStep::Group& source : step.groups) {
    bullet::Group group;
    const WatchedJoints watched(source.constraints.data(), int(source.constraints.size()));
    bullet::gatherGroup(group, source.input(info, step.dispatcher), ignored);
    contacts_ += int(group.contacts.size());
    rows_ += int(group.rows.size());
    for (const Body& body : group.bodies) {
      const Eigen::SelfAdjointEigenSolver<Mat3> axes(body.inverseInertia);
      freeMotion_.push_back(body.velocity);
      principal_.push_back(axes.eigenvectors());
      rootMass_.push_back(rootMass(body, axes.eigenvalues()));
    }
    groups_.push_back(std::move(group));
  }
}

Motion StepProblem::currentMotion() const {
  Motion motion;
  for (const bullet::Group& group : groups_)
    for (const bullet::BodySource& source : group.bodySources)
      motion.push_back(
          bullet::toCore(source.rigid->getLinearVelocity(), source.rigid->getAngularVelocity()));
  return motion;
}

double StepProblem::distance(const Motion& v, const Motion& w) const {
  double squares = 0;
  for (std::size_t i = 0; i < v.size(); ++i) {
    Vec6 difference = v[i] - w[i];
    difference.tail<3>() = principal_[i].transpose() * difference.tail<3>();
    squares += difference.cwiseProduct(rootMass_[i]).squaredNorm();
  }
  return std::sqrt(squares);
}

std::vector<Mode> StepProblem::modes(const Motion& motion) const {
  std::vector<Mode> modes;
  auto first = motion.begin();
  for (const bullet::Group& group : groups_) {
    const Motion own(first, first + std::ptrdiff_t(group.bodies.size()));
    first += std::ptrdiff_t(group.bodies.size());
    for (const Contact& contact : group.contacts) modes.push_back(modeOf(contact, own));
  }
  return modes;
}

Certified certify(const StepProblem& problem, double secondsLimit, int mostRefined) {
  Certified best;
  std::vector<TightAnswer> answers;
  for (const bool fromStoredImpulses : {false, true}) {
    const ApartResult apart =
        runApart([&] { return solveTightly(problem, fromStoredImpulses, mostRefined).numbers(); },
                 Limits{secondsLimit});
    if (apart.ending == Ending::Done)
      answers.push_back(TightAnswer::from(apart.numbers));
    else if (answers.empty())
      best.ending = apart.ending;
  }
  if (answers.empty()) return best;
  const TightAnswer& chosen =
      answers.size() == 2 && answers[1].betterThan(answers[0]) ? answers[1] : answers[0];
  best.ending = Ending::Done;
  best.residual = chosen.residual;
  best.unsolved = chosen.unsolved;
  best.refined = chosen.unrefined == 0;
  best.motion = chosen.motion;
  best.size = problem.distance(problem.freeMotion(), best.motion);
  // One answer alone has nothing to agree with.
  best.agreement = answers.size() == 2 && best.size > 0
                       ? problem.distance(answers[0].motion, answers[1].motion) / best.size
                       : 1;
  return best;
}

}  // namespace demos::report
