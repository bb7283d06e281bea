#include "delassus/fill_groups.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "delassus/lanes.h"
#include "delassus/length.h"

namespace delassus {
namespace {

constexpr double leastDeterminant = 1e-6;  ///< of the W of a disk, in its units, that is inverted
constexpr float unmoved = 0;               ///< Δr_n of a governor that is not swept

/// J̃ of the contacts, rows or disks of a group, `count` numbers per body, in their units; zero for
/// a missing body.
template <int count>
class JacobiansOfLanes {
 public:
  /// Also notes the bodies in the group.
  template <class Part, class Group>
  void put(const Part& part, double perUnit, int lane, Group& g) {
    put(part.a, part.Ja, perUnit, a_[lane], g.a[lane]);
    put(part.b, part.Jb, perUnit, b_[lane], g.b[lane]);
  }
  template <class Group>
  void turnOver(Group& g) const {
    turnOver(a_, g.Ja);
    turnOver(b_, g.Jb);
  }

 private:
  static constexpr int padded = (count + 3) / 4 * 4;  ///< four numbers at a time are transposed
  using Jacobians = float[lanes][padded];

  template <class Rows>
  static void put(int body, const Rows& J, double perUnit, float* to, int& place) {
    if (body < 0) return;
    place = body;
    for (int k = 0; k < count; ++k) to[k] = static_cast<float>(perUnit * J.data()[k]);
  }
  static void turnOver(const Jacobians& from, Lanes* to) {
    const float* rows[lanes];
    for (int lane = 0; lane < lanes; ++lane) rows[lane] = from[lane];
    for (int k = 0; k < count; k += 4) {
      Lanes4 low[4], high[4];
      gather(rows, k, low);
      gather(rows + 4, k, high);
      for (int i = 0; i < 4 && k + i < count; ++i) {
        store(low[i], to[k + i]);
        store(high[i], to[k + i] + 4);
      }
    }
  }

  Jacobians a_ = {}, b_ = {};
};

}  // namespace

void fill(const Problem& problem, const NaturalMap& map, ContactGroup& g) {
  const BodySpace& space = problem.W.bodySpace();
  JacobiansOfLanes<18> jacobians;
  for (int lane = 0; lane < lanes; ++lane) {
    const int i = g.at[lane];
    if (i == vacant) {  // the lane acts as a contact that stays open
      for (int k = 0; k < 3; ++k) g.compliance[k][lane] = 0;
      g.w1[lane] = g.w2[lane] = g.s01[lane] = g.friction[lane] = 0;
      g.s00[lane] = g.s11[lane] = g.perDet[lane] = g.unit[lane] = 1;
      continue;
    }
    const Mat3& W = map.contactBlock(i);
    const double per = 1 / W(0, 0), unit = std::sqrt(W(0, 0));
    jacobians.put(space.contacts[i], unit * per, lane, g);
    g.unit[lane] = static_cast<float>(unit);
    for (int k = 0; k < 3; ++k)
      g.compliance[k][lane] = static_cast<float>(per * space.compliance[3 * i + k]);
    const double w1 = W(1, 0) * per, w2 = W(2, 0) * per;
    const double s00 = W(1, 1) * per - w1 * w1, s01 = W(1, 2) * per - w1 * w2,
                 s11 = W(2, 2) * per - w2 * w2;
    g.w1[lane] = static_cast<float>(w1);
    g.w2[lane] = static_cast<float>(w2);
    g.s00[lane] = static_cast<float>(s00);
    g.s01[lane] = static_cast<float>(s01);
    g.s11[lane] = static_cast<float>(s11);
    g.perDet[lane] = static_cast<float>(1 / (s00 * s11 - s01 * s01));
    g.friction[lane] = static_cast<float>(problem.friction[i]);
  }
  jacobians.turnOver(g);
}

void fill(const Problem& problem, const NaturalMap& map, RowGroup& g) {
  const BodySpace& space = problem.W.bodySpace();
  JacobiansOfLanes<6> jacobians;
  for (int lane = 0; lane < lanes; ++lane) {
    const int at = g.at[lane];
    if (at == vacant) {
      g.compliance[lane] = 0;
      g.unit[lane] = 1;
      continue;
    }
    const double W = map.diagonal()[at], unit = std::sqrt(W);
    jacobians.put(space.rows[at - 3 * problem.contacts()], 1 / unit, lane, g);
    g.unit[lane] = static_cast<float>(unit);
    g.compliance[lane] = static_cast<float>(space.compliance[at] / W);
  }
  jacobians.turnOver(g);
}

void fill(const Problem& problem, const std::vector<SweptLoad>& loads, DiskGroup& g) {
  const BodySpace& space = problem.W.bodySpace();
  JacobiansOfLanes<12> jacobians;
  for (int lane = 0; lane < lanes; ++lane) {
    g.p00[lane] = g.p11[lane] = g.w00[lane] = g.w11[lane] = g.unit[lane] = 1;
    g.p01[lane] = g.w01[lane] = g.perLoad[lane] = 0;
    g.load[lane] = &unmoved;
    g.loadUnit[lane] = 1;
    if (g.at[lane] == vacant) continue;
    const Disk& disk = problem.disks[g.at[lane]];
    Mat2 W = Mat2::Zero();
    if (disk.unknowns == 2)
      W = problem.W.pairBlock(disk.first);
    else
      W(0, 0) = W(1, 1) = problem.W.diagonalOfRow(disk.first);
    const double largest = 0.5 * (W.trace() + lengthOf(W(0, 0) - W(1, 1), 2 * W(0, 1)));
    const double unit = std::sqrt(largest);
    const Mat2 scaled = W / largest;
    g.w00[lane] = static_cast<float>(scaled(0, 0));
    g.w01[lane] = static_cast<float>(scaled(0, 1));
    g.w11[lane] = static_cast<float>(scaled(1, 1));
    if (scaled.determinant() > leastDeterminant) {
      const Mat2 inverse = scaled.inverse();
      g.p00[lane] = static_cast<float>(inverse(0, 0));
      g.p01[lane] = static_cast<float>(inverse(0, 1));
      g.p11[lane] = static_cast<float>(inverse(1, 1));
    }
    g.unit[lane] = static_cast<float>(unit);
    const ScalarRow* const rows = &space.rows[disk.first - 3 * problem.contacts()];
    struct {
      int a, b;
      Eigen::Matrix<double, 12, 1> Ja, Jb;
    } pair{rows->a, rows->b, Eigen::Matrix<double, 12, 1>::Zero(),
           Eigen::Matrix<double, 12, 1>::Zero()};
    for (int k = 0; k < disk.unknowns; ++k) {
      pair.Ja.segment<6>(6 * k) = rows[k].Ja.transpose();
      pair.Jb.segment<6>(6 * k) = rows[k].Jb.transpose();
    }
    jacobians.put(pair, 1 / unit, lane, g);
    const SweptLoad& load = loads[g.at[lane]];
    if (load.dr) g.load[lane] = load.dr;
    g.loadUnit[lane] = load.unit;
    g.perLoad[lane] = static_cast<float>(unit * disk.radius / load.unit);
  }
  jacobians.turnOver(g);
}

void start(const Problem& problem, const VectorXd& r, const VectorXd& u, double scale,
           ContactGroup& g) {
  for (int lane = 0; lane < lanes; ++lane) {
    const int i = g.at[lane];
    Vec3 r0 = Vec3::Zero(), u0 = Vec3::UnitX();
    double friction = 0;
    if (i != vacant) {
      const double unit = scale * g.unit[lane], perUnit = scale / g.unit[lane];
      r0 = unit * r.segment<3>(3 * i);
      u0 = perUnit * u.segment<3>(3 * i);
      friction = problem.friction[i];
    }
    const double braked = lengthOf(r0[1], r0[2]);
    for (int k = 0; k < 3; ++k) {
      g.r0[k][lane] = static_cast<float>(r0[k]);
      g.u0[k][lane] = static_cast<float>(u0[k]);
      g.dr[k][lane] = g.drBefore[k][lane] = 0;
    }
    g.length0[lane] = static_cast<float>(braked);
    g.margin0[lane] = static_cast<float>(friction * r0[0] - braked);
    const double slip = braked > 0 ? lengthOf(u0[1], u0[2]) / braked : 0;
    const float s = g.slip0[lane] = static_cast<float>(std::min<double>(slip, mostSlip));
    g.dslip[lane] = 0;
    g.unslowed0[0][lane] = static_cast<float>(u0[1] - g.w1[lane] * u0[0] + s * r0[1]);
    g.unslowed0[1][lane] = static_cast<float>(u0[2] - g.w2[lane] * u0[0] + s * r0[2]);
  }
}

void start(const Problem& problem, const VectorXd& r, const VectorXd& u, double scale,
           RowGroup& g) {
  for (int lane = 0; lane < lanes; ++lane) {
    const int i = g.at[lane], row = i - 3 * problem.contacts();
    const bool isThere = i != vacant;
    const double unit = scale * g.unit[lane];
    g.u0[lane] = isThere ? static_cast<float>(scale * u[i] / g.unit[lane]) : 0;
    g.lower[lane] = isThere ? static_cast<float>(unit * (problem.lower[row] - r[i])) : 0;
    g.upper[lane] = isThere ? static_cast<float>(unit * (problem.upper[row] - r[i])) : 0;
    g.dr[lane] = g.drBefore[lane] = 0;
  }
}

void start(const Problem& problem, const VectorXd& r, const VectorXd& u, double scale,
           DiskGroup& g) {
  const auto put = [](double x, float& to) { to = static_cast<float>(x); };
  for (int lane = 0; lane < lanes; ++lane) {
    Vec2 r0 = Vec2::Zero(), u0 = Vec2::Zero();
    double radius = 0, load = 0, mostLoad = 0;
    if (g.at[lane] != vacant) {
      const Disk& disk = problem.disks[g.at[lane]];
      const double unit = scale * g.unit[lane];
      r0 = unit * disk.of(r);
      u0 = scale * disk.of(u) / g.unit[lane];
      radius = unit * disk.radiusAt(r);
      load = r[disk.governor];
      mostLoad = disk.mostLoad;
    }
    const double length = lengthOf(r0[0], r0[1]);
    const double slip =
        length > 0 ? std::min<double>(lengthOf(u0[0], u0[1]) / length, mostSlip) : 0;
    put(-load * scale * g.loadUnit[lane], g.leastLoad[lane]);
    put((mostLoad - load) * scale * g.loadUnit[lane], g.mostLoad[lane]);
    g.noLoad[lane] = std::clamp(0.0F, g.leastLoad[lane], g.mostLoad[lane]);
    put(length, g.length0[lane]);
    put(radius - length, g.margin0[lane]);
    put(slip, g.slip0[lane]);
    g.dslip[lane] = 0;
    for (int k = 0; k < 2; ++k) {
      put(r0[k], g.r0[k][lane]);
      put(u0[k], g.u0[k][lane]);
      put(u0[k] + double(g.slip0[lane]) * r0[k], g.unslowed0[k][lane]);
      g.dr[k][lane] = g.drBefore[k][lane] = 0;
    }
  }
}

}  // namespace delassus
