#include "delassus/kept_law.h"

#include "delassus/cone.h"
#include "delassus/contact_motion.h"
#include "delassus/read_mode.h"
#include "delassus/residual.h"

namespace delassus {
namespace {

/// One body's share in the trace of W_aa, which is the same for all orthonormal axes e_i of a
/// contact: Σ e_iᵀ M⁻¹ e_i + (arm × e_i)ᵀ I⁻¹ (arm × e_i).
double traceShare(const std::vector<Body>& bodies, int body, const Vec3& arm) {
  if (body < 0) return 0;
  const Body& b = bodies[body];
  const double turning =
      arm.squaredNorm() * b.inverseInertia.trace() - arm.dot(b.inverseInertia * arm);
  return b.inverseMass.sum() + std::max(0.0, turning);
}

/// False where friction depends on the direction.
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

/// Whether r sticks, and so far inside its cone that the law projects r − ρ w to itself for every ρ
/// up to that of the mode, 3/trace W_aa. This is at most `rho`, and since the cone is convex, all
/// points between r and the point at `rho` lie inside if that point does.
bool sticksFirmly(const Vec3& r, const Vec3& w, double friction, double rho) {
  const Vec3 z = r - rho * w;
  const double radius = friction * z[0];
  return z[0] > 0 && z[1] * z[1] + z[2] * z[2] < radius * radius;
}

/// An upper bound of 3/trace W_aa: its value if the bodies could neither turn nor slide on each
/// other.
double largestStep(const std::vector<Body>& bodies, const Contact& c) {
  const Vec3 squares = c.frame.col(0).cwiseAbs2();
  const auto share = [&](int body) {
    return body >= 0 ? squares.dot(bodies[body].inverseMass) : 0;
  };
  return 3 / (share(c.a) + share(c.b));
}

}  // namespace

KeptLaw::KeptLaw(const std::vector<Body>& moved, const std::vector<Contact>& contacts,
                 const std::vector<Row>& rows, const Island& island, const Options& options,
                 double share, double demand, Solution& solution)
    : moved_(moved),
      contacts_(contacts),
      rows_(rows),
      island_(island),
      options_(options),
      share_(share),
      demand_(demand),
      normalsBegin_(3 * static_cast<int>(island.frictional.size())),
      normals_(static_cast<int>(island.frictionless.size())),
      solution_(solution),
      residuals_(share * options.tolerance * demand) {}

bool KeptLaw::holds() {
  const auto all = [](const std::vector<int>& parts, const auto& keeps) {
    const int count = static_cast<int>(parts.size());
    for (int k = 0; k < count; ++k)
      if (!keeps(k)) return false;
    return true;
  };
  const bool isKept = all(island_.frictional, [this](int k) { return keepsCone(k); }) &&
                      all(island_.frictionless, [this](int k) { return keepsNormal(k); }) &&
                      all(island_.rows, [this](int k) { return keepsRow(k); });
  if (isKept) residuals_.write(solution_);
  return isKept;
}

bool KeptLaw::isWithin(double residual, double friction) {
  return (friction <= 1 || residual <= share_ * options_.toleranceFor(friction) * demand_) &&
         residuals_.add(residual);
}

bool KeptLaw::keepsCone(int k) {
  const Contact& c = contacts_[island_.frictional[k]];
  if (!(c.friction >= 0)) return false;  // the solver names it
  const Vec3 r = solution_.r.segment<3>(3 * k);
  Vec3 u = relativeVelocity(moved_, c);
  u[0] += c.compliance * r[0];
  u.tail<2>() += c.slipCompliance * r.tail<2>();
  solution_.u.segment<3>(3 * k) = u;
  Mode& mode = solution_.activeSet.contacts[k];
  const Vec3 corrected = correctedVelocity(u, c.friction);
  if (sticksFirmly(r, corrected, c.friction, largestStep(moved_, c))) {
    mode = Mode::Stick;
    return isWithin(corrected.norm(), c.friction);
  }
  const double size = trace(moved_, c), mean = size / 3;
  mode = modeOf(r, u, c.friction, mean);
  const Vec3 wished = projectOnCone(r - corrected / size, c.friction);
  return isWithin((r - wished).norm() * size, c.friction);
}

/// An unknown with bounds, the `state`-th of these. `ownSize`: its entry in the diagonal of W.
bool KeptLaw::keepsBounds(int state, double u, double lower, double upper, double ownSize) {
  constexpr double immovable = 1e100;  // a row that nothing moves keeps its bounds in any unit
  const double size = ownSize > 0 ? ownSize : immovable;
  const int at = normalsBegin_ + state;
  const double r = solution_.r[at];
  solution_.u[at] = u;
  solution_.activeSet.rows[state] = stateOf(r, u, lower, upper, size);
  return residuals_.add(size * rowResidual(r, u, lower, upper, 1 / size));
}

bool KeptLaw::keepsNormal(int k) {
  const Contact& c = contacts_[island_.frictionless[k]];
  return keepsBounds(k, normalVelocity(moved_, c) + c.compliance * solution_.r[normalsBegin_ + k],
                     0, infinity, diagonal(moved_, c, 0) + c.compliance);
}

bool KeptLaw::keepsRow(int k) {
  const Row& c = rows_[island_.rows[k]];
  if (c.governor >= 0) return keepsDisk(k);
  if (!(c.lower <= c.upper)) return false;  // the solver names it
  const double r = solution_.r[rowsBegin() + k];
  return keepsBounds(normals_ + k, relativeVelocity(moved_, c) + c.compliance * r, c.lower, c.upper,
                     diagonal(moved_, c) + c.compliance);
}

/// Called at the last row of a disk, where its velocity is known.
bool KeptLaw::keepsDisk(int k) {
  const Row& c = rows_[island_.rows[k]];
  solution_.u[rowsBegin() + k] = relativeVelocity(moved_, c);
  solution_.activeSet.rows[normals_ + k] = RowState::Free;
  if (c.paired) return residuals_.add(0);  // both rows count, as in NaturalMap
  const Disk disk = diskAt(rows_, island_, k, rowsBegin());
  double size = diagonal(moved_, c);
  if (disk.unknowns == 2) size += diagonal(moved_, rows_[island_.rows[k - 1]]);
  const Vec2 r = disk.of(solution_.r), u = disk.of(solution_.u);
  const double radius = disk.radiusAt(solution_.r);
  solution_.activeSet.disks.push_back(diskModeOf(r, u, radius, size / disk.unknowns));
  if (!(size > 0)) return residuals_.add(u.norm());  // nothing moves it
  const Vec2 wished = projectOnDisk(r - u / size, radius);
  return residuals_.add((r - wished).norm() * size);
}

}  // namespace delassus
