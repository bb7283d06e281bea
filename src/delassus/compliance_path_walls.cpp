/// Steps from wall to wall of the regions along a path of compliance.
#include <algorithm>
#include <cmath>

#include "delassus/compliance_path.h"

namespace delassus {

int CompliancePath::wallsOf(int part) const {
  const int n = static_cast<int>(region_.contacts.size());
  return (part < n ? region_.contacts[part] == Mode::Slide
                   : region_.rows[part - n] == RowState::Free)
             ? 2
             : 1;
}

/// The distance of a part's z from a wall of its mode, positive inside. A sliding contact comes to
/// rest at its first wall and opens at its second. A held row has its lower bound first, then its
/// upper bound.
CompliancePath::Gap CompliancePath::gapTo(int part, int side, const VectorXd& change) const {
  const int n = static_cast<int>(region_.contacts.size());
  if (part >= n) {
    const int at = 2 * n + part;
    const RowState state = region_.rows[part - n];
    const double lower = problem_->lower[part - n], upper = problem_->upper[part - n];
    if (state == RowState::AtLower) return {lower - z_[at], -change[at]};
    if (state == RowState::AtUpper) return {z_[at] - upper, change[at]};
    return side == 0 ? Gap{z_[at] - lower, change[at]} : Gap{upper - z_[at], -change[at]};
  }
  const int at = 3 * part;
  const Mode mode = region_.contacts[part];
  if (mode == Mode::Open) return {-z_[at], -change[at]};
  if (side == 1) return {z_[at], change[at]};
  const double zt = delassus::lengthOf(z_[at + 1], z_[at + 2]), mu = problem_->friction[part];
  const double along = zt > 0 ? (z_[at + 1] * change[at + 1] + z_[at + 2] * change[at + 2]) / zt
                              : delassus::lengthOf(change[at + 1], change[at + 2]);
  const double sign = mode == Mode::Stick ? 1 : -1;
  return {sign * (mu * z_[at] - zt), sign * (mu * change[at] - along)};
}

double CompliancePath::leastGap(int part) const {
  double least = gapTo(part, 0, z_).value;
  if (wallsOf(part) == 2) least = std::min(least, gapTo(part, 1, z_).value);
  return least;
}

void CompliancePath::pass(const Wall& wall) {
  const int n = static_cast<int>(region_.contacts.size());
  if (wall.part < n) {
    Mode& mode = region_.contacts[wall.part];
    mode = mode != Mode::Slide ? Mode::Slide : wall.side == 0 ? Mode::Stick : Mode::Open;
  } else {
    RowState& state = region_.rows[wall.part - n];
    state = state != RowState::Free ? RowState::Free
            : wall.side == 0        ? RowState::AtLower
                                    : RowState::AtUpper;
  }
}

/// Finds the walls ahead within this length of tangent, the nearest first. A wall that z has passed
/// already counts as at 0 if z moves further away from it.
void CompliancePath::findWalls(double within) {
  changeOfZ(tangent_.delta, tangent_.tau, alongZ_);
  walls_.clear();
  for (int part = 0; part < parts(); ++part)
    for (int side = 0; side < wallsOf(part); ++side) {
      const Gap gap = gapTo(part, side, alongZ_);
      if (!(gap.growth < 0)) continue;
      const double ahead = std::max(0.0, -gap.value / gap.growth);
      if (ahead < within) walls_.push_back({part, side, ahead});
    }
  std::sort(walls_.begin(), walls_.end(), [](const Wall& a, const Wall& b) {
    return a.ahead != b.ahead ? a.ahead < b.ahead
           : a.part != b.part ? a.part < b.part
                              : a.side < b.side;
  });
}

/// Goes to the point where the curve meets the wall, by Newton's method in this region.
bool CompliancePath::meetWall(const Wall& wall, WorkDone& count) {
  constexpr int mostSteps = 6;
  if (wall.ahead == 0) {
    respond(true);
    return true;
  }
  for (int k = 0;; ++k) {
    respond(true);
    const double now = error();
    if (!std::isfinite(now)) return false;
    if (now <= 10 * noise() && std::abs(gapTo(wall.part, wall.side, z_).value) <= gapNoise())
      return true;
    if (k == mostSteps || !factorise(count)) return false;
    findDrive();
    motion_->solve(error_);
    changeOfZ(error_, 0, alongZ_);
    changeOfZ(drive_, 1, acrossZ_);
    const Gap off = gapTo(wall.part, wall.side, alongZ_);
    const double x = (off.growth - off.value) / gapTo(wall.part, wall.side, acrossZ_).growth;
    if (!std::isfinite(x)) return false;
    here_.delta += x * drive_ - error_;
    here_.tau += x;
  }
}

/// Whether a part is beyond a wall, and farther than before.
bool CompliancePath::hasLeftRegion() const {
  for (int part = 0; part < parts(); ++part) {
    const double gap = leastGap(part);
    if (gap < -gapNoise() && gap < gaps_[part]) return true;
  }
  return false;
}

/// The gap that rounding leaves, N·s.
double CompliancePath::gapNoise() const { return push_ * std::max(1e-10, 1e-14 / compliance()); }

/// Goes to the first wall of the region and through it, or within the region if that wall is far.
bool CompliancePath::stepToWall(WorkDone& count) {
  constexpr double farthest = 0.5, mostTau = 0.7, near = 0.5, tiny = 1e-9;
  constexpr std::size_t mostWalls = 6;
  from_ = here_;
  respond(true);
  push_ = r_.cwiseAbs().maxCoeff();
  if (!factorise(count)) return false;
  findTangent();
  takeTangent();
  gaps_.resize(parts());
  for (int part = 0; part < parts(); ++part) gaps_[part] = leastGap(part);
  const double within = std::min(farthest, mostTau / std::abs(tangent_.tau));
  findWalls(within);

  for (std::size_t k = 0; k < std::min(walls_.size(), mostWalls); ++k) {
    const Wall wall = walls_[k];
    advance(wall.ahead);
    if (!meetWall(wall, count)) continue;
    if (strayed(wall.ahead) > near * wall.ahead + tiny || hasLeftRegion()) continue;
    pass(wall);
    respond(true);
    if (!factorise(count)) return false;
    findTangent();
    takeTangent();
    return true;
  }
  double length = walls_.empty() ? within : 0.5 * std::max(walls_.front().ahead, tiny);
  for (; length > 1e-3 * tiny; length /= 4)
    if (stepInRegion(length, count)) return true;
  goBack();
  return false;
}

/// A step that passes no wall.
bool CompliancePath::stepInRegion(double length, WorkDone& count) {
  constexpr double near = 0.5, likeness = 0.3;
  constexpr int mostSteps = 6;
  advance(length);
  if (!meetCurve(true, mostSteps, count)) return false;
  if (strayed(length) > near * length || hasLeftRegion() || !factorise(count) ||
      findTangent() < likeness)
    return false;
  takeTangent();
  return true;
}

}  // namespace delassus
