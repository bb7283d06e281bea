#include "demos/render/film.h"

#include <BulletDynamics/Featherstone/btMultiBody.h>
#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>

#include <algorithm>
#include <unordered_map>

#include "demos/render/marks.h"
#include "demos/scenes/measures.h"
#include "demos/scenes/simulate.h"
#include "demos/scenes/solver_in_world.h"
#include "demos/scenes/statistics.h"
#include "demos/scenes/step_judge.h"

namespace demos::render {

namespace {

/// The mass of a body or of an articulated body's link, kg; 0 if it cannot move.
double massOf(const btCollisionObject& object) {
  if (const btRigidBody* body = btRigidBody::upcast(&object))
    return body->getInvMass() > 0 ? 1 / double(body->getInvMass()) : 0;
  const btMultiBodyLinkCollider* collider = btMultiBodyLinkCollider::upcast(&object);
  if (collider == nullptr || collider->m_multiBody == nullptr) return 0;
  const btMultiBody& whole = *collider->m_multiBody;
  if (collider->m_link >= 0) return double(whole.getLinkMass(collider->m_link));
  return whole.hasFixedBase() ? 0 : double(whole.getBaseMass());
}

/// Turns collision objects into things, each once, and shapes into meshes, each once.
class Cast {
 public:
  Cast(Film& film, int objects) : film_(film), segments_(objects > manyObjects ? 20 : 48) {}

  int thingOf(const btCollisionObject& object) {
    const auto [place, isNew] = things_.try_emplace(&object, int(film_.things.size()));
    if (isNew) film_.things.push_back(makeThing(object));
    return place->second;
  }

 private:
  static constexpr int manyObjects = 200;  ///< from here on each is small in the picture

  Thing makeThing(const btCollisionObject& object) {
    Thing thing;
    thing.mass = massOf(object);
    const btCollisionShape& shape = *object.getCollisionShape();
    if (shape.getShapeType() == STATIC_PLANE_PROXYTYPE) {
      const auto& plane = static_cast<const btStaticPlaneShape&>(shape);
      thing.plane = Plane{toDouble(plane.getPlaneNormal()), double(plane.getPlaneConstant())};
      return thing;
    }
    const auto [place, isNew] = parts_.try_emplace(&shape);
    if (isNew)
      for (ShapePart& part : shapeParts(shape, segments_)) {
        place->second.push_back({int(film_.meshes.size()), part.place});
        film_.meshes.push_back(std::move(part.mesh));
      }
    thing.parts = place->second;
    return thing;
  }

  Film& film_;
  int segments_;
  std::unordered_map<const btCollisionObject*, int> things_;  // for look-up only
  std::unordered_map<const btCollisionShape*, std::vector<Thing::Part>> parts_;
};

std::vector<Frame::Pose> poses(World& world, Cast& cast) {
  std::vector<Frame::Pose> all;
  const btCollisionObjectArray& objects = world.dynamics().getCollisionObjectArray();
  for (int i = 0; i < objects.size(); ++i) {
    const btCollisionObject& object = *objects[i];
    if (!toMatrix(object.getWorldTransform()).allFinite()) continue;  // its place is not finite
    btVector3 low, high;
    object.getCollisionShape()->getAabb(object.getWorldTransform(), low, high);
    all.push_back({cast.thingOf(object), toMatrix(object.getWorldTransform()), toDouble(low),
                   toDouble(high)});
  }
  return all;
}

/// Drops marks whose place is not finite, as bodies of a lost world have them.
template <class Mark>
std::vector<Mark> thatAreSomewhere(std::vector<Mark> marks) {
  const auto nowhere = [](const Mark& mark) {
    return !mark.place.allFinite() || !mark.force.allFinite();
  };
  marks.erase(std::remove_if(marks.begin(), marks.end(), nowhere), marks.end());
  return marks;
}

}  // namespace

Film record(World& world, NamedSolver& named, double hz, const std::vector<double>& times,
            const std::function<void(double)>& progress) {
  Film film;
  film.solver = named.name();
  film.meshes.push_back(cylinderMesh(1, 1, 12));
  const Eigen::Vector3d gravity = toDouble(world.dynamics().getGravity());
  if (gravity.norm() > 0) film.up = -gravity.normalized();

  SolverInWorld solving(world, named);
  PersistenceWatch watch(solving.timed());
  StepJudge judge(watch, named, solving.sceneCfm());
  const JointFeedbacks feedbacks(world);
  Cast cast(film, world.dynamics().getNumCollisionObjects());

  const int total = times.empty() ? 0 : stepsIn(times.back(), hz);
  std::vector<double> milliseconds;
  int step = 0;
  for (const double time : times) {
    const int last = stepsIn(time, hz);
    if (step == last && !film.frames.empty()) {
      film.frames.push_back(film.frames.back());
      continue;
    }
    for (; step < last; ++step) {
      const bool isShown = step + 1 == last;
      world.setSolver(judge.solver(isShown));
      watch.startStep(step == 0);
      world.step(1 / hz);
      milliseconds.push_back(1e3 * solving.timed().takeSeconds());
      progress(double(step + 1) / double(total));
    }
    Frame frame;
    frame.time = double(step) / hz;
    frame.poses = poses(world, cast);
    if (step > 0) {
      frame.contacts = thatAreSomewhere(contactMarks(world, watch, 1 / hz));
      frame.joints = thatAreSomewhere(jointMarks(world));
      const StepResidual residual = judge.takeResidual();
      if (residual.count > 0) frame.residual = residual.max;
    }
    frame.lost = !isFinite(world);
    for (const Rope& rope : ropes(world))
      if (rope.body.allFinite() && rope.end.allFinite()) frame.ropes.push_back(rope);
    frame.milliseconds = median(milliseconds);
    film.frames.push_back(std::move(frame));
  }
  return film;
}

}  // namespace demos::render
