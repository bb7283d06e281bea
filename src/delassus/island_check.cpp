#include "delassus/island_check.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "delassus/disk.h"
#include "delassus/read_mode.h"
#include "delassus/residual.h"

namespace delassus {
namespace {

/// What the rounding of two velocities can leave where they cancel.
double roundOff(double a, double b) {
  return 4 * std::numeric_limits<double>::epsilon() * std::max(std::abs(a), std::abs(b));
}

/// The velocity of the point of `body` at `arm`; that of the fixed world is zero.
Vec3 velocityAt(const std::vector<Body>& bodies, int body, const Vec3& arm) {
  if (body < 0) return Vec3::Zero();
  const Vec6& v = bodies[body].velocity;
  return v.head<3>() + v.tail<3>().cross(arm);
}

Vec3 relativeVelocity(const std::vector<Body>& bodies, const Contact& c) {
  const Vec3 slip = velocityAt(bodies, c.a, c.armA) - velocityAt(bodies, c.b, c.armB);
  return c.frame.transpose() * slip - c.target;
}

double normalVelocity(const std::vector<Body>& bodies, const Contact& c) {
  const Vec3 slip = velocityAt(bodies, c.a, c.armA) - velocityAt(bodies, c.b, c.armB);
  return c.frame.col(0).dot(slip) - c.target[0];
}

double along(const std::vector<Body>& bodies, int body, const Row6& J) {
  return body >= 0 ? J.dot(bodies[body].velocity) : 0;
}

double relativeVelocity(const std::vector<Body>& bodies, const Row& c) {
  return along(bodies, c.a, c.jacobianA) + along(bodies, c.b, c.jacobianB) - c.target;
}

/// One body's share in the trace of W_aa of a contact whose axes e_i are orthonormal, whichever
/// they are: Σ e_iᵀ M⁻¹ e_i + (arm × e_i)ᵀ I⁻¹ (arm × e_i).
double traceShare(const std::vector<Body>& bodies, int body, const Vec3& arm) {
  if (body < 0) return 0;
  const Body& b = bodies[body];
  const double turning =
      arm.squaredNorm() * b.inverseInertia.trace() - arm.dot(b.inverseInertia * arm);
  return b.inverseMass.sum() + std::max(0.0, turning);
}

/// The same in the diagonal of W, along one axis.
double diagonalShare(const std::vector<Body>& bodies, int body, const Vec3& arm, const Vec3& axis) {
  if (body < 0) return 0;
  const Vec3 turn = arm.cross(axis);
  return axis.cwiseAbs2().dot(bodies[body].inverseMass) +
         turn.dot(bodies[body].inverseInertia * turn);
}

double diagonal(const std::vector<Body>& bodies, const Contact& c, int axis) {
  return diagonalShare(bodies, c.a, c.armA, c.frame.col(axis)) +
         diagonalShare(bodies, c.b, c.armB, c.frame.col(axis));
}

/// Not where friction depends on the direction.
bool areTangentsOrthonormal(const Contact& c) {
  constexpr double rounding = 1e-12;
  const Vec3 t1 = c.frame.col(1), t2 = c.frame.col(2);
  return std::abs(t1.squaredNorm() - 1) + std::abs(t2.squaredNorm() - 1) + std::abs(t1.dot(t2)) <
         rounding;
}

double trace(const std::vector<Body>& bodies, const Contact& c) {
  const double hard =
      areTangentsOrthonormal(c)
          ? traceShare(bodies, c.a, c.armA) + traceShare(bodies, c.b, c.armB)
          : diagonal(bodies, c, 0) + diagonal(bodies, c, 1) + diagonal(bodies, c, 2);
  return hard + c.compliance + 2 * c.slipCompliance;
}

/// Whether the reaction r sticks, and far enough inside its cone that the law projects r − ρ w to
/// itself for every ρ up to that of the mode, 3/trace W_aa: that is not more than `rho`, and from r
/// on all up to a point inside lies inside.
bool sticksFirmly(const Vec3& r, const Vec3& w, double friction, double rho) {
  const Vec3 z = r - rho * w;
  const double radius = friction * z[0];
  return z[0] > 0 && z[1] * z[1] + z[2] * z[2] < radius * radius;
}

/// 3/trace W_aa, were the bodies not to turn, nor to slide on each other: no less.
double largestStep(const std::vector<Body>& bodies, const Contact& c) {
  const Vec3 squares = c.frame.col(0).cwiseAbs2();
  const auto share = [&](int body) {
    return body >= 0 ? squares.dot(bodies[body].inverseMass) : 0;
  };
  return 3 / (share(c.a) + share(c.b));
}

double diagonalShare(const std::vector<Body>& bodies, int body, const Row6& J) {
  if (body < 0) return 0;
  const Vec3 linear = J.head<3>(), angular = J.tail<3>();
  return linear.cwiseAbs2().dot(bodies[body].inverseMass) +
         angular.dot(bodies[body].inverseInertia * angular);
}

double diagonal(const std::vector<Body>& bodies, const Row& c) {
  return diagonalShare(bodies, c.a, c.jacobianA) + diagonalShare(bodies, c.b, c.jacobianB);
}

/// The natural residuals of an island, one contact or row after the other, until one is too large.
class Residuals {
 public:
  explicit Residuals(double tolerance) : tolerance_(tolerance) {}

  bool add(double residual) {
    if (!(residual <= tolerance_)) return false;
    max_ = std::max(max_, residual);
    squares_ += residual * residual;
    ++count_;
    return true;
  }
  void write(Solution& solution) const {
    solution.residual = max_;
    solution.residualRms = count_ > 0 ? std::sqrt(squares_ / count_) : 0;
  }

 private:
  double tolerance_, max_ = 0, squares_ = 0;
  int count_ = 0;
};

void moveIntoDisk(const Disk& disk, VectorXd& r) {
  disk.put(projectOnDisk(disk.of(r), disk.radiusAt(r)), r);
}

/// The disk that ends with the k-th row of the island, whose rows begin at this unknown.
Disk diskAt(const std::vector<Row>& rows, const Island& island, int k, int rowsBegin) {
  const Row& last = rows[island.rows[k]];
  const bool pair = k > 0 && rows[island.rows[k - 1]].paired;
  const int unknowns = pair ? 2 : 1;
  return {rowsBegin + k + 1 - unknowns, unknowns, island.normalOf(last.governor), last.upper,
          last.mostLoad};
}

/// The square of about the largest radius of gyration; 0 if it cannot turn.
double reachOf(const Body& body) {
  double least = infinity;
  for (int i = 0; i < 3; ++i)
    if (body.inverseInertia(i, i) > 0) least = std::min(least, body.inverseInertia(i, i));
  return least < infinity ? body.inverseMass.maxCoeff() / least : 0;
}

/// Whether no body moves faster than that, nor turns so fast that what of the island is furthest
/// from its centre would. A joint does not tell how far out it holds its bodies.
bool isSlower(const std::vector<Body>& bodies, const std::vector<Contact>& contacts,
              const std::vector<Row>& rows, const Island& island, double speed) {
  if (std::any_of(island.rows.begin(), island.rows.end(),
                  [&](int i) { return rows[i].governor < 0; }))
    return false;
  const double square = speed * speed;
  double turn = 0, reach = 0;  // squared
  for (int i : island.bodies) {
    const Vec6& v = bodies[i].velocity;
    if (!(v.head<3>().squaredNorm() <= square)) return false;
    turn = std::max(turn, v.tail<3>().squaredNorm());
    reach = std::max(reach, reachOf(bodies[i]));
  }
  const auto reachTo = [&](int body, const Vec3& arm) {
    if (body >= 0 && bodies[body].movable()) reach = std::max(reach, arm.squaredNorm());
  };
  for (const std::vector<int>* touching : {&island.frictional, &island.frictionless})
    for (int i : *touching) {
      reachTo(contacts[i].a, contacts[i].armA);
      reachTo(contacts[i].b, contacts[i].armB);
    }
  return turn * reach <= square;
}

void makeReady(const Island& island, Tier tier, Solution& solution) {
  const auto scalars = island.frictionless.size() + island.rows.size();
  solution.u.resize(static_cast<int>(3 * island.frictional.size() + scalars));
  solution.activeSet.contacts.resize(island.frictional.size());
  solution.activeSet.rows.resize(scalars);
  solution.activeSet.disks.clear();
  solution.status = Status::Solved;
  solution.tier = tier;
  solution.startResidual = infinity;  // nobody asks for that of what is kept
  solution.regions = solution.factorisations = solution.sweeps = solution.patches = 0;
  solution.blamed.clear();
}

}  // namespace

bool IslandCheck::isFree(const std::vector<Body>& bodies, const std::vector<Contact>& contacts,
                         const std::vector<Row>& rows, const Island& island,
                         Solution& solution) const {
  Residuals residuals(infinity);
  const auto leaves = [&](int i) {
    const Contact& c = contacts[i];
    const double q = normalVelocity(bodies, c);
    if (q >= 0) return residuals.add(0);
    const auto normal = [&](int body, const Vec3& arm) {
      return c.frame.col(0).dot(velocityAt(bodies, body, arm));
    };
    return -q <= roundOff(normal(c.a, c.armA), normal(c.b, c.armB)) && residuals.add(-q);
  };
  const auto rests = [&](int i) {
    const Row& c = rows[i];
    if (c.governor >= 0) return residuals.add(0);  // its disk is a point
    if (c.lower > 0 || c.upper < 0) return false;
    const double q = relativeVelocity(bodies, c);
    if (!std::isfinite(q)) return false;  // the solver names it
    const double missed = std::max(c.lower < 0 ? q : 0, c.upper > 0 ? -q : 0);
    return missed <= roundOff(along(bodies, c.a, c.jacobianA), along(bodies, c.b, c.jacobianB)) &&
           residuals.add(std::max(missed, 0.0));
  };
  if (!std::all_of(island.frictional.begin(), island.frictional.end(), leaves) ||
      !std::all_of(island.frictionless.begin(), island.frictionless.end(), leaves) ||
      !std::all_of(island.rows.begin(), island.rows.end(), rests))
    return false;

  makeReady(island, Tier::Free, solution);
  solution.r.setZero(solution.u.size());
  residuals.write(solution);
  std::fill(solution.activeSet.contacts.begin(), solution.activeSet.contacts.end(), Mode::Open);
  int at = 0, state = 0;
  for (int i : island.frictional) {
    solution.u.segment<3>(at) = relativeVelocity(bodies, contacts[i]);
    at += 3;
  }
  for (int i : island.frictionless) {
    solution.u[at++] = normalVelocity(bodies, contacts[i]);
    solution.activeSet.rows[state++] = RowState::AtLower;
  }
  for (int i : island.rows) {
    solution.u[at++] = relativeVelocity(bodies, rows[i]);
    if (rows[i].governor >= 0) {
      solution.activeSet.rows[state++] = RowState::Free;
      if (!rows[i].paired) solution.activeSet.disks.push_back(Mode::Open);
      continue;
    }
    solution.activeSet.rows[state++] = rows[i].lower == 0   ? RowState::AtLower
                                       : rows[i].upper == 0 ? RowState::AtUpper
                                                            : RowState::Free;
  }
  return true;
}

/// Projects r, gives the bodies the velocities that it leaves, and returns the largest |q|.
double IslandCheck::move(const std::vector<Body>& bodies, const std::vector<Contact>& contacts,
                         const std::vector<Row>& rows, const Island& island,
                         std::vector<Body>& moved, VectorXd& r) {
  impulses_.resize(bodies.size(), Vec6::Zero());
  for (int body : island.bodies) impulses_[body].setZero();
  double demand = 0;
  const auto moves = [&](int body) { return body >= 0 && bodies[body].movable(); };
  const auto push = [&](const Contact& c, const Vec3& impulse) {
    if (moves(c.a)) {
      impulses_[c.a].head<3>() += impulse;
      impulses_[c.a].tail<3>() += c.armA.cross(impulse);
    }
    if (moves(c.b)) {
      impulses_[c.b].head<3>() -= impulse;
      impulses_[c.b].tail<3>() -= c.armB.cross(impulse);
    }
  };
  int at = 0;
  for (int i : island.frictional) {
    const Contact& c = contacts[i];
    demand = std::max(demand, relativeVelocity(bodies, c).cwiseAbs().maxCoeff());
    r.segment<3>(at) = projectOnCone(r.segment<3>(at), c.friction);
    push(c, c.frame * r.segment<3>(at));
    at += 3;
  }
  for (int i : island.frictionless) {
    const Contact& c = contacts[i];
    demand = std::max(demand, std::abs(normalVelocity(bodies, c)));
    r[at] = std::max(r[at], 0.0);
    push(c, c.frame.col(0) * r[at++]);
  }
  const int rowsBegin = at;
  for (int i : island.rows) {
    const Row& c = rows[i];
    demand = std::max(demand, std::abs(relativeVelocity(bodies, c)));
    if (c.governor < 0)
      r[at] = std::clamp(r[at], c.lower, c.upper);
    else if (!c.paired)
      moveIntoDisk(diskAt(rows, island, at - rowsBegin, rowsBegin), r);
    ++at;
  }
  at = rowsBegin;
  for (int i : island.rows) {
    const Row& c = rows[i];
    if (moves(c.a)) impulses_[c.a] += c.jacobianA.transpose() * r[at];
    if (moves(c.b)) impulses_[c.b] += c.jacobianB.transpose() * r[at];
    ++at;
  }
  for (int body : island.bodies) {
    const Body& free = bodies[body];
    Vec6& v = moved[body].velocity;
    v.head<3>() += free.inverseMass.cwiseProduct(impulses_[body].head<3>());
    v.tail<3>() += free.inverseInertia * impulses_[body].tail<3>();
  }
  return demand;
}

bool IslandCheck::isKept(const std::vector<Body>& bodies, const std::vector<Contact>& contacts,
                         const std::vector<Row>& rows, const Island& island, double share,
                         std::vector<Body>& moved, Solution& solution) {
  VectorXd& r = solution.r;
  const double demand = move(bodies, contacts, rows, island, moved, r);
  Residuals residuals(share * options_.tolerance * demand);
  makeReady(island, Tier::Kept, solution);
  VectorXd& u = solution.u;

  const auto isWithin = [&](double residual, double friction) {
    return (friction <= 1 || residual <= share * options_.toleranceFor(friction) * demand) &&
           residuals.add(residual);
  };
  int at = 0, state = 0;
  const auto keepsCone = [&](int i) {
    const Contact& c = contacts[i];
    if (!(c.friction >= 0)) return false;  // the solver names it
    const Vec3 reaction = r.segment<3>(at);
    Vec3 velocity = relativeVelocity(moved, c);
    velocity[0] += c.compliance * reaction[0];
    velocity.tail<2>() += c.slipCompliance * reaction.tail<2>();
    u.segment<3>(at) = velocity;
    Mode& mode = solution.activeSet.contacts[at / 3];
    at += 3;
    const Vec3 corrected = correctedVelocity(velocity, c.friction);
    if (sticksFirmly(reaction, corrected, c.friction, largestStep(moved, c))) {
      mode = Mode::Stick;
      return isWithin(corrected.norm(), c.friction);
    }
    const double size = trace(moved, c), mean = size / 3;
    mode = modeOf(reaction, velocity, c.friction, mean);
    const Vec3 wished = projectOnCone(reaction - corrected / size, c.friction);
    return isWithin((reaction - wished).norm() * size, c.friction);
  };
  const auto keepsBounds = [&](double velocity, double lower, double upper, double ownSize) {
    constexpr double immovable = 1e100;  // what nothing moves keeps its bounds in any unit
    const double size = ownSize > 0 ? ownSize : immovable;
    u[at] = velocity;
    solution.activeSet.rows[state++] = stateOf(r[at], velocity, lower, upper, size);
    return residuals.add(size * rowResidual(r[at++], velocity, lower, upper, 1 / size));
  };
  const auto keepsNormal = [&](int i) {
    const Contact& c = contacts[i];
    return keepsBounds(normalVelocity(moved, c) + c.compliance * r[at], 0, infinity,
                       diagonal(moved, c, 0) + c.compliance);
  };
  const int rowsBegin = island.unknowns() - static_cast<int>(island.rows.size());
  double pairSize = 0;  // of the first row of a pair
  /// At the last row of a disk, where its velocity is known.
  const auto keepsDisk = [&](const Row& c) {
    const double size = pairSize + diagonal(moved, c);
    u[at] = relativeVelocity(moved, c);
    solution.activeSet.rows[state++] = RowState::Free;
    ++at;
    pairSize = c.paired ? size : 0;
    if (c.paired) return residuals.add(0);  // both rows count, as in NaturalMap
    const Disk disk = diskAt(rows, island, at - 1 - rowsBegin, rowsBegin);
    const Vec2 reaction = disk.of(r), velocity = disk.of(u);
    const double radius = disk.radiusAt(r);
    solution.activeSet.disks.push_back(
        diskModeOf(reaction, velocity, radius, size / disk.unknowns));
    if (!(size > 0)) return residuals.add(velocity.norm());  // nothing moves it
    const Vec2 wished = projectOnDisk(reaction - velocity / size, radius);
    return residuals.add((reaction - wished).norm() * size);
  };
  const auto keepsRow = [&](int i) {
    const Row& c = rows[i];
    if (c.governor >= 0) return keepsDisk(c);
    return keepsBounds(relativeVelocity(moved, c) + c.compliance * r[at], c.lower, c.upper,
                       diagonal(moved, c) + c.compliance);
  };
  if (std::all_of(island.frictional.begin(), island.frictional.end(), keepsCone) &&
      std::all_of(island.frictionless.begin(), island.frictionless.end(), keepsNormal) &&
      std::all_of(island.rows.begin(), island.rows.end(), keepsRow)) {
    residuals.write(solution);
    // Rounding, not what a user would tolerate: forces that nothing resists add up.
    const double still = share * std::min(options_.tolerance, Options().tolerance) * demand;
    if (isSlower(moved, contacts, rows, island, still))
      for (int body : island.bodies) moved[body].velocity.setZero();
    return true;
  }
  for (int body : island.bodies) moved[body].velocity = bodies[body].velocity;
  return false;
}

}  // namespace delassus
