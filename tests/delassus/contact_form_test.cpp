/// Problems with rows, written as contacts alone: the same answers.
#include "delassus/contact_form.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "delassus/solver.h"
#include "tests/support/random_piles.h"

namespace delassus {
namespace {

using namespace delassus::test;

/// Ties bodies of the pile to each other with equations (some of them twice), limits on either
/// side, motors, and a fixed impulse.
void addJoints(Pile& pile, Random& random) {
  const auto bodies = static_cast<int>(pile.bodies.size());
  for (int k = 0; k < 2 * bodies; ++k) {
    Row row;
    row.a = k % bodies;
    row.b = (k + 1) % bodies == row.a ? fixedWorld : (k + 1) % bodies;
    row.jacobianA = normalVector(6, random).transpose();
    row.jacobianB = normalVector(6, random).transpose();
    row.target = 0.1 * uniform(random, -1, 1);
    row.compliance = k % 5 == 0 ? 0.1 : 0;
    const double bound = uniform(random, 0.01, 0.3);
    if (k % 5 == 1) row.lower = 0;
    if (k % 5 == 2) row.upper = bound;
    if (k % 5 == 3) row.lower = -bound, row.upper = 2 * bound;
    if (k % 11 == 4) row.lower = row.upper = bound;
    pile.rows.push_back(row);
    if (k % 6 == 5) pile.rows.push_back(row);
  }
}

/// The reactions of the contact form that belong to those of the problem.
VectorXd imageOf(const Problem& problem, const VectorXd& r, int contacts) {
  VectorXd image = VectorXd::Zero(3 * contacts);
  int at = 3 * problem.contacts();
  image.head(at) = r.head(at);
  for (int k = 0; k < problem.rows(); ++k) {
    const double lower = problem.lower[k], upper = problem.upper[k];
    const double x = r[3 * problem.contacts() + k];
    if (std::isinf(lower) && std::isinf(upper)) continue;
    if (std::isinf(upper))
      image[at] = x - lower;
    else if (std::isinf(lower))
      image[at] = upper - x;
    else
      image.segment<2>(at) = Vec2(1, x - (lower + upper) / 2);
    at += 3;
  }
  EXPECT_EQ(at, image.size());
  return image;
}

TEST(ContactForm, HasTheSameAnswers) {
  Random random(3);
  int equations = 0, bounds = 0;
  for (int k = 0; k < 40; ++k) {
    Pile pile = makeTower(randomMasses(2 + k % 4, 3, random), 0.6, 0.3, random);
    mixFriction(pile, 1, random);
    addJoints(pile, random);
    const PileIsland island(std::move(pile));
    for (const Problem& problem : {island.problem, withEntries(island.problem)}) {
      const Solution s = solve(problem);
      ASSERT_EQ(s.status, Status::Solved) << k;
      const Problem form = contactForm(problem);
      EXPECT_EQ(form.rows(), 0);
      const int more = form.contacts() - problem.contacts();
      bounds += more;
      equations += problem.rows() - more;

      const VectorXd image = imageOf(problem, s.r, form.contacts());
      const double demand = problem.q.cwiseAbs().maxCoeff();
      EXPECT_LT(naturalResidual(form, image).max, 1e-6 * demand) << k;
      const VectorXd u = form.W * image + form.q;
      const int asBefore = 3 * problem.contacts();
      EXPECT_LT((u.head(asBefore) - s.u.head(asBefore)).norm(), 1e-6 * demand)
          << k << ": the contacts move as before";
      EXPECT_EQ(solve(form).status, Status::Solved) << k;
    }
  }
  EXPECT_GT(equations, 50);
  EXPECT_GT(bounds, 50);
}

// A row r between −1 and 3 with u = 2 r + q.
TEST(ContactForm, ARowWithTwoBoundsIsFrictionUnderAFixedLoad) {
  for (const double q : {-10.0, -4.0, 0.0, 1.0, 20.0}) {
    Problem problem;
    problem.W =
        DelassusMatrix(DelassusMatrix::Sparse(MatrixXd(MatrixXd::Constant(1, 1, 2)).sparseView()));
    problem.q = VectorXd::Constant(1, q);
    problem.lower = VectorXd::Constant(1, -1);
    problem.upper = VectorXd::Constant(1, 3);
    const Problem form = contactForm(problem);
    ASSERT_EQ(form.contacts(), 1);
    EXPECT_EQ(form.friction[0], 2);
    const Solution s = solve(form);
    EXPECT_NEAR(s.r[0], 1, 1e-9);
    EXPECT_NEAR(s.r[1] + 1, std::clamp(-q / 2, -1.0, 3.0), 1e-8);
    EXPECT_NEAR(s.r[2], 0, 1e-9);
  }
}

// A contact and an equation that act on each other, in units in which the equation is small.
TEST(ContactForm, RefusesAMatrixThatIsNotSymmetric) {
  const auto tied = [](double feltByContact, double feltByEquation) {
    MatrixXd W = MatrixXd::Identity(4, 4);
    W(0, 3) = feltByContact;
    W(3, 0) = feltByEquation;
    const Eigen::Vector4d unit(1, 1, 1, 1e-6);
    W = (unit.asDiagonal() * W * unit.asDiagonal()).eval();
    Problem problem;
    problem.W = DelassusMatrix(DelassusMatrix::Sparse(W.sparseView()));
    problem.q = VectorXd::Constant(4, -1);
    problem.friction = VectorXd::Constant(1, 0.5);
    problem.lower = VectorXd::Constant(1, -infinity);
    problem.upper = VectorXd::Constant(1, infinity);
    return problem;
  };
  EXPECT_EQ(contactForm(tied(0.5, 0.5)).contacts(), 1);
  EXPECT_EQ(contactForm(tied(0.5, 0.5 + 1e-12)).contacts(), 1) << "but for rounding";
  EXPECT_THROW(contactForm(tied(0.5, 0.5 + 1e-8)), std::invalid_argument);
  EXPECT_THROW(contactForm(tied(0.5, 0)), std::invalid_argument);
  EXPECT_THROW(contactForm(tied(0, -0.5)), std::invalid_argument);
}

TEST(ContactForm, NamesWhatHasNone) {
  // Two equations for one motion that ask for different velocities.
  Problem problem;
  problem.W = DelassusMatrix(DelassusMatrix::Sparse(MatrixXd(MatrixXd::Ones(2, 2)).sparseView()));
  problem.q = VectorXd::LinSpaced(2, 1, 2);
  problem.lower = VectorXd::Constant(2, -infinity);
  problem.upper = VectorXd::Constant(2, infinity);
  EXPECT_THROW(contactForm(problem), std::invalid_argument);
  problem.q[1] = 1;
  EXPECT_EQ(contactForm(problem).size(), 0);
  problem.lower[0] = 0;
  problem.disks = {{1, 1, 0, 0.1}};
  EXPECT_THROW(contactForm(problem), std::invalid_argument);
}

}  // namespace
}  // namespace delassus
