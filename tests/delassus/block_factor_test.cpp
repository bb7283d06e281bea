/// The factor of 6x6 blocks against a dense LU: K x = b on random body graphs.
#include "delassus/block_factor.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "delassus/block_product.h"
#include "tests/support/random_problems.h"

namespace delassus {
namespace {

using Edges = std::vector<BlockFactor::Edge>;

/// The matrix that a factor holds, kept densely beside the factor.
class DenseBeside {
 public:
  DenseBeside(BlockFactor& factor, int bodies, const Edges& edges, bool symmetric = false)
      : factor_(factor), edges_(edges), K_(MatrixXd::Identity(6 * bodies, 6 * bodies)) {
    factor_.analyse(bodies, edges_);
    factor_.setIdentity(symmetric);
  }

  void addDiagonal(int body, const Mat6& block) {
    factor_.addDiagonal(body, block);
    K_.block<6, 6>(6 * body, 6 * body) += block;
  }
  void addOffDiagonal(int edge, const Mat6& ab, const Mat6& ba) {
    factor_.addOffDiagonal(edge, ab, ba);
    const auto [a, b] = edges_[edge];
    K_.block<6, 6>(6 * a, 6 * b) += ab;
    K_.block<6, 6>(6 * b, 6 * a) += ba;
  }

  /// Adds to K what a region adds: J̃ᵀ G J̃ of two contacts between the bodies of `edge`, which is
  /// not symmetric if they slide.
  void addContacts(int edge, const Mat3& G, Random& random) {
    const auto [a, b] = edges_[edge];
    Touch touch{edge, {}, {G, G / 2}};
    for (int k = 0; k < 2; ++k)
      touch.rows.push_back({a, b, normalMatrix(3, 6, random), normalMatrix(3, 6, random)});
    for (int k = 0; k < 2; ++k) {
      MatrixXd J = MatrixXd::Zero(3, K_.cols());
      J.middleCols<6>(6 * a) = touch.rows[k].Ja;
      J.middleCols<6>(6 * b) = touch.rows[k].Jb;
      K_ += J.transpose() * touch.G[k] * J;
    }
    touches_.push_back(std::move(touch));
  }
  /// The same for a contact with the world, which may be either of the two bodies.
  void addContactWithWorld(int body, bool isFirst, const Mat3& G, Random& random) {
    const Mat36 J = normalMatrix(3, 6, random);
    ContactRows rows = {fixedWorld, body, Mat36::Zero(), J};
    if (!isFirst) std::swap(rows.a, rows.b), rows.Ja.swap(rows.Jb);
    touches_.push_back({-1, {rows}, {G}});
    K_.block<6, 6>(6 * body, 6 * body) += J.transpose() * G * J;
  }

  bool factorise() {
    return factor_.factorise([this](int body) {
      for (const Touch& touch : touches_)
        for (const auto side : {BlockFactor::Side::A, BlockFactor::Side::B}) {
          if ((side == BlockFactor::Side::A ? touch.rows[0].a : touch.rows[0].b) != body) continue;
          BlockFactor::Responses contacts(side);
          for (std::size_t k = 0; k < touch.rows.size(); ++k)
            contacts.add(touch.rows[k], touch.G[k]);
          factor_.addContacts(contacts, touch.edge);
        }
    });
  }

  /// |K x − b| / (|K| |x|) of the factor's answer.
  double backwardError(Random& random) const {
    const VectorXd b = normalVector(static_cast<int>(K_.rows()), random);
    VectorXd x = b;
    factor_.solve(x);
    return (K_ * x - b).norm() / (K_.norm() * x.norm());
  }
  const MatrixXd& dense() const { return K_; }

 private:
  struct Touch {
    int edge;
    std::vector<ContactRows> rows;
    std::vector<Mat3> G;
  };

  BlockFactor& factor_;
  Edges edges_;
  MatrixXd K_;
  std::vector<Touch> touches_;
};

Edges randomEdges(int bodies, int count, Random& random) {
  std::uniform_int_distribution<int> any(0, bodies - 1);
  Edges edges;
  while (static_cast<int>(edges.size()) < count && bodies > 1) {
    const int a = any(random), b = any(random);
    if (a != b) edges.push_back({a, b});
  }
  return edges;
}

Mat3 randomStiffness(Random& random) {
  const Mat3 root = normalMatrix(3, 3, random);
  Mat3 G = root * root.transpose();
  G(1, 0) += uniform(random, 0, 1);  // a sliding contact: the friction follows the normal only
  return G;
}

// Trees, loops, islands in pieces; random draws also repeat pairs and reverse them.
TEST(BlockFactor, AgreesWithDenseEliminationOnRandomGraphs) {
  Random random(11);
  BlockFactor factor;
  for (int k = 0; k < 300; ++k) {
    const int bodies = 1 + k % 20;
    const Edges edges = randomEdges(bodies, k % 7 * bodies / 2, random);
    DenseBeside both(factor, bodies, edges);
    for (int e = 0; e < static_cast<int>(edges.size()); ++e)
      both.addContacts(e, randomStiffness(random), random);
    for (int i = 0; i < bodies; i += 3)
      both.addContactWithWorld(i, k % 2 == 0, randomStiffness(random), random);

    ASSERT_TRUE(both.factorise());
    const VectorXd b = normalVector(6 * bodies, random);
    VectorXd x = b;
    factor.solve(x);
    const VectorXd truth = both.dense().partialPivLu().solve(b);
    ASSERT_LT((x - truth).norm(), 1e-9 * truth.norm()) << "graph " << k;
    ASSERT_LT(both.backwardError(random), 1e-13) << "graph " << k;
  }
}

// W = J A⁻¹ Jᵀ of rows that act on one body, on two, or on none.
TEST(BlockFactor, CondensesToFewRows) {
  Random random(20);
  BlockFactor factor;
  KeptMatrix W;
  for (int k = 0; k < 100; ++k) {
    const int bodies = 1 + k % 12, rows = k % 17;
    const Edges edges = randomEdges(bodies, k % 5 * bodies / 2, random);
    DenseBeside both(factor, bodies, edges, true);
    for (int e = 0; e < static_cast<int>(edges.size()); ++e) {
      const Mat3 G = randomStiffness(random);
      both.addContacts(e, G.transpose() * G, random);
    }
    ASSERT_TRUE(both.factorise());
    MatrixXd J = MatrixXd::Zero(rows, 6 * bodies);
    std::vector<BlockFactor::RowBlock> blocks;
    std::vector<int> begin = {0};
    for (int i = 0; i < rows; ++i) {
      const int first = i % bodies, second = (i + 1 + k) % bodies;
      if (i % 5 > 0) blocks.push_back({first, normalVector(6, random)});
      if (i % 5 > 2 && second != first) blocks.push_back({second, normalVector(6, random)});
      for (int b = begin.back(); b < static_cast<int>(blocks.size()); ++b)
        J.row(i).segment<6>(6 * blocks[b].body) = blocks[b].entries.transpose();
      begin.push_back(static_cast<int>(blocks.size()));
    }
    factor.condense(blocks, begin, W);
    const MatrixXd truth = J * both.dense().inverse() * J.transpose();
    EXPECT_EQ(W, MatrixXd(W.transpose()));
    EXPECT_LE((W - truth).norm(), 1e-10 * (1 + truth.norm())) << "graph " << k;
  }
}

// All bodies touch each other: every column has the rows of the one before it. There are more such
// columns than are taken together.
TEST(BlockFactor, ManyColumnsWithTheSameRows) {
  Random random(19);
  constexpr int bodies = 3 * mostSources;
  Edges edges;
  for (int a = 0; a < bodies; ++a)
    for (int b = 0; b < a; ++b) edges.push_back({a, b});
  BlockFactor factor;
  for (const bool symmetric : {false, true}) {
    DenseBeside both(factor, bodies, edges, symmetric);
    for (int e = 0; e < static_cast<int>(edges.size()); ++e) {
      const Mat3 G = randomStiffness(random);
      both.addContacts(e, symmetric ? Mat3(G.transpose() * G) : G, random);
    }
    ASSERT_TRUE(both.factorise());
    EXPECT_LT(both.backwardError(random), 1e-13);
  }
}

// Values of any kind, as long as the diagonal outweighs the others.
TEST(BlockFactor, NonsymmetricValues) {
  Random random(12);
  for (int k = 0; k < 100; ++k) {
    const int bodies = 2 + k % 15;
    const Edges edges = randomEdges(bodies, 2 * bodies, random);
    BlockFactor factor;
    DenseBeside both(factor, bodies, edges);
    for (int e = 0; e < static_cast<int>(edges.size()); ++e)
      both.addOffDiagonal(e, normalMatrix(6, 6, random), normalMatrix(6, 6, random));
    for (int i = 0; i < bodies; ++i)
      both.addDiagonal(i, normalMatrix(6, 6, random) + 30 * Mat6::Identity());
    ASSERT_TRUE(both.factorise());
    EXPECT_LT(both.backwardError(random), 1e-14) << "graph " << k;
  }
}

// Contacts that stick or open make a symmetric matrix, one half of which need not be computed.
TEST(BlockFactor, ASymmetricMatrixHasTheSameAnswerForHalfTheWork) {
  Random random(18);
  for (int k = 0; k < 100; ++k) {
    const int bodies = 1 + k % 20;
    const Edges edges = randomEdges(bodies, k % 5 * bodies / 2, random);
    BlockFactor factor;
    const auto answer = [&](bool symmetric) {
      Random again(16 + k);
      DenseBeside both(factor, bodies, edges, symmetric);
      for (int e = 0; e < static_cast<int>(edges.size()); ++e) {
        const Mat3 root = normalMatrix(3, 3, again);
        both.addContacts(e, root * root.transpose(), again);
      }
      EXPECT_TRUE(both.factorise());
      EXPECT_LT(both.backwardError(again), 1e-13) << "graph " << k;
      VectorXd x = normalVector(6 * bodies, again);
      factor.solve(x);
      return x;
    };
    const VectorXd whole = answer(false), half = answer(true);
    EXPECT_LT((whole - half).norm(), 1e-9 * whole.norm()) << "graph " << k;
  }
}

// Small proximal weights make contacts stiff: G up to 1e12 beside the identity. Block elimination
// of a symmetric positive definite K without pivoting loses √κ(K) at most (Demmel, Higham,
// Schreiber 1995), and here κ(K) ≤ |K| for K ≥ I.
TEST(BlockFactor, LosesNoMoreThanTheRootOfTheConditionForStiffContacts) {
  Random random(13);
  for (int k = 0; k < 100; ++k) {
    const int bodies = 2 + k % 15;
    const Edges edges = randomEdges(bodies, 2 * bodies, random);
    BlockFactor factor;
    DenseBeside both(factor, bodies, edges);
    for (int e = 0; e < static_cast<int>(edges.size()); ++e)
      both.addContacts(e, std::pow(10, uniform(random, 0, 12)) * Mat3::Identity(), random);
    ASSERT_TRUE(both.factorise());
    EXPECT_LT(both.backwardError(random), 5e-14 * std::sqrt(both.dense().norm())) << "graph " << k;
  }
}

// The analysis is kept from step to step; earlier graphs and values must not show.
TEST(BlockFactor, HasNoMemoryOfEarlierGraphsAndValues) {
  const Edges chain = {{0, 1}, {1, 2}, {2, 3}}, star = {{0, 1}, {0, 2}, {0, 3}};
  const auto answer = [](BlockFactor& factor, const Edges& edges) {
    Random random(14);
    DenseBeside both(factor, 4, edges);
    for (int e = 0; e < 3; ++e) both.addContacts(e, randomStiffness(random), random);
    EXPECT_TRUE(both.factorise());
    VectorXd x = normalVector(24, random);
    factor.solve(x);
    return x;
  };
  BlockFactor fresh, used;
  const VectorXd first = answer(fresh, chain);
  answer(used, chain);
  answer(used, star);
  EXPECT_EQ(answer(used, chain), first);
  EXPECT_EQ(answer(used, chain), first);
}

// More graphs in turn than can be kept: it must not show either whether a graph is known or has
// been forgotten.
TEST(BlockFactor, KeepsWhatManyGraphsAskedFor) {
  constexpr int graphs = 100;
  Random random(15);
  std::vector<Edges> all;
  for (int k = 0; k < graphs; ++k) all.push_back(randomEdges(12, 12 + k % 5, random));
  const auto answer = [&](BlockFactor& factor, int k) {
    Random own(k);
    DenseBeside both(factor, 12, all[k]);
    for (int e = 0; e < static_cast<int>(all[k].size()); ++e)
      both.addContacts(e, randomStiffness(own), own);
    EXPECT_TRUE(both.factorise());
    VectorXd x = normalVector(72, own);
    factor.solve(x);
    return x;
  };
  BlockFactor used;
  std::size_t bytes = 0;
  for (int k = 0; k < 5 * graphs; ++k) {
    const int graph = k < 2 * graphs ? k % graphs : static_cast<int>(random() % graphs);
    BlockFactor fresh;
    ASSERT_EQ(answer(used, graph), answer(fresh, graph)) << k;
    if (k == graphs) bytes = used.bytes();
  }
  EXPECT_LT(static_cast<double>(used.bytes()), 1.2 * static_cast<double>(bytes));
}

// A chain has no fill: the factor has as many blocks as the chain has couplings.
TEST(BlockFactor, EliminatesChainsWithoutFill) {
  const auto bytesOfChain = [](int bodies) {
    BlockFactor factor;
    Edges edges;
    for (int i = 0; i + 1 < bodies; ++i) edges.push_back({i, i + 1});
    DenseBeside both(factor, bodies, edges);
    EXPECT_TRUE(both.factorise());
    return static_cast<double>(factor.bytes());
  };
  EXPECT_LT(bytesOfChain(80), 2.2 * bytesOfChain(40));
}

TEST(BlockFactor, SingularAndBrokenPivotsAreRefused) {
  const Edges edges = {{0, 1}};
  BlockFactor factor;
  DenseBeside singular(factor, 2, edges);
  singular.addDiagonal(1, -Mat6::Identity());
  EXPECT_FALSE(singular.factorise());

  DenseBeside broken(factor, 2, edges);
  broken.addDiagonal(0, Mat6::Constant(std::numeric_limits<double>::quiet_NaN()));
  EXPECT_FALSE(broken.factorise());

  // And nothing of the failure is left.
  Random random(15);
  DenseBeside sound(factor, 2, edges);
  sound.addContacts(0, randomStiffness(random), random);
  ASSERT_TRUE(sound.factorise());
  EXPECT_LT(sound.backwardError(random), 1e-14);
}

TEST(BlockFactor, NoBodiesAtAll) {
  BlockFactor factor;
  factor.analyse(0, {});
  factor.setIdentity();
  EXPECT_TRUE(factor.factorise());
  VectorXd nothing;
  factor.solve(nothing);
  EXPECT_EQ(nothing.size(), 0);
}

// One island is larger than all the room for patterns. It and the others must not be analysed again
// in turns.
TEST(BlockFactor, TheLargestPatternDrivesOutNoOther) {
  constexpr int many = 6000;
  Edges chain;
  for (int body = 1; body < many; ++body) chain.push_back({body - 1, body});
  BlockFactor factor;
  factor.analyse(2, {{0, 1}});
  factor.analyse(many, chain);
  const std::size_t both = factor.bytes();
  factor.analyse(2, {{0, 1}});
  EXPECT_EQ(factor.bytes(), both);
  factor.analyse(many, chain);
  EXPECT_EQ(factor.bytes(), both);
}

}  // namespace
}  // namespace delassus
