#include "delassus/island.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "delassus/links.h"

namespace delassus {
namespace {

/// B with M⁻¹ = B Bᵀ: a diagonal for the mass, a lower triangle (Cholesky that skips locked axes) for the inertia.
struct RootOfInverseMass {
  Vec3 linear = Vec3::Zero();
  Mat3 angular = Mat3::Zero();

  explicit RootOfInverseMass(const Body& body) : linear(body.inverseMass.cwiseSqrt()) {
    // A pivot below round-off of the largest inverse inertia is a locked direction.
    const Mat3& I = body.inverseInertia;
    const double locked = 1e-14 * I.diagonal().maxCoeff();
    for (int j = 0; j < 3; ++j) {
      const double pivot = I(j, j) - angular.row(j).head(j).squaredNorm();
      if (pivot <= locked) continue;
      angular(j, j) = std::sqrt(pivot);
      for (int i = j + 1; i < 3; ++i)
        angular(i, j) =
            (I(i, j) - angular.row(i).head(j).dot(angular.row(j).head(j))) / angular(j, j);
    }
  }
};

Mat3 cross(const Vec3& x) {
  Mat3 m;
  m << 0, -x[2], x[1], x[2], 0, -x[0], -x[1], x[0], 0;
  return m;
}

/// Rows of the Jacobian of a contact for a body touched at `arm`: frameᵀ [ I, −[arm]× ].
Mat36 contactJacobian(const Mat3& frame, const Vec3& arm) {
  Mat36 J;
  J.leftCols<3>() = frame.transpose();
  J.rightCols<3>().noalias() = -frame.transpose() * cross(arm);
  return J;
}

template <int rows>
Eigen::Matrix<double, rows, 6> massNormalised(const Eigen::Matrix<double, rows, 6>& J,
                                              const RootOfInverseMass& B) {
  Eigen::Matrix<double, rows, 6> JB;
  JB.template leftCols<3>() = J.template leftCols<3>() * B.linear.asDiagonal();
  JB.template rightCols<3>().noalias() = J.template rightCols<3>() * B.angular;
  return JB;
}

bool movable(const std::vector<Body>& bodies, int i) { return i >= 0 && bodies[i].movable(); }

void applyImpulse(Body& body, const Vec6& impulse) {
  body.velocity.head<3>() += body.inverseMass.cwiseProduct(impulse.head<3>());
  body.velocity.tail<3>() += body.inverseInertia * impulse.tail<3>();
}

}  // namespace

std::vector<Island> splitIslands(const std::vector<Body>& bodies,
                                 const std::vector<Contact>& contacts,
                                 const std::vector<Row>& rows) {
  const int count = static_cast<int>(bodies.size());
  Links links(count);
  const auto join = [&](int a, int b) {
    if (movable(bodies, a) && movable(bodies, b)) links.join(a, b);
  };
  for (const Contact& c : contacts) join(c.a, c.b);
  for (const Row& c : rows) join(c.a, c.b);

  // Number the islands by their first body; bodies that nothing touches make no island.
  std::vector<char> touched(count, 0);
  const auto touch = [&](int i) {
    if (movable(bodies, i)) touched[links.root(i)] = 1;
  };
  for (const Contact& c : contacts) touch(c.a), touch(c.b);
  for (const Row& c : rows) touch(c.a), touch(c.b);

  std::vector<Island> islands;
  std::vector<int> islandOf(count, -1);
  for (int i = 0; i < count; ++i) {
    const int root = links.root(i);
    if (!movable(bodies, i) || !touched[root]) continue;
    if (root == i) {
      islandOf[i] = static_cast<int>(islands.size());
      islands.emplace_back();
    }
    islandOf[i] = islandOf[root];
    islands[islandOf[i]].bodies.push_back(i);
  }

  const auto islandTouching = [&](int a, int b) {
    return movable(bodies, a) ? islandOf[a] : movable(bodies, b) ? islandOf[b] : -1;
  };
  for (int i = 0; i < static_cast<int>(contacts.size()); ++i) {
    const int island = islandTouching(contacts[i].a, contacts[i].b);
    if (island < 0) continue;
    (contacts[i].friction > 0 ? islands[island].frictional : islands[island].frictionless)
        .push_back(i);
  }
  for (int i = 0; i < static_cast<int>(rows.size()); ++i) {
    const int island = islandTouching(rows[i].a, rows[i].b);
    if (island >= 0) islands[island].rows.push_back(i);
  }
  return islands;
}

Problem assemble(const std::vector<Body>& bodies, const std::vector<Contact>& contacts,
                 const std::vector<Row>& rows, const Island& island) {
  const int n = static_cast<int>(island.frictional.size());
  const int smooth = static_cast<int>(island.frictionless.size());
  const int m = smooth + static_cast<int>(island.rows.size());

  BodySpace space;
  space.bodies = static_cast<int>(island.bodies.size());
  space.contacts.reserve(n);
  space.rows.reserve(m);
  space.compliance = VectorXd::Zero(3 * n + m);

  Problem problem;
  problem.q.resize(3 * n + m);
  problem.friction.resize(n);
  problem.lower.resize(m);
  problem.upper.resize(m);

  std::vector<RootOfInverseMass> roots;
  roots.reserve(island.bodies.size());
  for (int body : island.bodies) roots.emplace_back(bodies[body]);
  const auto local = [&](int body) {
    if (!movable(bodies, body)) return fixedWorld;
    const auto at = std::lower_bound(island.bodies.begin(), island.bodies.end(), body);
    return static_cast<int>(at - island.bodies.begin());
  };
  const auto velocity = [&](int body) -> Vec6 {
    return body >= 0 ? bodies[body].velocity : Vec6::Zero();
  };
  double largestTerm = 0;
  const auto difference = [&](const auto& a, const auto& b, const auto& target) {
    largestTerm = std::max({largestTerm, a.cwiseAbs().maxCoeff(), b.cwiseAbs().maxCoeff()});
    return (a + b - target).eval();
  };

  int at = 0;
  for (int i : island.frictional) {
    const Contact& c = contacts[i];
    const Mat36 Ja = contactJacobian(c.frame, c.armA), Jb = -contactJacobian(c.frame, c.armB);
    BodySpace::ContactRows entry{local(c.a), local(c.b), Mat36::Zero(), Mat36::Zero()};
    if (entry.a >= 0) entry.Ja = massNormalised<3>(Ja, roots[entry.a]);
    if (entry.b >= 0) entry.Jb = massNormalised<3>(Jb, roots[entry.b]);
    space.contacts.push_back(entry);
    space.compliance[at] = c.compliance;
    problem.q.segment<3>(at) =
        difference(Vec3(Ja * velocity(c.a)), Vec3(Jb * velocity(c.b)), c.target);
    problem.friction[at / 3] = c.friction;
    at += 3;
  }

  const auto addRow = [&](int a, int b, const Row6& Ja, const Row6& Jb, double target, double lower,
                          double upper, double compliance) {
    BodySpace::ScalarRow entry{local(a), local(b), Row6::Zero(), Row6::Zero()};
    if (entry.a >= 0) entry.Ja = massNormalised<1>(Ja, roots[entry.a]);
    if (entry.b >= 0) entry.Jb = massNormalised<1>(Jb, roots[entry.b]);
    space.rows.push_back(entry);
    space.compliance[at] = compliance;
    problem.q.segment<1>(at) =
        difference(Vec1(Ja * velocity(a)), Vec1(Jb * velocity(b)), Vec1(target));
    problem.lower[at - 3 * n] = lower;
    problem.upper[at - 3 * n] = upper;
    ++at;
  };
  for (int i : island.frictionless) {
    const Contact& c = contacts[i];
    addRow(c.a, c.b, contactJacobian(c.frame, c.armA).row(0),
           -contactJacobian(c.frame, c.armB).row(0), c.target[0], 0,
           std::numeric_limits<double>::infinity(), c.compliance);
  }
  for (int i : island.rows) {
    const Row& c = rows[i];
    addRow(c.a, c.b, c.jacobianA, c.jacobianB, c.target, c.lower, c.upper, c.compliance);
  }

  problem.roundOff = 4 * std::numeric_limits<double>::epsilon() * largestTerm;
  problem.W = DelassusMatrix(std::move(space));
  return problem;
}

void applyReaction(std::vector<Body>& bodies, const std::vector<Contact>& contacts,
                   const std::vector<Row>& rows, const Island& island, const VectorXd& r) {
  const auto push = [&](int body, const Vec6& impulse) {
    if (movable(bodies, body)) applyImpulse(bodies[body], impulse);
  };
  const auto pushContact = [&](const Contact& c, const Vec3& force) {
    Vec6 impulse;
    impulse << force, c.armA.cross(force);
    push(c.a, impulse);
    impulse << -force, -c.armB.cross(force);
    push(c.b, impulse);
  };

  int at = 0;
  for (int i : island.frictional) {
    pushContact(contacts[i], contacts[i].frame * r.segment<3>(at));
    at += 3;
  }
  for (int i : island.frictionless) pushContact(contacts[i], contacts[i].frame.col(0) * r[at++]);
  for (int i : island.rows) {
    push(rows[i].a, rows[i].jacobianA.transpose() * r[at]);
    push(rows[i].b, rows[i].jacobianB.transpose() * r[at]);
    ++at;
  }
}

}  // namespace delassus
