#include "delassus/level_scaling.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace delassus {
namespace {

constexpr int unreached = std::numeric_limits<int>::max() / 2;

/// Whether a reaction may be multiplied by any positive number.
bool isFreeToScale(double lower, double upper) {
  return (lower == 0 || std::isinf(lower)) && (upper == 0 || std::isinf(upper));
}

}  // namespace

bool LevelScaling::setProblem(const Problem& problem) {
  if (!problem.W.inBodySpace() || !problem.disks.empty()) return false;
  const BodySpace& space = problem.W.bodySpace();
  if (!space.parts.empty()) return false;
  for (int i = 0; i < problem.rows(); ++i)
    if (!isFreeToScale(problem.lower[i], problem.upper[i])) return false;
  findLevels(space);
  return true;
}

void LevelScaling::findLevels(const BodySpace& space) {
  levelOfBody_.assign(space.bodies, unreached);
  const auto levelOf = [&](int body) { return body >= 0 ? levelOfBody_[body] : 0; };
  // Piles are mostly listed from the ground: few passes find all.
  bool changed = true;
  const auto reach = [&](int body, int level) {
    if (body < 0 || levelOfBody_[body] <= level) return;
    levelOfBody_[body] = level;
    changed = true;
  };
  const auto link = [&](const auto& c) {
    reach(c.a, levelOf(c.b) + 1);
    reach(c.b, levelOf(c.a) + 1);
  };
  while (changed) {
    changed = false;
    for (const ContactRows& c : space.contacts) link(c);
    for (const BodySpace::ScalarRow& c : space.rows) link(c);
  }

  // What flies is one level.
  levels_ = 1;
  for (int& level : levelOfBody_) {
    if (level >= unreached) level = 0;
    levels_ = std::max(levels_, level + 1);
  }
  levelOf_.clear();
  const auto note = [&](const auto& c) {
    levelOf_.push_back(std::max(levelOf(c.a), levelOf(c.b)));
  };
  for (const ContactRows& c : space.contacts) note(c);
  for (const BodySpace::ScalarRow& c : space.rows) note(c);
}

void LevelScaling::collect(const Problem& problem, const VectorXd& r) {
  const BodySpace& space = problem.W.bodySpace();
  for (VectorXd* sum : {&below_, &above_, &probeBelow_, &probeAbove_})
    sum->setZero(6 * space.bodies);
  equations_.assign(levels_, {0, 0, 0, 0, 1});
  const auto add = [&](int body, int level, const Vec6& impulse, const Vec6& probe) {
    const bool below = levelOfBody_[body] == level;
    (below ? below_ : above_).segment<6>(6 * body) += impulse;
    (below ? probeBelow_ : probeAbove_).segment<6>(6 * body) += probe;
  };
  int at = 0;
  const int* level = levelOf_.data();
  for (const ContactRows& c : space.contacts) {
    const Vec3 reaction = r.segment<3>(at);
    Equation& equation = equations_[*level];
    equation.q += reaction[0] * problem.q[at];
    equation.diagonal += reaction[0] * reaction[0] * space.compliance[at];
    const auto addShare = [&](int body, const Mat36& J) {
      if (body < 0) return;
      const Vec6 normal = J.row(0).transpose() * reaction[0];
      add(body, *level, normal + J.bottomRows<2>().transpose() * reaction.tail<2>(), normal);
    };
    addShare(c.a, c.Ja);
    addShare(c.b, c.Jb);
    at += 3;
    ++level;
  }
  for (const BodySpace::ScalarRow& c : space.rows) {
    Equation& equation = equations_[*level];
    equation.q += r[at] * problem.q[at];
    equation.diagonal += r[at] * r[at] * space.compliance[at];
    const auto addShare = [&](int body, const Row6& J) {
      if (body < 0) return;
      const Vec6 impulse = J.transpose() * r[at];
      add(body, *level, impulse, impulse);
    };
    addShare(c.a, c.Ja);
    addShare(c.b, c.Jb);
    ++at;
    ++level;
  }
  for (int body = 0; body < space.bodies; ++body) {
    const int own = levelOfBody_[body];
    const auto below = below_.segment<6>(6 * body), above = above_.segment<6>(6 * body);
    const auto probeBelow = probeBelow_.segment<6>(6 * body);
    const auto probeAbove = probeAbove_.segment<6>(6 * body);
    equations_[own].diagonal += probeBelow.dot(below);
    if (own + 1 == levels_) continue;
    equations_[own].upper += probeBelow.dot(above);
    equations_[own + 1].lower += probeAbove.dot(below);
    equations_[own + 1].diagonal += probeAbove.dot(above);
  }
}

/// By elimination from the ground up. False if there is no solution with positive factors.
bool LevelScaling::solve() {
  for (int l = 0; l < levels_; ++l) {
    Equation& own = equations_[l];
    // A level without reactions keeps them; no other feels it.
    if (own.diagonal == 0) own = {0, 1, 0, -1, 1};
    if (l > 0) {
      const Equation& last = equations_[l - 1];
      const double share = own.lower / last.diagonal;
      own.diagonal -= share * last.upper;
      own.q -= share * last.q;
    }
    if (!(own.diagonal > 0)) return false;
  }
  double above = 0;
  for (int l = levels_; l-- > 0;) {
    Equation& own = equations_[l];
    own.factor = -(own.q + own.upper * above) / own.diagonal;
    if (!(own.factor > 0 && std::isfinite(own.factor))) return false;
    above = own.factor;
  }
  return true;
}

void LevelScaling::scale(const Problem& problem, VectorXd& r, VectorXd& y) {
  collect(problem, r);
  if (!solve()) return;
  const int contacts = problem.contacts();
  const auto factorOf = [&](int part) { return equations_[levelOf_[part]].factor; };
  for (int i = 0; i < contacts; ++i) r.segment<3>(3 * i) *= factorOf(i);
  for (int i = 0; i < problem.rows(); ++i) r[3 * contacts + i] *= factorOf(contacts + i);
  const auto bodies = static_cast<int>(levelOfBody_.size());
  for (int body = 0; body < bodies; ++body) {
    const int own = levelOfBody_[body];
    y.segment<6>(6 * body) = equations_[own].factor * below_.segment<6>(6 * body);
    if (own + 1 < levels_)
      y.segment<6>(6 * body) += equations_[own + 1].factor * above_.segment<6>(6 * body);
  }
}

}  // namespace delassus
