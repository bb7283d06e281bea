#include "delassus/sweeps.h"

#include <algorithm>
#include <cmath>

#include "delassus/one_contact.h"

namespace delassus {
namespace {

double boundedRow(double r, double u, double diagonal, double lower, double upper) {
  return std::clamp(r - u / diagonal, lower, upper);
}

}  // namespace

void Sweeps::setProblem(const Problem& problem) {
  blocks_.resize(problem.contacts());
  for (int i = 0; i < problem.contacts(); ++i) blocks_[i] = problem.W.contactBlock(3 * i);
  problem.W.diagonal(diagonal_);
}

void Sweeps::sweep(const Problem& problem, int count, VectorXd& r) {
  direction_.setZero(r.size());
  double lastEnergy = 0;
  for (int k = 1; k < count; ++k) {
    before_ = r;
    sweepOnce(problem, r);
    change_ = r - before_;
    const double energy = change_.dot(diagonal_.cwiseProduct(change_));
    const double beta = lastEnergy > 0 ? energy / lastEnergy : 2;
    lastEnergy = energy;
    if (beta > 1) {
      direction_ = change_;
    } else {
      r += beta * direction_;
      direction_ = beta * direction_ + change_;
    }
  }
  // The last sweep brings what overshot back into the cones.
  if (count > 0) sweepOnce(problem, r);
}

void Sweeps::sweepOnce(const Problem& problem, VectorXd& r) {
  problem.W.inBodySpace() ? sweepBodies(problem, r) : sweepEntries(problem, r);
}

void Sweeps::sweepBodies(const Problem& problem, VectorXd& r) {
  const BodySpace& space = problem.W.bodySpace();
  space.impulse(r, y_);
  int at = 0;
  for (std::size_t i = 0; i < space.contacts.size(); ++i, at += 3) {
    if (!(diagonal_[at] > 0)) continue;
    const auto& c = space.contacts[i];
    Vec3 u =
        problem.q.segment<3>(at) + space.compliance.segment<3>(at).cwiseProduct(r.segment<3>(at));
    if (c.a >= 0) u.noalias() += c.Ja * y_.segment<6>(6 * c.a);
    if (c.b >= 0) u.noalias() += c.Jb * y_.segment<6>(6 * c.b);
    const BodySpace::PartRange parts = space.partsOf(at);
    for (const BodySpace::Part& p : parts) u.noalias() += p.J * y_.segment<6>(6 * p.body);
    const Vec3 next = solveOneContact(blocks_[i], u - blocks_[i] * r.segment<3>(at),
                                      problem.friction[static_cast<int>(i)]);
    const Vec3 dr = next - r.segment<3>(at);
    if (c.a >= 0) y_.segment<6>(6 * c.a).noalias() += c.Ja.transpose() * dr;
    if (c.b >= 0) y_.segment<6>(6 * c.b).noalias() += c.Jb.transpose() * dr;
    for (const BodySpace::Part& p : parts)
      y_.segment<6>(6 * p.body).noalias() += p.J.transpose() * dr;
    r.segment<3>(at) = next;
  }
  for (std::size_t i = 0; i < space.rows.size(); ++i, ++at) {
    if (!(diagonal_[at] > 0)) continue;
    const auto& c = space.rows[i];
    const int row = static_cast<int>(i);
    double u = problem.q[at] + space.compliance[at] * r[at];
    if (c.a >= 0) u += c.Ja.dot(y_.segment<6>(6 * c.a));
    if (c.b >= 0) u += c.Jb.dot(y_.segment<6>(6 * c.b));
    const BodySpace::PartRange parts = space.partsOf(at);
    for (const BodySpace::Part& p : parts) u += p.J.row(0).dot(y_.segment<6>(6 * p.body));
    const double next = boundedRow(r[at], u, diagonal_[at], problem.lower[row], problem.upper[row]);
    const double dr = next - r[at];
    if (c.a >= 0) y_.segment<6>(6 * c.a) += c.Ja.transpose() * dr;
    if (c.b >= 0) y_.segment<6>(6 * c.b) += c.Jb.transpose() * dr;
    for (const BodySpace::Part& p : parts) y_.segment<6>(6 * p.body) += p.J.row(0).transpose() * dr;
    r[at] = next;
  }
}

void Sweeps::sweepEntries(const Problem& problem, VectorXd& r) {
  const DelassusMatrix::Sparse& W = problem.W.entries();
  const int n = problem.contacts();
  for (int i = 0; i < n; ++i) {
    const int at = 3 * i;
    if (!(diagonal_[at] > 0)) continue;
    Vec3 u = problem.q.segment<3>(at);
    for (int k = 0; k < 3; ++k)
      for (DelassusMatrix::Sparse::InnerIterator it(W, at + k); it; ++it)
        u[k] += it.value() * r[it.col()];
    const Vec3 next =
        solveOneContact(blocks_[i], u - blocks_[i] * r.segment<3>(at), problem.friction[i]);
    r.segment<3>(at) = next;
  }
  for (int at = 3 * n; at < problem.size(); ++at) {
    if (!(diagonal_[at] > 0)) continue;
    double u = problem.q[at];
    for (DelassusMatrix::Sparse::InnerIterator it(W, at); it; ++it) u += it.value() * r[it.col()];
    const double next =
        boundedRow(r[at], u, diagonal_[at], problem.lower[at - 3 * n], problem.upper[at - 3 * n]);
    r[at] = next;
  }
}

}  // namespace delassus
