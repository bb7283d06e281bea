#include <cmath>

#include "demos/scenes/builders.h"

namespace demos {

namespace {

/// Axes for the joints of a doll that stands upright with its arms out.
const btQuaternion xToUp = aboutZ(M_PI / 2), xToTheLeft = aboutZ(M_PI);
const btQuaternion zToTheSide(btVector3(0, 1, 0), btScalar(M_PI / 2));
const btQuaternion zToUp(btVector3(1, 0, 0), btScalar(-M_PI / 2));

/// One limb: a capsule of 1 kg from `from` to `to`, both measured from the feet of a doll of scale
/// 1.
struct Limb {
  btVector3 from, to;
  btScalar radius;
};

class Doll {
 public:
  Doll(World& world, const btTransform& place, double scale, double mu)
      : world_(world), place_(place), scale_(btScalar(scale)), material_{surfaceFriction(mu), 0} {}

  btRigidBody& addLimb(const Limb& limb) {
    const btVector3 axis = scale_ * (limb.to - limb.from);
    const btScalar length = axis.length(), radius = scale_ * limb.radius;
    const btQuaternion turn = shortestArcQuat(btVector3(0, 1, 0), axis / length);
    btCapsuleShape& shape =
        world_.own(std::make_unique<btCapsuleShape>(radius, length - 2 * radius));
    const btVector3 middle = scale_ * (limb.from + limb.to) / 2;
    return world_.add(1, shape, place_ * btTransform(turn, middle), material_);
  }

  /// A hinge at `joint` about the z axis of `axes`, bending between `low` and `high` radians.
  void hinge(btRigidBody& a, btRigidBody& b, const btVector3& joint, const btQuaternion& axes,
             btScalar low, btScalar high) {
    const btTransform frame = place_ * btTransform(axes, scale_ * joint);
    auto made = std::make_unique<btHingeConstraint>(a, b, inBody(a, frame), inBody(b, frame));
    made->setLimit(low, high);
    world_.join(std::move(made));
  }

  /// A cone at `joint` around the x axis of `axes`, which is that of the limb. About any other axis
  /// a spinning limb would run far past its twist limit, and come back with the speed that the
  /// joint's law asks for.
  void coneTwist(btRigidBody& a, btRigidBody& b, const btVector3& joint, const btQuaternion& axes,
                 btScalar swing, btScalar twist) {
    const btTransform frame = place_ * btTransform(axes, scale_ * joint);
    auto made = std::make_unique<btConeTwistConstraint>(a, b, inBody(a, frame), inBody(b, frame));
    made->setLimit(swing, swing, twist);
    world_.join(std::move(made));
  }

 private:
  static btTransform inBody(const btRigidBody& body, const btTransform& frame) {
    return body.getWorldTransform().inverse() * frame;
  }

  World& world_;
  btTransform place_;
  btScalar scale_;
  Material material_;
};

btVector3 point(double x, double y) { return vec3(x, y, 0); }

}  // namespace

void addDoll(World& world, const btTransform& place, double scale, double mu) {
  Doll doll(world, place, scale, mu);
  constexpr btScalar pi = btScalar(M_PI);
  btRigidBody& pelvis = doll.addLimb({point(0, 0.85), point(0, 1.15), btScalar(0.14)});
  btRigidBody& chest = doll.addLimb({point(0, 1.15), point(0, 1.55), btScalar(0.15)});
  btRigidBody& head = doll.addLimb({point(0, 1.6), point(0, 1.9), btScalar(0.1)});
  doll.hinge(pelvis, chest, point(0, 1.15), zToTheSide, -pi / 4, pi / 4);
  doll.coneTwist(chest, head, point(0, 1.58), xToUp, pi / 4, pi / 4);
  for (const int side : {-1, 1}) {
    btRigidBody& thigh =
        doll.addLimb({point(0.18 * side, 0.82), point(0.18 * side, 0.45), btScalar(0.08)});
    btRigidBody& shin =
        doll.addLimb({point(0.18 * side, 0.42), point(0.18 * side, 0.02), btScalar(0.06)});
    btRigidBody& upperArm =
        doll.addLimb({point(0.2 * side, 1.5), point(0.52 * side, 1.5), btScalar(0.06)});
    btRigidBody& foreArm =
        doll.addLimb({point(0.54 * side, 1.5), point(0.84 * side, 1.5), btScalar(0.05)});
    doll.coneTwist(pelvis, thigh, point(0.18 * side, 0.85), xToUp, pi / 4, pi / 8);
    doll.hinge(thigh, shin, point(0.18 * side, 0.435), zToTheSide, 0, pi / 2);
    doll.coneTwist(chest, upperArm, point(0.18 * side, 1.5),
                   side > 0 ? btQuaternion::getIdentity() : xToTheLeft, pi / 2, pi / 8);
    doll.hinge(upperArm, foreArm, point(0.53 * side, 1.5), zToUp, -pi / 2, 0);
  }
}

std::unique_ptr<World> buildRagdolls(int count) {
  constexpr int columns = 5;
  auto world = std::make_unique<World>();
  addGround(*world);
  for (int i = 0; i < count; ++i) {
    const int row = i / columns, column = i % columns;
    const btVector3 feet = vec3(2.2 * (column - 2), 0.5 + 0.25 * row, 1.5 * row);
    // Every doll leans differently, so that they do not all fall alike.
    const btQuaternion lean(btVector3(1, 0, 0), btScalar(0.1 * (column - 2) + 0.05 * row));
    addDoll(*world, btTransform(lean, feet));
  }
  return world;
}

}  // namespace demos
