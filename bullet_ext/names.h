#pragma once

#include <string>

class btCollisionObject;
class btMultiBodyConstraint;
class btTypedConstraint;

namespace delassus::bullet {

struct PointSource;

/// How messages call an object: by its place in the world. Contacts and joints: by their bodies. A
/// link: by its number and its multibody too, which is called by the name of its base, or by the
/// place of its first collider.
std::string nameOf(const btCollisionObject& object);
std::string nameOf(const PointSource& source);
std::string nameOf(const btTypedConstraint& joint);
std::string nameOf(btMultiBodyConstraint& constraint);

}  // namespace delassus::bullet
