#include "demos/atlas/experiments.h"

#include <array>
#include <cmath>
#include <stdexcept>

#include "bullet_ext/btDelassusConstraintSolver.h"
#include "bullet_ext/convert.h"
#include "bullet_ext/gather.h"
#include "delassus/island.h"
#include "demos/scenes/builders.h"
#include "demos/scenes/solver_decorator.h"
#include "demos/scenes/solvers.h"

namespace demos::atlas {

using namespace delassus;
using bullet::toCore;

namespace {

/// Keeps the contacts and the problem of the last step of a world with one island, and the
/// reactions that the solver wrote.
class StepCatcher : public SolverDecorator {
 public:
  using SolverDecorator::SolverDecorator;
  const std::vector<Contact>& contacts() const { return group_.contacts; }
  const Problem& problem() const { return problem_; }
  const std::vector<double>& normalReactions() const { return normalReactions_; }

 protected:
  void beforeGroup(const GroupInput& arguments) override {
    StepReport ignored;
    bullet::gatherGroup(group_, arguments, ignored);
    problem_ = Problem();
    for (const Island& island : splitIslands(group_.bodies, group_.contacts, group_.rows))
      problem_ = assemble(group_.bodies, group_.contacts, group_.rows, island);
  }
  void afterGroup(const GroupInput&) override {
    normalReactions_.clear();
    for (const bullet::PointSource& source : group_.contactSources)
      normalReactions_.push_back(source.manifold->getContactPoint(source.point).m_appliedImpulse);
  }

 private:
  bullet::Group group_;
  Problem problem_;
  std::vector<double> normalReactions_;
};

/// A world on our solver, observed step by step.
struct WatchedWorld {
  btDelassusConstraintSolver solver;
  StepCatcher catcher{solver};
  std::unique_ptr<World> world;

  explicit WatchedWorld(std::unique_ptr<World> built) : world(std::move(built)) {
    world->setSolver(catcher);
  }
  btRigidBody& body() const { return *world->movableBodies().front(); }
};

std::unique_ptr<World> buildLeaningRod(const LeaningRod& rod) {
  constexpr double halfLength = 1, radius = 0.05;
  auto world = std::make_unique<World>();
  world->dynamics().setGravity(btVector3(0, 0, 0));
  const Material material{surfaceFriction(rod.friction), 0};
  world->add(0, world->plane(btVector3(0, 1, 0), 0), at(0, 0, 0), material);
  // A capsule's end is a ball: it touches the ground in one point.
  btCapsuleShapeX& shape =
      world->own(std::make_unique<btCapsuleShapeX>(btScalar(radius), btScalar(2 * halfLength)));
  btTransform pose = at(0, radius + halfLength * std::sin(rod.lean), 0);
  pose.setRotation(aboutZ(rod.lean));
  world->add(1, shape, pose, material);
  return world;
}

std::unique_ptr<World> buildLoadedRod(double a, const std::function<Load(double time)>& load) {
  auto world = buildRodOnSupports(a, 0);
  btRigidBody& rod = *world->movableBodies().front();
  world->setScript([&rod, load](double time) {
    const Load now = load(time);
    rod.applyForce(vec3(0, now.up, 0), rod.getWorldTransform().getBasis() * vec3(now.x, 0, 0));
  });
  return world;
}

}  // namespace

Fate fateOf(double opening) {
  if (std::abs(opening) <= keptTolerance) return Fate::Kept;
  return opening > 0 ? Fate::Released : Fate::Sunk;
}

std::vector<Fate> fatesOf(const VectorXd& openings) {
  std::vector<Fate> fates;
  for (const double opening : openings) fates.push_back(fateOf(opening));
  return fates;
}

VectorXd stepBead(const std::vector<btVector3>& normals, const btVector3& force,
                  const std::string& solverName) {
  NamedSolver solver(solverName);
  const auto world = buildBead(normals, force);
  solver.configure(world->dynamics().getSolverInfo());
  world->setSolver(solver.solver());
  world->step(timeStep);

  const btVector3 velocity = world->movableBodies().front()->getLinearVelocity();
  VectorXd openings(normals.size());
  for (std::size_t i = 0; i < normals.size(); ++i)
    openings[Eigen::Index(i)] = normals[i].dot(velocity) / (timeStep * force.length());
  return openings;
}

std::vector<Eigen::Vector2d> trackBead(std::unique_ptr<World> world, double seconds) {
  const WatchedWorld watched(std::move(world));
  std::vector<Eigen::Vector2d> track;
  for (long step = 0; step <= std::lround(seconds / timeStep); ++step) {
    const btVector3& centre = watched.body().getWorldTransform().getOrigin();
    track.emplace_back(centre.x(), centre.y());
    watched.world->step(timeStep);
  }
  return track;
}

RodStep stepLeaningRod(const LeaningRod& rod, const Eigen::Vector2d& force) {
  WatchedWorld watched(buildLeaningRod(rod));
  btRigidBody& body = watched.body();
  body.applyCentralForce(vec3(force.x(), force.y(), 0));
  watched.world->step(timeStep);

  // From the frame of Bullet's contact to y, x, z of the rod's end against the ground.
  const Contact& contact = watched.catcher.contacts().front();
  Mat3 turn;
  turn << 0, 1, 0, 1, 0, 0, 0, 0, 1;
  turn = turn * contact.frame * (contact.frame(1, 0) > 0 ? 1 : -1);
  const Vec3 arm = contact.a != fixedWorld ? contact.armA : contact.armB;
  const btVector3 velocity = body.getVelocityInLocalPoint(vec3(arm.x(), arm.y(), arm.z()));

  const Problem& problem = watched.catcher.problem();
  RodStep step;
  step.W = turn * problem.W.contactBlock(0) * turn.transpose();
  step.q = turn * problem.q;
  step.u = Vec3(velocity.y(), velocity.x(), velocity.z());
  return step;
}

SupportStep stepRodOnSupports(double a, const Load& load) {
  WatchedWorld watched(buildLoadedRod(a, [load](double) { return load; }));
  watched.world->step(timeStep);

  const std::vector<Contact>& contacts = watched.catcher.contacts();
  if (contacts.size() != 2)
    throw std::runtime_error("the rod rests on " + std::to_string(contacts.size()) +
                             " contacts instead of two");
  const Vec3 arm = contacts[0].a != fixedWorld ? contacts[0].armA : contacts[0].armB;
  const std::array<int, 2> order = arm.x() > 0 ? std::array{0, 1} : std::array{1, 0};
  SupportStep step;
  step.W = watched.catcher.problem().W.dense()(order, order);
  step.q = watched.catcher.problem().q(order);
  for (std::size_t i = 0; i < 2; ++i)
    step.reaction[Eigen::Index(i)] = watched.catcher.normalReactions()[std::size_t(order[i])];
  return step;
}

RodPose runRodOnSupports(double a, const std::function<Load(double)>& load, double seconds) {
  const WatchedWorld watched(buildLoadedRod(a, load));
  watched.world->run(seconds, 1 / timeStep);
  const btTransform& pose = watched.body().getWorldTransform();
  return {pose.getOrigin().x(), pose.getOrigin().y(),
          std::atan2(pose.getBasis()[1][0], pose.getBasis()[0][0])};
}

}  // namespace demos::atlas
