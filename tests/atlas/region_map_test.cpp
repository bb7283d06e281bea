// The regions that the atlas draws are those of the paper (§7-§8): they fill the plane once, in the
// order of its figure.
#include "demos/atlas/region_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>

#include "delassus/release.h"

namespace demos::atlas {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;

Matrix2d randomW(std::mt19937_64& random) {
  std::uniform_real_distribution<double> diagonal(0.1, 10), cosine(-0.98, 0.98);
  const double A1 = diagonal(random), A2 = diagonal(random);
  const double B = cosine(random) * std::sqrt(A1 * A2);
  return (Matrix2d() << A1, B, B, A2).finished();
}

double angle(const Vector2d& from, const Vector2d& to) {
  const double turn = std::atan2(to.y(), to.x()) - std::atan2(from.y(), from.x());
  return turn < 0 ? turn + 2 * M_PI : turn;
}

TEST(RegionsOf, FillThePlaneOnce) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 200; ++i) {
    double sum = 0;
    std::set<std::string> names;
    for (const Sector& sector : regionsOf(randomW(random))) {
      EXPECT_LT(angle(sector.from, sector.to), M_PI);
      sum += angle(sector.from, sector.to);
      names.insert(sector.name);
    }
    EXPECT_NEAR(sum, 2 * M_PI, 1e-12);
    EXPECT_EQ(names, (std::set<std::string>{"M_{Λ₁Λ₂}", "M_{Λ₁}", "M_{Λ₂}", "M_{l}"}));
  }
}

TEST(RegionsOf, HoldOneAnswerEach) {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> share(0.001, 0.999);
  for (int i = 0; i < 200; ++i) {
    const Matrix2d W = randomW(random);
    for (const Sector& sector : regionsOf(W)) {
      const double s = share(random);
      const Vector2d f = (1 - s) * sector.from.normalized() + s * sector.to.normalized();
      EXPECT_EQ(nameOf(delassus::analyseRelease(W, -W * f).persisting), sector.name)
          << "W\n"
          << W << "\nf " << f.transpose();
    }
  }
}

}  // namespace
}  // namespace demos::atlas
