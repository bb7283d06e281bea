// Other units leave the regions as they are. With lengths times 2^a, masses times 2^b and the same
// time, the bits are the same.

#include <gtest/gtest.h>

#include <cmath>

#include "delassus/solver.h"
#include "tests/support/pressed_piles.h"
#include "tests/support/random_piles.h"
#include "tests/support/sphere_heaps.h"

namespace delassus::test {
namespace {

/// Powers of four for masses, since then their roots are exact too.
void expectSameBits(const Pile& pile, int lengths, int masses, const Options& options = {}) {
  const PileIsland own(pile), other(inOtherUnits(pile, lengths, masses));
  const Solution a = Solver(options).solve(own.problem), b = Solver(options).solve(other.problem);
  SCOPED_TRACE("lengths 2^" + std::to_string(lengths) + ", masses 2^" + std::to_string(masses));
  EXPECT_EQ(a.status, b.status);
  EXPECT_EQ(a.regions, b.regions);
  EXPECT_EQ(std::ldexp(a.residual, lengths), b.residual);
  EXPECT_TRUE(VectorXd(a.r * std::ldexp(1, lengths + masses)) == b.r)
      << (a.r * std::ldexp(1, lengths + masses) - b.r).cwiseAbs().maxCoeff();
  EXPECT_EQ(a.activeSet.contacts, b.activeSet.contacts);
}

TEST(Units, TowersAnswerInTheSameBits) {
  Random random(1);
  for (int round = 0; round < 10; ++round) {
    Pile tower = makeTower(randomMasses(6, 1e3, random), 0.5, 0.3, random);
    mixFriction(tower, 1, random);
    for (const auto& [lengths, masses] : {std::pair(13, 0), {-13, 0}, {0, 20}, {0, -20}, {-7, 30}})
      expectSameBits(tower, lengths, masses);
  }
}

TEST(Units, PyramidsAnswerInTheSameBits) {
  Random random(2);
  for (int round = 0; round < 3; ++round)
    for (const auto& [lengths, masses] : {std::pair(13, -20), {-13, 30}})
      expectSameBits(makePyramid(3, 0.5, 0.2, 10, random), lengths, masses);
}

// They need sweeps in single precision, soft contacts and long walks, and some find no answer.
TEST(Units, HeapsAnswerInTheSameBits) {
  Random random(3);
  const Pile wedged = makeSphereHeap(40, 3, 0.8, 1, random);
  const Pile heap = makeSphereHeap(120, 4, 0.5, 0.3, random);
  const Pile pressed = makePressed(3, 0.5, 0.1, 0.1, 0.1, random);
  for (const auto& [lengths, masses] : {std::pair(10, 10), {-10, -20}, {-30, -90}, {20, 60}}) {
    expectSameBits(wedged, lengths, masses);
    expectSameBits(pressed, lengths, masses);
    expectSameBits(heap, lengths, masses, Options::bounded(100));
  }
}

// Rows of circuits and multipliers have no diagonal by which they could be measured.
TEST(Units, RowsWithoutDiagonalAnswerInTheSameBits) {
  Random random(4);
  for (int round = 0; round < 20; ++round) {
    constexpr int n = 6, held = 2;
    Problem own;
    MatrixXd W = MatrixXd::Zero(n, n);
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < i; ++j) W(i, j) = uniform(random, -1, 1), W(j, i) = -W(i, j);
    for (int i = held; i < n; ++i) W(i, i) = i % 2;
    own.q = normalVector(n, random);
    own.lower = VectorXd::Zero(n);
    own.lower.head(held).setConstant(-infinity);
    own.upper = VectorXd::Constant(n, infinity);
    own.W = DelassusMatrix(DelassusMatrix::Sparse(W.sparseView()));
    const Solution a = solve(own);
    for (const auto& [ofW, ofQ] : {std::pair(-60, 0), {-20, -14}, {40, 10}}) {
      Problem other = own;
      other.W = DelassusMatrix(DelassusMatrix::Sparse((W * std::ldexp(1, ofW)).sparseView()));
      other.q *= std::ldexp(1, ofQ);
      const Solution b = solve(other);
      EXPECT_EQ(a.status, b.status) << round << ' ' << ofW;
      EXPECT_TRUE(a.r * std::ldexp(1, ofQ - ofW) == b.r) << round << ' ' << ofW;
    }
  }
}

}  // namespace
}  // namespace delassus::test
