#pragma once

#include <string>

class btCollisionObject;
class btMultiBodyConstraint;
class btRigidBody;
class btTypedConstraint;

namespace delassus::bullet {

struct PointSource;

/// Names of objects in messages: an object's is its place in the world; contacts and joints are
/// named by their bodies, a link also by its number and its multibody. A multibody has the name of
/// its base, or else the place of its first collider.
std::string nameOf(const btCollisionObject& object);
std::string nameOf(const PointSource& source);
std::string nameOf(const btTypedConstraint& joint);
std::string nameOf(btMultiBodyConstraint& constraint);

/// The partner that Bullet gives to joints between a body and the world; it belongs to no world.
/// (Bullet writes to it whenever it is asked for it, also where several worlds step at once.)
const btRigidBody& fixedBody();

}  // namespace delassus::bullet
