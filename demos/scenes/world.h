#pragma once

#include <btBulletDynamicsCommon.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace demos {

/// A vector in the precision of Bullet's build.
inline btVector3 vec3(double x, double y, double z) {
  return {btScalar(x), btScalar(y), btScalar(z)};
}

/// A pose without rotation.
inline btTransform at(double x, double y, double z) {
  return btTransform(btQuaternion::getIdentity(), vec3(x, y, z));
}

/// A turn about e_z, radians.
inline btQuaternion aboutZ(double angle) {
  return btQuaternion(btVector3(0, 0, 1), btScalar(angle));
}

/// A surface. Bullet multiplies the frictions of the two surfaces in touch; see `surfaceFriction`.
struct Material {
  btScalar friction = 0;
  btScalar restitution = 0;
};

/// The coefficient that a surface needs for Coulomb's `mu` against its like: √mu.
btScalar surfaceFriction(double mu);

/// A Bullet world that owns all its parts, so that scenes, tests and pictures can pass it around.
///
/// Gravity is 9.81 m/s² along −y, nothing sleeps, and pairs are ordered: the same calls give the
/// same bits. The solver is Bullet's own until `setSolver` names another; that one is not owned and
/// must outlive the world.
class World {
 public:
  World();
  ~World();
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  btDiscreteDynamicsWorld& dynamics() { return *dynamics_; }
  const btDiscreteDynamicsWorld& dynamics() const { return *dynamics_; }
  void setSolver(btConstraintSolver& solver);

  /// Keeps `shape` as long as the world lives.
  template <class Shape>
  Shape& own(std::unique_ptr<Shape> shape) {
    Shape& kept = *shape;
    shapes_.push_back(std::move(shape));
    return kept;
  }
  btBoxShape& box(const btVector3& halfSize);
  btSphereShape& sphere(btScalar radius);
  btStaticPlaneShape& plane(const btVector3& normal, btScalar offset);

  /// Adds a body of `mass` kg with its centre of mass at `pose`; mass 0 is immovable.
  btRigidBody& add(btScalar mass, btCollisionShape& shape, const btTransform& pose,
                   const Material& material);
  /// Adds a body that the caller has made; the world keeps it.
  btRigidBody& add(std::unique_ptr<btRigidBody> body);
  /// Adds a joint. The bodies that it links collide with each other only if `linkedCollide`.
  btTypedConstraint& join(std::unique_ptr<btTypedConstraint> joint, bool linkedCollide = false);

  /// The function is called before every step with the time at its start: it moves machines or
  /// hands in the scene.
  void setScript(std::function<void(double time)> script) { script_ = std::move(script); }

  /// Divides every step into this many substeps, each with collision detection and a solve of its
  /// own. Powers of two are exact.
  void setSubsteps(int count) { substeps_ = count; }

  /// One step of `dt` seconds, without interpolation.
  void step(double dt);
  void run(double seconds, double hz);
  double time() const { return time_; }

  /// The bodies that can move, in the order of creation.
  std::vector<btRigidBody*> movableBodies() const;
  int contactCount() const;

  /// Keeps a thing that owns bodies of this world (a loaded file). When the world goes, the thing
  /// goes first and takes its bodies out.
  void keep(std::shared_ptr<void> thing) { kept_.push_back(std::move(thing)); }

 private:
  std::vector<std::shared_ptr<void>> kept_;
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_;
  btDbvtBroadphase broadphase_;
  btSequentialImpulseConstraintSolver stockSolver_;
  std::unique_ptr<btDiscreteDynamicsWorld> dynamics_;
  std::vector<std::unique_ptr<btCollisionShape>> shapes_;
  std::vector<std::unique_ptr<btRigidBody>> bodies_;
  std::vector<std::unique_ptr<btTypedConstraint>> joints_;
  std::function<void(double)> script_;
  int substeps_ = 1;
  double time_ = 0;
};

}  // namespace demos
