#include "delassus/problem.h"

#include <algorithm>
#include <cmath>

#include "delassus/cone.h"

namespace delassus {
namespace {

constexpr double largest = 1e100;
bool inBodySpace(const BodySpace& space, int contacts, int part, int first) {
  double sum = space.compliance.segment(first, part < contacts ? 3 : 1).cwiseAbs().sum();
  const auto add = [&sum](int body, const auto& J) {
    if (body >= 0) sum += J.cwiseAbs().sum();
  };
  const auto addBoth = [&add](const auto& rows) {
    add(rows.a, rows.Ja);
    add(rows.b, rows.Jb);
  };
  if (part < contacts)
    addBoth(space.contacts[part]);
  else
    addBoth(space.rows[part - contacts]);
  for (const BodySpace::Part& p : space.partsOf(first)) add(p.body, p.J);
  return sum <= largest;
}

bool inEntries(const DelassusMatrix::Sparse& entries, int first, int unknowns) {
  const int begin = entries.outerIndexPtr()[first], end = entries.outerIndexPtr()[first + unknowns];
  return Eigen::Map<const Eigen::VectorXd>(entries.valuePtr() + begin, end - begin)
             .cwiseAbs()
             .sum() <= largest;
}

bool isFit(const Problem& problem, int part, int first, int unknowns) {
  const int contacts = problem.contacts();
  if (!(problem.q.segment(first, unknowns).cwiseAbs().sum() <= largest)) return false;
  if (part < contacts) {
    if (!(problem.friction[part] >= 0 && problem.friction[part] <= largest)) return false;
  } else {
    const double lower = problem.lower[part - contacts], upper = problem.upper[part - contacts];
    const auto isInRange = [](double bound) {
      return std::isinf(bound) || std::abs(bound) <= largest;
    };
    if (!(lower <= upper && lower < infinity && upper > -infinity) || !isInRange(lower) ||
        !isInRange(upper))
      return false;
  }
  return problem.W.inBodySpace() ? inBodySpace(problem.W.bodySpace(), contacts, part, first)
                                 : inEntries(problem.W.entries(), first, unknowns);
}

/// The rows of a disk must have no bounds but the disk.
bool hasNoBounds(const Problem& problem, int row, int count) {
  return (problem.lower.segment(row, count).array() == -infinity).all() &&
         (problem.upper.segment(row, count).array() == infinity).all();
}

/// Whether a law can be stated for a disk, and `next` is the unknown after its last.
bool isFit(const Problem& problem, const Disk& disk, int next) {
  const int contactsEnd = 3 * problem.contacts();
  return disk.radius > 0 && disk.radius <= largest && disk.mostLoad > 0 &&
         (disk.mostLoad <= largest || std::isinf(disk.mostLoad)) && disk.governor >= 0 &&
         disk.governor < problem.disksBegin() &&
         (disk.governor >= contactsEnd || disk.governor % 3 == 0) && disk.first >= contactsEnd &&
         disk.first < problem.size() && (disk.unknowns == 1 || disk.unknowns == 2) &&
         disk.first + disk.unknowns == next && next <= problem.size() &&
         hasNoBounds(problem, disk.first - contactsEnd, disk.unknowns);
}

/// Σ |x_i|, in four parallel sums: an addition to one sum takes longer than to read the next
/// numbers.
double sumOfSizes(const double* x, Eigen::Index count) {
  using Two = Eigen::Map<const Eigen::Array2d>;
  Eigen::Array2d a = Eigen::Array2d::Zero(), b = a, c = a, d = a;
  Eigen::Index k = 0;
  for (; k + 8 <= count; k += 8) {
    a += Two(x + k).abs();
    b += Two(x + k + 2).abs();
    c += Two(x + k + 4).abs();
    d += Two(x + k + 6).abs();
  }
  double rest = 0;
  for (; k < count; ++k) rest += std::abs(x[k]);
  return (a + b + (c + d)).sum() + rest;
}

/// Σ |J̃_ij| + |R_ii| of the contacts; entries at the same place of all blocks are added first.
double sumOfContacts(const BodySpace& space) {
  decltype(ContactRows::Ja) a, b;
  a.setZero();
  b.setZero();
  for (const ContactRows& c : space.contacts) {
    if (c.a >= 0) a += c.Ja.cwiseAbs();
    if (c.b >= 0) b += c.Jb.cwiseAbs();
  }
  return a.sum() + b.sum() +
         sumOfSizes(space.compliance.data(), static_cast<Eigen::Index>(3 * space.contacts.size()));
}

/// Whether all numbers of the contacts add up to one in range: then the sums for each contact alone
/// are in range, too. This shows most problems to be fit, much faster than a check of every part.
/// Explicit entries are added up together with those of the rows.
bool areContactsFit(const Problem& problem) {
  const int contacts = problem.contacts();
  const DelassusMatrix& W = problem.W;
  if (contacts == 0 || !(problem.friction.minCoeff() >= 0)) return false;
  if (W.inBodySpace() && !W.bodySpace().parts.empty()) return false;
  const double ofW = W.inBodySpace() ? sumOfContacts(W.bodySpace())
                                     : sumOfSizes(W.entries().valuePtr(), W.entries().nonZeros());
  return sumOfSizes(problem.q.data(), 3 * Eigen::Index(contacts)) + problem.friction.sum() + ofW <=
         largest;
}

}  // namespace

double Problem::demand() const {
  const int n = contacts();
  double largest = leastDemand;
  for (int i = 0; i < n; ++i)
    largest = std::max(largest, contactDemand(q.segment<3>(3 * i), friction[i]));
  for (int i = 0; i < rows(); ++i) {
    const int at = 3 * n + i;
    if (std::abs(q[at]) > largest || isForced(lower[i], upper[i]))
      largest = std::max(
          largest, demandOf(q[at], lower[i], upper[i], [this, at] { return W.diagonalOfRow(at); }));
  }
  return largest;
}

Interval allowedWithoutFriction(const Problem& problem, int unknown) {
  const int row = unknown - 3 * problem.contacts();
  if (row >= 0) return {problem.lower[row], problem.upper[row]};
  return {0, unknown % 3 == 0 ? infinity : 0};
}

std::vector<int> unfitParts(const Problem& problem) {
  std::vector<int> unfit;
  const int contacts = problem.contacts();
  for (int part = areContactsFit(problem) ? contacts : 0; part < problem.parts(); ++part) {
    const int first = problem.unknownOf(part);
    if (!isFit(problem, part, first, part < contacts ? 3 : 1)) unfit.push_back(first);
  }
  for (std::size_t k = 0; k < problem.disks.size(); ++k) {
    const bool last = k + 1 == problem.disks.size();
    if (!isFit(problem, problem.disks[k], last ? problem.size() : problem.disks[k + 1].first))
      unfit.push_back(std::clamp(problem.disks[k].first, 0, std::max(problem.size() - 1, 0)));
  }
  std::sort(unfit.begin(), unfit.end());
  unfit.erase(std::unique(unfit.begin(), unfit.end()), unfit.end());
  return unfit;
}

bool makeFeasible(const Problem& problem, VectorXd& r) {
  const int n = problem.contacts();
  bool isMoved = false;
  for (int i = 0; i < n; ++i) {
    auto own = r.segment<3>(3 * i);
    const Vec3 inside = projectOnCone(own, problem.friction[i]);
    isMoved |= inside != own;
    own = inside;
  }
  for (int i = 0; i < problem.rows(); ++i) {
    double& own = r[3 * n + i];
    const double inside = std::clamp(own, problem.lower[i], problem.upper[i]);
    isMoved |= inside != own;
    own = inside;
  }
  for (const Disk& disk : problem.disks) {
    const Vec2 inside = projectOnDisk(disk.of(r), disk.radiusAt(r));
    isMoved |= inside != disk.of(r);
    disk.put(inside, r);
  }
  return isMoved;
}

}  // namespace delassus
