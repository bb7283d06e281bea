#include "delassus/sweeps.h"

#include <algorithm>
#include <cmath>

#include "delassus/wide.h"

namespace delassus {
namespace {

double boundedRow(double r, double u, double diagonal, double lower, double upper) {
  return std::clamp(r - u / diagonal, lower, upper);
}

/// Sweeps over all contacts of a problem in body space. y: J̃ᵀ r
DELASSUS_WIDE
void sweepContacts(const Problem& problem, const OneContact* blocks, const VectorXd& diagonal,
                   VectorXd& y, VectorXd& r) {
  const BodySpace& space = problem.W.bodySpace();
  const bool articulated = !space.parts.empty();
  for (int i = 0; i < problem.contacts(); ++i) {
    const int at = 3 * i;
    if (!(diagonal[at] > 0)) continue;
    const ContactRows& c = space.contacts[i];
    Vec3 u = problem.q.segment<3>(at) +
             space.compliance.segment<3>(at).cwiseProduct(r.segment<3>(at)) + c.relativeVelocity(y);
    const BodySpace::PartRange parts =
        articulated ? space.partsOf(at) : BodySpace::PartRange{nullptr, nullptr};
    for (const BodySpace::Part& p : parts) u.noalias() += p.J * y.segment<6>(6 * p.body);
    const Vec3 before = r.segment<3>(at);
    const Vec3 next = blocks[i].solve(u - blocks[i].W() * before, problem.friction[i], before);
    const Vec3 dr = next - before;
    c.addImpulse(dr, y);
    for (const BodySpace::Part& p : parts)
      y.segment<6>(6 * p.body).noalias() += p.J.transpose() * dr;
    r.segment<3>(at) = next;
  }
}

/// Sweeps over all its rows without a disk.
DELASSUS_WIDE
void sweepRows(const Problem& problem, const VectorXd& diagonal, VectorXd& y, VectorXd& r) {
  const BodySpace& space = problem.W.bodySpace();
  const bool articulated = !space.parts.empty();
  const int begin = 3 * problem.contacts();
  for (int at = begin; at < problem.disksBegin(); ++at) {
    if (!(diagonal[at] > 0)) continue;
    const int row = at - begin;
    const ScalarRow& c = space.rows[row];
    double u = problem.q[at] + space.compliance[at] * r[at] + c.relativeVelocity(y);
    const BodySpace::PartRange parts =
        articulated ? space.partsOf(at) : BodySpace::PartRange{nullptr, nullptr};
    for (const BodySpace::Part& p : parts) u += p.J.row(0).dot(y.segment<6>(6 * p.body));
    const double next = boundedRow(r[at], u, diagonal[at], problem.lower[row], problem.upper[row]);
    const double dr = next - r[at];
    c.addImpulse(dr, y);
    for (const BodySpace::Part& p : parts) y.segment<6>(6 * p.body) += p.J.row(0).transpose() * dr;
    r[at] = next;
  }
}

}  // namespace

void Sweeps::setProblem(const Problem& problem, const NaturalMap& map) {
  problem_ = &problem;
  blocks_.clear();
  for (int i = 0; i < problem.contacts(); ++i) blocks_.emplace_back(map.contactBlock(i));
  diagonal_ = &map.diagonal();
  diskBlocks_.resize(problem.disks.size());
  for (std::size_t k = 0; k < problem.disks.size(); ++k) {
    const Disk& disk = problem.disks[k];
    diskBlocks_[k] = disk.unknowns == 2 ? problem.W.pairBlock(disk.first)
                                        : Mat2((*diagonal_)[disk.first] * Mat2::Identity());
  }
  if (!problem.W.inBodySpace()) readEntries();
  learnt_ = false;
}

void Sweeps::readEntries() {
  coupling_.clear();
  coupled_.clear();
  couplingBegin_.assign(1, 0);
  std::vector<int> slot(problem_->contacts(), -1);
  for (int i = 0; i < problem_->contacts(); ++i) {
    if (!readContactBlocks(i)) readContactRows(i, slot);
    couplingBegin_.push_back(static_cast<int>(coupled_.size()));
  }
}

/// Reads the entries if all three rows of a contact have the same blocks, all of them whole, as in
/// most files. Otherwise false, and nothing is read.
bool Sweeps::readContactBlocks(int contact) {
  const DelassusMatrix::Sparse& W = problem_->W.entries();
  const int *begin = W.outerIndexPtr() + 3 * contact, *columns = W.innerIndexPtr() + begin[0];
  const int count = begin[1] - begin[0];
  if (count % 3 != 0 || begin[2] - begin[1] != count || begin[3] - begin[2] != count) return false;
  for (int k = 0; k < count; ++k) {
    const int column = columns[k - k % 3] + k % 3;
    if (columns[k] != column || columns[k + count] != column || columns[k + 2 * count] != column)
      return false;
  }
  for (int k = 0; k < count; k += 3)
    if (columns[k] % 3 != 0 || columns[k] >= 3 * problem_->contacts()) return false;

  using Rows = Eigen::Map<const Mat3, 0, Eigen::Stride<1, Eigen::Dynamic>>;
  const double* entries = W.valuePtr() + begin[0];
  for (int k = 0; k < count; k += 3) {
    if (columns[k] == 3 * contact) continue;
    coupled_.push_back(columns[k] / 3);
    coupling_.emplace_back(Rows(entries + k, {1, count}));
  }
  return true;
}

/// `slot`: the place of the block with another contact; not valid if it lies before the blocks of
/// this contact.
void Sweeps::readContactRows(int contact, std::vector<int>& slot) {
  const DelassusMatrix::Sparse& W = problem_->W.entries();
  const auto first = static_cast<int>(coupled_.size());
  for (int k = 0; k < 3; ++k) {
    for (DelassusMatrix::Sparse::InnerIterator it(W, 3 * contact + k); it; ++it) {
      const auto column = static_cast<int>(it.col());
      if (column >= 3 * problem_->contacts()) break;
      if (column / 3 == contact) continue;
      int& at = slot[column / 3];
      if (at < first) {
        at = static_cast<int>(coupled_.size());
        coupled_.push_back(column / 3);
        coupling_.emplace_back(Mat3::Zero());
      }
      coupling_[at](k, column % 3) = it.value();
    }
  }
}

Vec2 Sweeps::nextOnDisk(int k, const VectorXd& r, const Vec2& u) const {
  const Disk& disk = problem_->disks[k];
  // Like a contact with friction 1 whose normal reaction is the radius: W_nn = 1, q_n = −radius.
  Mat3 W = Mat3::Identity();
  W.bottomRightCorner<2, 2>() = diskBlocks_[k];
  Vec3 q(-disk.radiusAt(r), 0, 0);
  q.tail<2>() = u - diskBlocks_[k] * disk.of(r);
  return solveOneContact(W, q, 1).tail<2>();
}

void Sweeps::sweep(int count, VectorXd& r) {
  learnt_ = false;
  conjugate_.start(*diagonal_);
  hurry(conjugate_, count, r);
}

void Sweeps::sweepPlainly(int count, VectorXd& r) {
  learnt_ = false;
  problem_->W.bodySpace().impulse(r, y_);
  for (int k = 0; k < count; ++k) sweepBodies(r);
}

void Sweeps::sweepOn(int count, int memory, VectorXd& r) {
  // Measured on problem files, whose W is explicit: with 2, two of 40 need no regions, and the
  // others need as many as before. The heaps of worlds need 1.
  const double growth = problem_->W.inBodySpace() ? 1 : 2;
  if (!learnt_ || swept_ != r) anderson_.start(*diagonal_, memory, growth);
  learnt_ = true;
  hurry(anderson_, count, r);
}

template <class Acceleration>
void Sweeps::hurry(Acceleration& acceleration, int count, VectorXd& r) {
  if (problem_->W.inBodySpace()) problem_->W.bodySpace().impulse(r, y_);
  for (int k = 0; k < count; ++k) {
    swept_ = r;
    yBefore_ = y_;
    sweepOnce(swept_);
    if (k + 1 == count) break;
    acceleration.next(swept_, r);
    if (problem_->W.inBodySpace()) follow(acceleration, r);
  }
  // The last sweep brings reactions that overshot back into the cones.
  if (count > 0) r = swept_;
}

void Sweeps::follow(ConjugateGradient& acceleration, const VectorXd&) {
  acceleration.nextImage(y_, yBefore_);
  y_.swap(yBefore_);
}

void Sweeps::follow(Anderson&, const VectorXd& r) { problem_->W.bodySpace().impulse(r, y_); }

void Sweeps::sweepOnce(VectorXd& r) {
  problem_->W.inBodySpace() ? sweepBodies(r) : sweepEntries(r);
}

void Sweeps::sweepBodies(VectorXd& r) {
  sweepContacts(*problem_, blocks_.data(), *diagonal_, y_, r);
  sweepRows(*problem_, *diagonal_, y_, r);
  for (std::size_t k = 0; k < problem_->disks.size(); ++k) sweepDisk(static_cast<int>(k), r);
}

double Sweeps::velocityOf(int unknown, const VectorXd& r) const {
  const BodySpace& space = problem_->W.bodySpace();
  const auto& c = space.rows[unknown - 3 * space.contacts.size()];
  double u = problem_->q[unknown] + space.compliance[unknown] * r[unknown] + c.relativeVelocity(y_);
  for (const BodySpace::Part& p : space.partsOf(unknown))
    u += p.J.row(0).dot(y_.segment<6>(6 * p.body));
  return u;
}

void Sweeps::react(int unknown, double next, VectorXd& r) {
  const BodySpace& space = problem_->W.bodySpace();
  const auto& c = space.rows[unknown - 3 * space.contacts.size()];
  const double dr = next - r[unknown];
  c.addImpulse(dr, y_);
  for (const BodySpace::Part& p : space.partsOf(unknown))
    y_.segment<6>(6 * p.body) += p.J.row(0).transpose() * dr;
  r[unknown] = next;
}

void Sweeps::sweepDisk(int k, VectorXd& r) {
  const Disk& disk = problem_->disks[k];
  if (!(diskBlocks_[k].trace() > 0)) return;
  const bool pair = disk.unknowns == 2;
  const Vec2 u(velocityOf(disk.first, r), pair ? velocityOf(disk.first + 1, r) : 0);
  const Vec2 next = nextOnDisk(k, r, u);
  react(disk.first, next[0], r);
  if (pair) react(disk.first + 1, next[1], r);
}

void Sweeps::sweepEntries(VectorXd& r) {
  const VectorXd& diagonal = *diagonal_;
  const DelassusMatrix::Sparse& W = problem_->W.entries();
  const int n = problem_->contacts();
  for (int i = 0; i < n; ++i) {
    const int at = 3 * i;
    if (!(diagonal[at] > 0)) continue;
    Vec3 q = problem_->q.segment<3>(at);  // its velocity without its own reaction
    for (int k = couplingBegin_[i]; k < couplingBegin_[i + 1]; ++k)
      q += coupling_[k] * r.segment<3>(3 * coupled_[k]);
    for (int k = 0; k < 3; ++k)
      for (DelassusMatrix::Sparse::ReverseInnerIterator it(W, at + k); it && it.col() >= 3 * n;
           --it)
        q[k] += it.value() * r[it.col()];
    r.segment<3>(at) = blocks_[i].solve(q, problem_->friction[i], r.segment<3>(at));
  }
  const auto velocityOf = [&](int unknown) {
    double u = problem_->q[unknown];
    for (DelassusMatrix::Sparse::InnerIterator it(W, unknown); it; ++it)
      u += it.value() * r[it.col()];
    return u;
  };
  for (int at = 3 * n; at < problem_->disksBegin(); ++at) {
    if (!(diagonal[at] > 0)) continue;
    r[at] = boundedRow(r[at], velocityOf(at), diagonal[at], problem_->lower[at - 3 * n],
                       problem_->upper[at - 3 * n]);
  }
  for (std::size_t k = 0; k < problem_->disks.size(); ++k) {
    const Disk& disk = problem_->disks[k];
    if (!(diskBlocks_[k].trace() > 0)) continue;
    const Vec2 u(velocityOf(disk.first), disk.unknowns == 2 ? velocityOf(disk.first + 1) : 0);
    disk.put(nextOnDisk(static_cast<int>(k), r, u), r);
  }
}

}  // namespace delassus
