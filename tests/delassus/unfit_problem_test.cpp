/// Problems for which no law can be stated, and what the answer says of problems that are not
/// solved.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "delassus/island_check.h"
#include "delassus/residual.h"
#include "delassus/solver.h"
#include "tests/support/box_piles.h"
#include "tests/support/random_piles.h"

namespace delassus::test {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

const double notANumber = std::nan("");

/// Two contacts with friction and a row, not coupled.
Problem threeParts() {
  Problem problem;
  MatrixXd W = MatrixXd::Identity(7, 7);
  problem.W = DelassusMatrix(DelassusMatrix::Sparse(W.sparseView()));
  problem.q = VectorXd::Constant(7, -1);
  problem.friction = VectorXd::Constant(2, 0.5);
  problem.lower = VectorXd::Constant(1, 0);
  problem.upper = VectorXd::Constant(1, infinity);
  return problem;
}

struct Unfit {
  const char* what;
  std::function<void(Problem&)> breakIt;
  int first;  ///< unknown that is blamed
};

const std::vector<Unfit>& unfit() {
  static const std::vector<Unfit> cases = {
      {"q", [](Problem& p) { p.q[4] = notANumber; }, 3},
      {"large q", [](Problem& p) { p.q[6] = 1e200; }, 6},
      {"friction", [](Problem& p) { p.friction[1] = notANumber; }, 3},
      {"negative friction", [](Problem& p) { p.friction[0] = -0.1; }, 0},
      {"endless friction", [](Problem& p) { p.friction[0] = infinity; }, 0},
      {"bound", [](Problem& p) { p.upper[0] = notANumber; }, 6},
      {"crossed bounds", [](Problem& p) { p.upper[0] = -1; }, 6},
      {"large bound", [](Problem& p) { p.lower[0] = -1e200; }, 6},
      {"bounds at infinity", [](Problem& p) { p.lower[0] = infinity; }, 6},
      {"W",
       [](Problem& p) {
         DelassusMatrix::Sparse entries = p.W.entries();
         entries.coeffRef(5, 5) = infinity;
         p.W = DelassusMatrix(entries);
       },
       3},
  };
  return cases;
}

TEST(UnfitProblem, IsNamedAndGetsNoReactions) {
  ASSERT_THAT(unfitParts(threeParts()), IsEmpty());
  for (const Unfit& c : unfit()) {
    SCOPED_TRACE(c.what);
    Problem problem = threeParts();
    c.breakIt(problem);
    Solver solver;
    const Solution solution = solver.solve(problem, VectorXd::Ones(7));
    EXPECT_EQ(solution.status, Status::NonFinite);
    EXPECT_THAT(solution.blamed, ElementsAre(c.first));
    EXPECT_EQ(solution.r, VectorXd::Zero(7));
    EXPECT_EQ(solution.activeSet.contacts.size(), 2u);
    EXPECT_EQ(solution.regions, 0) << "no work is wasted on it";
    EXPECT_EQ(solver.solve(threeParts()).status, Status::Solved) << "and nothing is left of it";
  }
}

// Contacts alone, with entries, are first checked all at once. A fault in one of them must not
// drown in a sum.
TEST(UnfitProblem, IsNamedAmongContactsAlone) {
  const auto contactsAlone = [] {
    Problem problem;
    MatrixXd W = MatrixXd::Identity(9, 9);
    problem.W = DelassusMatrix(DelassusMatrix::Sparse(W.sparseView()));
    problem.q = VectorXd::Constant(9, -1);
    problem.friction = VectorXd::Constant(3, 0.5);
    return problem;
  };
  ASSERT_THAT(unfitParts(contactsAlone()), IsEmpty());
  for (const Unfit& c : unfit()) {
    SCOPED_TRACE(c.what);
    if (c.first == 6) continue;  // a fault of the row
    Problem problem = contactsAlone();
    c.breakIt(problem);
    EXPECT_THAT(unfitParts(problem), ElementsAre(c.first));
    EXPECT_THAT(solve(problem).blamed, ElementsAre(c.first));
  }
  // The sum of many fit entries may exceed what one entry must not.
  Problem large = contactsAlone();
  large.q.setConstant(3e99);
  EXPECT_THAT(unfitParts(large), IsEmpty());
  // Other entries must not make up for a negative one.
  Problem made = contactsAlone();
  made.friction << -1e-3, 2, 2;
  EXPECT_THAT(unfitParts(made), ElementsAre(0));
}

TEST(UnfitProblem, SpoilsOnlyThePartThatItIsCoupledTo) {
  Problem problem = threeParts();
  problem.q[0] = notANumber;
  const Solution solution = solve(problem);
  EXPECT_EQ(solution.status, Status::NonFinite);
  EXPECT_THAT(solution.blamed, ElementsAre(0));
  EXPECT_NEAR(solution.r[3], 1, 1e-8);
  EXPECT_NEAR(solution.r[6], 1, 1e-8);
}

// Such a disk does not say to which part its unknown belongs.
TEST(UnfitProblem, ADiskThatPointsOutOfIt) {
  for (const int governor : {-1, 3, 4, 1000}) {  // 4: a tangent
    SCOPED_TRACE(governor);
    Problem problem = threeParts();
    problem.lower[0] = -infinity;
    problem.disks = {{6, 1, governor, 0.1}};
    const Solution solution = solve(problem);
    if (governor == 3) {
      EXPECT_EQ(solution.status, Status::Solved);
      EXPECT_NEAR(solution.r[6], 0.1, 1e-8);
    } else {
      EXPECT_EQ(solution.status, Status::NonFinite);
      EXPECT_THAT(solution.blamed, ElementsAre(6));
    }
  }
  Problem problem = threeParts();
  problem.lower[0] = -infinity;
  for (const Disk& disk : {Disk{1000, 1, 0, 0.1}, Disk{6, 2, 0, 0.1}, Disk{6, 1, 0, 0.1, 1e200}}) {
    problem.disks = {disk};
    EXPECT_EQ(solve(problem).status, Status::NonFinite);
  }
}

TEST(UnfitProblem, InAPartOfAnArticulatedBody) {
  Random random(3);
  const PileIsland pile(makeTower({1, 1}, 0.5, 0, random));
  Problem problem = pile.problem;
  BodySpace space = problem.W.bodySpace();
  space.parts.push_back({6, 1, Mat36::Constant(notANumber)});
  problem.W = DelassusMatrix(space);
  EXPECT_THAT(unfitParts(problem), ElementsAre(6));
}

// It must not pass for a contact without friction when the problem is assembled from bodies.
TEST(UnfitProblem, AContactGivenWithAFrictionThatIsNone) {
  Random random(3);
  for (const double friction : {notANumber, -0.5}) {
    SCOPED_TRACE(friction);
    Pile pile = makeTower({1, 1, 1}, 0.5, 0, random);
    const VectorXd reactions = solve(PileIsland(pile).problem).r;
    Pile others = pile;
    others.contacts.erase(others.contacts.begin() + 2);
    VectorXd withoutIt = VectorXd::Zero(reactions.size());
    const VectorXd ofOthers = solve(PileIsland(others).problem).r;
    withoutIt << ofOthers.head(6), Vec3::Zero(), ofOthers.tail(ofOthers.size() - 6);
    pile.contacts[2].friction = friction;
    const Island island = splitIslands(pile.bodies, pile.contacts, pile.rows).at(0);
    const Problem problem = assemble(pile.bodies, pile.contacts, pile.rows, island);
    EXPECT_THAT(unfitParts(problem), ElementsAre(6));
    Solution solution = solve(problem);
    EXPECT_EQ(solution.status, Status::NonFinite);
    EXPECT_THAT(solution.blamed, ElementsAre(6));

    // Nor are reactions kept that would be right with friction, or with none at that contact.
    for (const VectorXd& r : {reactions, withoutIt}) {
      solution.r = r;
      std::vector<Body> moved = pile.bodies;
      EXPECT_FALSE(IslandCheck(Options()).isKept(pile.bodies, pile.contacts, pile.rows, island, 1,
                                                 moved, solution));
    }
  }
}

TEST(UnfitProblem, InBodySpace) {
  Random random(3);
  const PileIsland pile(makeTower({1, 1, 1}, 0.5, 0, random));
  Problem problem = pile.problem;
  BodySpace space = problem.W.bodySpace();
  space.contacts[2].Ja(1, 3) = notANumber;
  problem.W = DelassusMatrix(space);
  EXPECT_THAT(solve(problem).blamed, ElementsAre(6));
}

TEST(NotSolved, OutOfBudgetBlamesTheLargestResidual) {
  Random random(3);
  const PileIsland pile(makeTower(randomMasses(10, 1e3, random), 0.5, 1, random));
  Options options;
  options.newtonBudget = options.sweepBudget = 1;
  const Solution solution = solve(pile.problem, options);
  ASSERT_EQ(solution.status, Status::OutOfBudget);
  EXPECT_THAT(solution.blamed,
              ElementsAre(naturalResidual(pile.problem, solution.r, solution.u).worst));
}

}  // namespace
}  // namespace delassus::test
