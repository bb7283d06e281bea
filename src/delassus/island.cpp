#include "delassus/island.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace delassus {
namespace {

bool movable(const std::vector<Body>& bodies, int i) { return i >= 0 && bodies[i].movable(); }

void applyImpulse(Body& body, const Vec6& impulse) {
  body.velocity.head<3>() += body.inverseMass.cwiseProduct(impulse.head<3>());
  body.velocity.tail<3>() += body.inverseInertia * impulse.tail<3>();
}

/// A contact's part of the Jacobian for a body touched at `arm`: frameᵀ [ I, −[arm]× ].
Mat36 contactJacobian(const Mat3& frame, const Vec3& arm) {
  Mat36 J;
  J.leftCols<3>() = frame.transpose();
  for (int i = 0; i < 3; ++i) J.row(i).tail<3>() = arm.cross(frame.col(i)).transpose();
  return J;
}

/// Its normal row.
Row6 normalJacobian(const Mat3& frame, const Vec3& arm) {
  Row6 J;
  J << frame.col(0).transpose(), arm.cross(frame.col(0)).transpose();
  return J;
}

/// The first row with a governor; such rows come after all others.
std::vector<int>::const_iterator firstOfDisks(const std::vector<Row>& rows, const Island& island) {
  return std::partition_point(island.rows.begin(), island.rows.end(),
                              [&](int i) { return rows[i].governor < 0; });
}

}  // namespace

int Island::normalOf(int contact) const {
  const auto place = [contact](const std::vector<int>& list) {
    const auto at = std::lower_bound(list.begin(), list.end(), contact);
    return at != list.end() && *at == contact ? static_cast<int>(at - list.begin()) : -1;
  };
  const int k = place(frictional);
  return k >= 0 ? 3 * k : static_cast<int>(3 * frictional.size()) + place(frictionless);
}

/// Cholesky that skips locked axes.
Assembler::RootOfInverseMass Assembler::rootOf(const Body& body) {
  RootOfInverseMass root{body.inverseMass.cwiseSqrt(), Mat3::Zero()};
  // A pivot below round-off of the largest inverse inertia is a locked direction.
  const Mat3& I = body.inverseInertia;
  Mat3& angular = root.angular;
  const double locked = 1e-14 * I.diagonal().maxCoeff();
  for (int j = 0; j < 3; ++j) {
    const double pivot = I(j, j) - angular.row(j).head(j).squaredNorm();
    if (pivot <= locked) continue;
    angular(j, j) = std::sqrt(pivot);
    for (int i = j + 1; i < 3; ++i)
      angular(i, j) =
          (I(i, j) - angular.row(i).head(j).dot(angular.row(j).head(j))) / angular(j, j);
  }
  return root;
}

void Assembler::addIsland() {
  if (count_ == static_cast<int>(islands_.size())) islands_.emplace_back();
  Island& island = islands_[count_++];
  island.bodies.clear();
  island.frictional.clear();
  island.frictionless.clear();
  island.rows.clear();
}

std::size_t Assembler::bytes() const {
  std::size_t sum =
      bytesOf(islands_, runs_, islandOf_, placeOf_, roots_) + sets_.bytes() + problem_.bytes();
  for (const Island& island : islands_) sum += island.bytes();
  return sum;
}

/// Finds the runs: most contacts come after another of the same two bodies.
void Assembler::findRuns(const std::vector<Body>& bodies, const std::vector<Contact>& contacts,
                         bool allTangents) {
  runs_.clear();
  const auto moving = [&](int body) { return movable(bodies, body) ? body : fixedWorld; };
  int a = fixedWorld, b = fixedWorld;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const Contact& c = contacts[i];
    const bool isFrictional = c.friction != 0 || allTangents;
    if (!runs_.empty() && c.a == a && c.b == b && isFrictional == runs_.back().isFrictional) {
      ++runs_.back().end;
      continue;
    }
    a = c.a;
    b = c.b;
    const int at = static_cast<int>(i);
    runs_.push_back({moving(a), moving(b), at, at + 1, isFrictional});
  }
}

void Assembler::split(const std::vector<Body>& bodies, const std::vector<Contact>& contacts,
                      const std::vector<Row>& rows, bool allTangents) {
  constexpr int untouched = -2, unnumbered = -1;
  const int bodyCount = static_cast<int>(bodies.size());
  sets_.reset(bodyCount);
  const auto join = [this](int a, int b) {
    if (a >= 0 && b >= 0) sets_.join(a, b);
  };
  const auto moving = [&](int body) { return movable(bodies, body) ? body : fixedWorld; };
  findRuns(bodies, contacts, allTangents);
  for (const Run& run : runs_) join(run.a, run.b);
  for (const Row& c : rows) join(moving(c.a), moving(c.b));

  // Bodies that nothing touches make no island.
  islandOf_.assign(bodyCount, untouched);
  const auto touch = [this](int body) {
    if (body >= 0) islandOf_[sets_.root(body)] = unnumbered;
  };
  for (const Run& run : runs_) touch(run.a), touch(run.b);
  for (const Row& c : rows) touch(moving(c.a)), touch(moving(c.b));

  // The root of an island is its first body.
  count_ = 0;
  for (int i = 0; i < bodyCount; ++i) {
    const int root = sets_.root(i);
    if (!movable(bodies, i) || islandOf_[root] == untouched) continue;
    if (root == i) {
      islandOf_[i] = count_;
      addIsland();
    }
    islandOf_[i] = islandOf_[root];
    islands_[islandOf_[i]].bodies.push_back(i);
  }

  const auto islandTouching = [this](int a, int b) -> Island* {
    const int body = a >= 0 ? a : b;
    return body >= 0 ? &islands_[islandOf_[body]] : nullptr;
  };
  for (const Run& run : runs_)
    if (Island* island = islandTouching(run.a, run.b)) {
      std::vector<int>& list = run.isFrictional ? island->frictional : island->frictionless;
      for (int i = run.begin; i < run.end; ++i) list.push_back(i);
    }
  for (int i = 0; i < static_cast<int>(rows.size()); ++i)
    if (Island* island = islandTouching(moving(rows[i].a), moving(rows[i].b)))
      island->rows.push_back(i);
}

double leastDemandOf(const std::vector<Body>& bodies, const std::vector<Contact>& contacts,
                     const std::vector<Row>& rows, const Island& island) {
  double least = infinity;
  for (const int body : island.bodies) least = std::min(least, bodies[body].gain);
  if (!(least > 0 && least < infinity)) return 0;
  const auto isHeld = [&](const auto& part) {
    return !movable(bodies, part.a) || !movable(bodies, part.b);
  };
  for (const std::vector<int>* list : {&island.frictional, &island.frictionless})
    for (const int i : *list)
      if (isHeld(contacts[i])) return 0;
  for (const int i : island.rows)
    if (isHeld(rows[i])) return 0;
  return least;
}

const Problem& Assembler::assemble(const std::vector<Body>& bodies,
                                   const std::vector<Contact>& contacts,
                                   const std::vector<Row>& rows, const Island& island) {
  BodySpace& space = makeRoom(island);
  takeRoots(bodies, island);
  largestTerm_ = 0;
  writeFrictional(bodies, contacts, island, space);
  writeFrictionless(bodies, contacts, island, space);
  writeRows(bodies, rows, island, space);
  writeDisks(bodies, rows, island, space);
  problem_.leastDemand = leastDemandOf(bodies, contacts, rows, island);
  problem_.roundOff = 4 * std::numeric_limits<double>::epsilon() * largestTerm_;
  return problem_;
}

/// Sets all sizes; contacts, rows and disks are yet to be filled in.
BodySpace& Assembler::makeRoom(const Island& island) {
  const int n = static_cast<int>(island.frictional.size());
  const int m = static_cast<int>(island.frictionless.size() + island.rows.size());
  BodySpace& space = problem_.W.refill(3 * n + m);
  space.bodies = static_cast<int>(island.bodies.size());
  space.contacts.clear();
  space.contacts.reserve(n);
  space.rows.clear();
  space.rows.reserve(m);
  space.compliance.resize(3 * n + m);
  problem_.q.resize(3 * n + m);
  problem_.friction.resize(n);
  problem_.lower.resize(m);
  problem_.upper.resize(m);
  problem_.disks.clear();
  return space;
}

void Assembler::takeRoots(const std::vector<Body>& bodies, const Island& island) {
  roots_.clear();
  roots_.reserve(island.bodies.size());
  placeOf_.resize(bodies.size());
  for (int body : island.bodies) {
    placeOf_[body] = static_cast<int>(roots_.size());
    roots_.push_back(rootOf(bodies[body]));
  }
}

int Assembler::placeIn(const std::vector<Body>& bodies, int body) const {
  return movable(bodies, body) ? placeOf_[body] : fixedWorld;
}

/// Takes one body's share: adds its velocity to q, and replaces J by J B (zero if it is immovable).
template <class Rows, class Velocity>
void Assembler::takeShare(const std::vector<Body>& bodies, int body, int place, Rows& J,
                          Velocity& q) {
  if (body >= 0) {
    const auto share = (J * bodies[body].velocity).eval();
    largestTerm_ = std::max(largestTerm_, share.cwiseAbs().maxCoeff());
    q += share;
  }
  if (place < 0) {
    J.setZero();
    return;
  }
  const RootOfInverseMass& B = roots_[place];
  J.template leftCols<3>() *= B.linear.asDiagonal();
  J.template rightCols<3>() = (J.template rightCols<3>() * B.angular).eval();
}

void Assembler::writeFrictional(const std::vector<Body>& bodies,
                                const std::vector<Contact>& contacts, const Island& island,
                                BodySpace& space) {
  int at = 0;
  for (int i : island.frictional) {
    const Contact& c = contacts[i];
    ContactRows& entry = space.contacts.emplace_back();
    entry.a = placeIn(bodies, c.a);
    entry.b = placeIn(bodies, c.b);
    Vec3 q = Vec3::Zero();
    if (c.a >= 0) entry.Ja = contactJacobian(c.frame, c.armA);
    if (c.b >= 0) entry.Jb = -contactJacobian(c.frame, c.armB);
    takeShare(bodies, c.a, entry.a, entry.Ja, q);
    takeShare(bodies, c.b, entry.b, entry.Jb, q);
    problem_.q.segment<3>(at) = q - c.target;
    space.compliance.segment<3>(at) << c.compliance, c.slipCompliance, c.slipCompliance;
    problem_.friction[at / 3] = c.friction;
    at += 3;
  }
}

void Assembler::writeFrictionless(const std::vector<Body>& bodies,
                                  const std::vector<Contact>& contacts, const Island& island,
                                  BodySpace& space) {
  for (int i : island.frictionless) {
    const Contact& c = contacts[i];
    writeRow(bodies, {c.a, c.b, normalJacobian(c.frame, c.armA), -normalJacobian(c.frame, c.armB)},
             c.target[0], {0, infinity}, c.compliance, space);
  }
}

void Assembler::writeRows(const std::vector<Body>& bodies, const std::vector<Row>& rows,
                          const Island& island, BodySpace& space) {
  for (auto i = island.rows.begin(), end = firstOfDisks(rows, island); i != end; ++i) {
    const Row& c = rows[*i];
    writeRow(bodies, {c.a, c.b, c.jacobianA, c.jacobianB}, c.target, {c.lower, c.upper},
             c.compliance, space);
  }
}

void Assembler::writeDisks(const std::vector<Body>& bodies, const std::vector<Row>& rows,
                           const Island& island, BodySpace& space) {
  int at = 3 * problem_.contacts() + static_cast<int>(space.rows.size());
  bool paired = false;  // whether the row before is paired with this one
  for (auto i = firstOfDisks(rows, island); i != island.rows.end(); ++i, ++at) {
    const Row& c = rows[*i];
    if (paired)
      ++problem_.disks.back().unknowns;
    else
      problem_.disks.push_back({at, 1, island.normalOf(c.governor), c.upper, c.mostLoad});
    paired = c.paired;
    writeRow(bodies, {c.a, c.b, c.jacobianA, c.jacobianB}, c.target, {-infinity, infinity}, 0,
             space);
  }
}

/// Writes the next row, given by its bodies and J; stored are the bodies' places and J B.
void Assembler::writeRow(const std::vector<Body>& bodies, const ScalarRow& row, double target,
                         const Interval& bounds, double compliance, BodySpace& space) {
  const int k = static_cast<int>(space.rows.size()), at = 3 * problem_.contacts() + k;
  ScalarRow& entry = space.rows.emplace_back(row);
  entry.a = placeIn(bodies, row.a);
  entry.b = placeIn(bodies, row.b);
  Eigen::Matrix<double, 1, 1> q(0.0);
  takeShare(bodies, row.a, entry.a, entry.Ja, q);
  takeShare(bodies, row.b, entry.b, entry.Jb, q);
  problem_.q[at] = q[0] - target;
  space.compliance[at] = compliance;
  problem_.lower[k] = bounds.lower;
  problem_.upper[k] = bounds.upper;
}

std::vector<Island> splitIslands(const std::vector<Body>& bodies,
                                 const std::vector<Contact>& contacts,
                                 const std::vector<Row>& rows) {
  Assembler assembler;
  assembler.split(bodies, contacts, rows);
  std::vector<Island> islands;
  islands.reserve(assembler.islands());
  for (int i = 0; i < assembler.islands(); ++i) islands.push_back(assembler.island(i));
  return islands;
}

Problem assemble(const std::vector<Body>& bodies, const std::vector<Contact>& contacts,
                 const std::vector<Row>& rows, const Island& island) {
  return Assembler().assemble(bodies, contacts, rows, island);
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

  island.eachContactAt([&](int i, int at, int unknowns) {
    const Mat3& frame = contacts[i].frame;
    pushContact(contacts[i],
                unknowns == 3 ? Vec3(frame * r.segment<3>(at)) : Vec3(frame.col(0) * r[at]));
  });
  island.eachRowAt([&](int i, int at) {
    push(rows[i].a, rows[i].jacobianA.transpose() * r[at]);
    push(rows[i].b, rows[i].jacobianB.transpose() * r[at]);
  });
}

}  // namespace delassus
