/// The path of compliance, which leads from compliant bodies to rigid ones.
#include "delassus/compliance_path.h"

#include <gtest/gtest.h>

#include "delassus/proximal_walk.h"
#include "delassus/solver.h"
#include "tests/support/pressed_piles.h"
#include "tests/support/turning_piles.h"

namespace delassus {
namespace {

using namespace delassus::test;

constexpr int plenty = 4000;  // factorisations

/// The same problem with bodies that are compliant by `compliance` W_aa.
Problem soften(const Problem& problem, double compliance) {
  NaturalMap map;
  map.setProblem(problem);
  VectorXd scale;
  map.meanDiagonal(scale);
  BodySpace space = problem.W.bodySpace();
  space.compliance += compliance * scale;
  Problem soft = problem;
  soft.W = DelassusMatrix(space);
  return soft;
}

/// The same problem with bodies that are compliant to changes of the reactions from `center`.
Problem soften(const Problem& problem, double compliance, const VectorXd& center) {
  Problem soft = soften(problem, compliance);
  soft.q -= soft.W.bodySpace().compliance.cwiseProduct(center);
  return soft;
}

/// A path with all the objects that it needs.
class Way {
 public:
  explicit Way(const Problem& problem) : problem_(problem) {
    map_.setProblem(problem_);
    space_.setProblem(problem_, map_);
    path_.setProblem(space_.lendMotion(), problem_, map_);
  }

  /// Makes compliance count from these reactions.
  void setCenter(const VectorXd& reactions) {
    Solution center;
    center.r = reactions;
    center.u = problem_.W * reactions + problem_.q;
    path_.setCenter(center);
  }
  bool setOut(const VectorXd& reactions, double compliance) {
    return path_.setOut(reactions, compliance, plenty, count_);
  }
  bool setOut(double compliance) {
    return setOut(solve(soften(problem_, compliance)).r, compliance);
  }
  bool descend(double compliance, int budget = plenty) {
    return path_.descend(compliance, budget, count_);
  }
  double compliance() const { return path_.compliance(); }
  const VectorXd& reactions() { return path_.reactions(); }
  int factorisations() const { return count_.factorisations; }

 private:
  const Problem& problem_;
  NaturalMap map_;
  ProximalSpace<BodyMotion> space_;
  CompliancePath path_;
  WorkDone count_;
};

/// Balls in a heap whose friction holds almost anything. A row with bounds joins two of them.
Problem wedgedHeap(Random& random) {
  Pile pile = makeHeap(20, 0.9, random);
  Row motor;
  motor.a = 0;
  motor.b = 1;
  motor.jacobianA << 1, 0, 0, 0, 0, 0;
  motor.jacobianB << -1, 0, 0, 0, 0, 0;
  motor.lower = -0.02;
  motor.upper = 0.02;
  pile.rows.push_back(motor);
  return PileIsland(pile).problem;
}

TEST(CompliancePath, KeepsTheLawOfEveryComplianceOnItsWay) {
  Random random(71);
  for (int k = 0; k < 6; ++k) {
    const Problem problem = wedgedHeap(random);
    Way way(problem);
    ASSERT_TRUE(way.setOut(0.1));
    for (double compliance = 0.01; compliance > 1e-7; compliance *= 0.1) {
      ASSERT_TRUE(way.descend(compliance)) << k << " ends at " << way.compliance();
      EXPECT_LE(way.compliance(), compliance);
      EXPECT_LT(naturalResidual(soften(problem, way.compliance()), way.reactions()).max, 1e-6);
    }
  }
}

// The law of rigid bodies is missed by no more than the contacts give way.
TEST(CompliancePath, LeadsToRigidBodies) {
  Random random(72);
  for (int k = 0; k < 6; ++k) {
    const Problem problem = wedgedHeap(random);
    Way way(problem);
    ASSERT_TRUE(way.setOut(0.1));
    ASSERT_TRUE(way.descend(1e-7));
    const VectorXd& r = way.reactions();
    EXPECT_LT(naturalResidual(problem, r).max, 1e-5 * r.cwiseAbs().maxCoeff());
  }
}

// The start is right in most places, or nearly: here the reactions of compliant bodies.
TEST(CompliancePath, KeepsTheLawOfComplianceToWhatChanges) {
  Random random(78);
  for (int k = 0; k < 6; ++k) {
    const Problem problem = wedgedHeap(random);
    const VectorXd center = solve(soften(problem, 0.01)).r;
    Way way(problem);
    way.setCenter(center);
    ASSERT_TRUE(way.setOut(center, 1));
    for (double compliance = 0.1; compliance > 1e-7; compliance *= 0.1) {
      ASSERT_TRUE(way.descend(compliance)) << k << " ends at " << way.compliance();
      const Problem soft = soften(problem, way.compliance(), center);
      EXPECT_LT(naturalResidual(soft, way.reactions()).max, 1e-6);
    }
    const VectorXd change = way.reactions() - center;
    EXPECT_GT(change.norm(), 1e-3 * center.norm()) << "nothing had to change";
    EXPECT_LT(naturalResidual(problem, way.reactions()).max, 1e-5 * change.cwiseAbs().maxCoeff());
  }
}

// Reactions that keep the law have nothing to give way to.
TEST(CompliancePath, LeavesAnAnswerWhereItIs) {
  Random random(79);
  const Problem problem = wedgedHeap(random);
  const Solution answer = solve(problem);
  ASSERT_EQ(answer.status, Status::Solved);
  Way way(problem);
  way.setCenter(answer.r);
  ASSERT_TRUE(way.setOut(answer.r, 1));
  ASSERT_TRUE(way.descend(1e-4));
  EXPECT_LT((way.reactions() - answer.r).norm(), 1e-3 * answer.r.norm());
}

// One compliance has several answers. From some of them, less compliance leads back to softness.
// Then the other direction is the one that ends at rigid bodies.
TEST(CompliancePath, ArrivesFromEveryStart) {
  Random random(77);
  for (int k = 0; k < 6; ++k) {
    const Problem problem = wedgedHeap(random);
    for (const double softness : {1.0, 0.1, 0.01}) {
      Way way(problem);
      ASSERT_TRUE(way.setOut(softness));
      EXPECT_TRUE(way.descend(1e-7))
          << k << " from " << softness << " ends at " << way.compliance();
    }
  }
}

// If compliance may only fall, Newton's method loses its way or jumps to another answer, since the
// curve of answers has turned back.
TEST(CompliancePath, GoesOnWhereAnswersForLessComplianceEnd) {
  Random random(73);
  int ends = 0;
  for (int k = 0; k < 6; ++k) {
    const Problem problem = wedgedHeap(random);
    Way way(problem), falling(problem);
    ASSERT_TRUE(way.setOut(0.1));
    for (double compliance = 0.08; compliance > 1e-5; compliance *= 0.8) {
      const VectorXd before = way.reactions();
      ASSERT_TRUE(way.descend(compliance)) << k << " ends at " << way.compliance();
      const VectorXd after = way.reactions();
      if (!falling.setOut(before, way.compliance()) ||
          (falling.reactions() - after).norm() > 0.01 * after.norm())
        ++ends;
    }
  }
  EXPECT_GT(ends, 5);
}

// Only reactions that grow as compliance falls, r ~ 1/c, answer demands that squeeze without
// friction.
TEST(CompliancePath, IncompatibleDemandsAreAnsweredEverHarder) {
  Random random(74);
  const PileIsland island(makePressed(3, 0, 0, 0.05, 0.5, random));
  Way way(island.problem);
  ASSERT_TRUE(way.setOut(0.1));
  ASSERT_TRUE(way.descend(1e-3));
  const double at = way.compliance() * way.reactions().norm();
  ASSERT_TRUE(way.descend(1e-5));
  EXPECT_NEAR(way.compliance() * way.reactions().norm(), at, 0.01 * at);
}

TEST(CompliancePath, EndsWithItsBudget) {
  Random random(75);
  const Problem problem = wedgedHeap(random);
  Way way(problem);
  ASSERT_TRUE(way.setOut(0.1));
  const int before = way.factorisations();
  EXPECT_FALSE(way.descend(1e-7, 10));
  EXPECT_LE(way.factorisations() - before, 10 + 64);  // a step is not interrupted
  EXPECT_TRUE(way.descend(1e-7)) << "it goes on where it ended";
}

// Far from the answer Newton's method does not find it.
TEST(CompliancePath, DoesNotSetOutFromAnywhere) {
  Random random(76);
  const Problem problem = wedgedHeap(random);
  Way way(problem);
  VectorXd far = VectorXd::Constant(problem.size(), std::nan(""));
  EXPECT_FALSE(way.setOut(far, 0.1));
}

// With next to no budget the earlier methods fail, as a rule: the path alone is left.
TEST(CompliancePath, IsTheSolversLastResort) {
  Random random(77);
  Options walks;
  walks.newtonBudget = 20;
  Options both = walks;
  walks.pathBudget = 0;
  int without = 0, with = 0;
  for (int k = 0; k < 6; ++k) {
    const Problem problem = wedgedHeap(random);
    without += Solver(walks).solve(problem).status == Status::Solved;
    const Solution solution = Solver(both).solve(problem);
    with += solution.status == Status::Solved;
    EXPECT_LE(solution.regions, both.newtonBudget);
  }
  EXPECT_LT(without, 3);
  EXPECT_EQ(with, 6);

  // A budget of less than nothing is none.
  const Problem problem = wedgedHeap(random);
  const Solution none = Solver(walks).solve(problem);
  walks.pathBudget = -1;
  const Solution less = Solver(walks).solve(problem);
  EXPECT_EQ(less.factorisations, none.factorisations);
  EXPECT_EQ(less.sweeps, none.sweeps);
}

}  // namespace
}  // namespace delassus
