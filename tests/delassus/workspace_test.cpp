/// What a workspace has solved before does not show in what it solves next: any workspace may get
/// any island.
#include <gtest/gtest.h>

#include "delassus/solver.h"
#include "tests/support/random_piles.h"
#include "tests/support/turning_piles.h"

namespace delassus {
namespace {

using namespace delassus::test;

struct Task {
  Problem problem;
  VectorXd guess;
};

/// Towers, pyramids and heaps of many sizes, from rest and from a guess, with W in both storages.
std::vector<Task> manyTasks(Random& random) {
  std::vector<Task> tasks;
  const auto add = [&](Pile pile, bool turning) {
    mixFriction(pile, 1, random);
    if (turning) resistTurning(pile, 0.1, random);
    const PileIsland island(pile);
    const Problem& problem = island.problem;
    tasks.push_back({problem, {}});
    tasks.push_back({problem, randomReactions(problem, 0.1, random)});
    if (problem.size() < 60) tasks.push_back({withEntries(problem), {}});
  };
  for (int k = 0; k < 12; ++k) {
    add(makeTower(randomMasses(1 + k % 5, k % 2 ? 1000 : 1, random), 0.5, 0.1 * (k % 3), random),
        k % 4 == 3);
    add(makePyramid(1 + k % 3, 0.5, 0.2, 1 + 10 * (k % 2), random), false);
  }
  for (int balls : {2, 5, 9}) add(makeHeap(balls, 0.6, random), true);
  return tasks;
}

void expectSame(const Solution& a, const Solution& b, int k) {
  EXPECT_EQ(a.r, b.r) << k;
  EXPECT_EQ(a.u, b.u) << k;
  EXPECT_EQ(a.activeSet.contacts, b.activeSet.contacts) << k;
  EXPECT_EQ(a.activeSet.rows, b.activeSet.rows) << k;
  EXPECT_EQ(a.activeSet.disks, b.activeSet.disks) << k;
  EXPECT_EQ(a.status, b.status) << k;
  EXPECT_EQ(a.tier, b.tier) << k;
  EXPECT_EQ(a.residual, b.residual) << k;
  EXPECT_EQ(a.residualRms, b.residualRms) << k;
  EXPECT_EQ(a.regions, b.regions) << k;
  EXPECT_EQ(a.factorisations, b.factorisations) << k;
  EXPECT_EQ(a.sweeps, b.sweeps) << k;
  EXPECT_EQ(a.blamed, b.blamed) << k;
}

TEST(Workspace, HasNoMemoryOfOtherProblems) {
  Random random(21);
  const std::vector<Task> tasks = manyTasks(random);
  Options options;
  options.newtonBudget = 150;
  options.sweepBudget = 300;
  std::vector<Solution> alone;
  for (const Task& task : tasks) alone.push_back(Solver(options).solve(task.problem, task.guess));

  Solver used(options);
  Solution solution;
  for (int k = 0; k < 400; ++k) {
    const auto i = random() % tasks.size();
    used.solve(tasks[i].problem, tasks[i].guess, solution);
    expectSame(solution, alone[i], static_cast<int>(i));
  }
}

TEST(KeptVector, KeepsItsStorageAndIsOtherwiseAVector) {
  VectorXd x = VectorXd::LinSpaced(5, 1, 5);
  const double* storage = x.data();
  x = x.head(3).reverse().eval();
  EXPECT_EQ(x, Vec3(3, 2, 1));
  EXPECT_EQ(x.data(), storage);
  x.setConstant(5, 7);
  EXPECT_EQ(x, VectorXd::Constant(5, 7));
  EXPECT_EQ(x.data(), storage);

  VectorXd copy = x;
  copy[0] = 1;
  EXPECT_EQ(x[0], 7);
  copy.resize(2);
  copy.setZero();
  x.swap(copy);
  EXPECT_EQ(x, Vec2(0, 0));
  EXPECT_EQ(copy.size(), 5);
  EXPECT_EQ(copy.data(), storage);
  const VectorXd moved = std::move(copy);
  EXPECT_EQ(moved, VectorXd::Constant(5, 7));
  EXPECT_EQ(moved.data(), storage);
  VectorXd& self = x;
  x = self;
  EXPECT_EQ(x, Vec2(0, 0));
  EXPECT_EQ(VectorXd().size(), 0);
}

TEST(KeptVector, WithoutMemoryItIsEmpty) {
  constexpr VectorXd::Index tooMany = std::numeric_limits<VectorXd::Index>::max() / 2;
  VectorXd x = VectorXd::LinSpaced(5, 1, 5);
  EXPECT_THROW(x.resize(tooMany), std::bad_alloc);
  EXPECT_EQ(x.size(), 0);
  x.setConstant(2, 7);
  EXPECT_EQ(x, Vec2(7, 7));
}

}  // namespace
}  // namespace delassus
