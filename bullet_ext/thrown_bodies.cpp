#include "bullet_ext/thrown_bodies.h"

#include <Eigen/Geometry>

namespace delassus::bullet {

void soften(const std::vector<Body>& bodies, Contact& contact) {
  constexpr double softness = 0.5 / (reach * reach);
  const auto response = [&](int index, const Vec3& arm) {
    if (index == fixedWorld) return 0.0;
    const Body& body = bodies[index];
    const Vec3 turn = arm.cross(Vec3(contact.frame.col(0)));
    return body.inverseMass.maxCoeff() + turn.dot(body.inverseInertia * turn);
  };
  contact.compliance +=
      softness * (response(contact.a, contact.armA) + response(contact.b, contact.armB));
}

void soften(const std::vector<Body>& bodies, Row& row) {
  constexpr double softness = 0.5 / (jointReach * jointReach);
  const auto response = [&](int index, const Row6& J) {
    if (index < 0) return 0.0;
    const Body& body = bodies[index];
    const Vec3 turn = J.tail<3>().transpose();
    return body.inverseMass.maxCoeff() * J.head<3>().squaredNorm() +
           turn.dot(body.inverseInertia * turn);
  };
  row.compliance += softness * (response(row.a, row.jacobianA) + response(row.b, row.jacobianB));
}

}  // namespace delassus::bullet
