/// From bodies, contacts and rows to islands and their problems, and back: u = J v − target.
#include "delassus/island.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>

#include "delassus/contact_motion.h"
#include "tests/support/random_problems.h"

namespace delassus {
namespace {

Body randomBody(Random& random) {
  Body body;
  body.inverseMass.setConstant(uniform(random, 0.1, 10));
  const Mat3 root = normalMatrix(3, 3, random);
  body.inverseInertia = root * root.transpose();
  body.velocity = normalVector(6, random);
  return body;
}

Contact randomContact(int a, int b, double friction, Random& random) {
  Contact c;
  c.a = a, c.b = b;
  c.armA = normalVector(3, random), c.armB = normalVector(3, random);
  c.frame = Eigen::Quaterniond(Eigen::Vector4d(normalVector(4, random))).normalized().matrix();
  c.friction = friction;
  c.target = normalVector(3, random);
  c.compliance = uniform(random, 0, 1);
  c.slipCompliance = uniform(random, 0, 1);
  return c;
}

Row randomRow(int a, int b, Random& random) {
  Row row;
  row.a = a, row.b = b;
  row.jacobianA = normalMatrix(1, 6, random), row.jacobianB = normalMatrix(1, 6, random);
  row.target = normalVector(1, random)[0];
  row.lower = -uniform(random, 0, 1), row.upper = infinity;
  row.compliance = uniform(random, 0, 1);
  return row;
}

/// u − compliance r, contact by contact from the velocities of the bodies, in the order of the
/// unknowns.
VectorXd relativeVelocity(const std::vector<Body>& bodies, const std::vector<Contact>& contacts,
                          const std::vector<Row>& rows, const Island& island) {
  const auto velocityAt = [&](int body, const Vec3& arm) -> Vec3 {
    if (body < 0) return Vec3::Zero();
    const Vec6& v = bodies[body].velocity;
    return v.head<3>() + v.tail<3>().cross(arm);
  };
  const auto ofContact = [&](const Contact& c) -> Vec3 {
    return c.frame.transpose() * (velocityAt(c.a, c.armA) - velocityAt(c.b, c.armB)) - c.target;
  };
  std::vector<double> u;
  for (const int i : island.frictional)
    for (const double entry : ofContact(contacts[i])) u.push_back(entry);
  for (const int i : island.frictionless) u.push_back(ofContact(contacts[i])[0]);
  for (const int i : island.rows) {
    const Row& row = rows[i];
    double along = -row.target;
    if (row.a >= 0) along += row.jacobianA.dot(bodies[row.a].velocity);
    if (row.b >= 0) along += row.jacobianB.dot(bodies[row.b].velocity);
    u.push_back(along);
  }
  return Eigen::Map<Eigen::VectorXd>(u.data(), static_cast<int>(u.size()));
}

VectorXd compliances(const std::vector<Contact>& contacts, const std::vector<Row>& rows,
                     const Island& island) {
  std::vector<double> c;
  for (const int i : island.frictional)
    c.insert(c.end(),
             {contacts[i].compliance, contacts[i].slipCompliance, contacts[i].slipCompliance});
  for (const int i : island.frictionless) c.push_back(contacts[i].compliance);
  for (const int i : island.rows) c.push_back(rows[i].compliance);
  return Eigen::Map<Eigen::VectorXd>(c.data(), static_cast<int>(c.size()));
}

/// Some bodies with everything that the data allow: locked axes, an inertia of rank one, a moving
/// platform, the fixed world.
struct Step {
  std::vector<Body> bodies;
  std::vector<Contact> contacts;
  std::vector<Row> rows;

  explicit Step(Random& random) {
    for (int i = 0; i < 6; ++i) bodies.push_back(randomBody(random));
    bodies[1].inverseMass[2] = 0;
    bodies[2].inverseInertia = Vec3(0, 3, 0).asDiagonal();
    const Vec3 axis = normalVector(3, random);
    bodies[3].inverseInertia = axis * axis.transpose();
    bodies[5].inverseMass.setZero();
    bodies[5].inverseInertia.setZero();
    const int ends[][2] = {{0, 1},          {1, 2},          {5, 2}, {2, 3},
                           {3, fixedWorld}, {fixedWorld, 4}, {4, 0}};
    int k = 0;
    for (const auto& [a, b] : ends) {
      contacts.push_back(randomContact(a, b, k++ % 3 == 0 ? 0 : uniform(random, 0, 2), random));
      rows.push_back(randomRow(b, a, random));
    }
  }
};

TEST(Assemble, QIsTheRelativeVelocityOfTheFreeMotion) {
  Random random(31);
  for (int k = 0; k < 50; ++k) {
    const Step s(random);
    const std::vector<Island> islands = splitIslands(s.bodies, s.contacts, s.rows);
    ASSERT_EQ(islands.size(), 1u);
    const Problem problem = assemble(s.bodies, s.contacts, s.rows, islands[0]);
    const VectorXd truth = relativeVelocity(s.bodies, s.contacts, s.rows, islands[0]);
    EXPECT_LT((problem.q - truth).cwiseAbs().maxCoeff(), 1e-13);
    // Where the velocities of two bodies cancel in q, roundOff says what their rounding leaves.
    EXPECT_GT(problem.roundOff, 0);
    EXPECT_LT(problem.roundOff, 1e-13);
  }
}

// Of bodies that fall together what forces give them is the least that counts as a demand; of those
// that something holds, any demand may count.
TEST(Assemble, NoDemandOfWhatFallsIsLessThanWhatForcesGive) {
  Random random(34);
  std::vector<Body> bodies = {randomBody(random), randomBody(random), Body()};
  bodies[0].gain = 1e4;
  bodies[1].gain = 2e4;
  const std::vector<Contact> contacts = {randomContact(1, 0, 0.5, random)};
  std::vector<Row> rows = {randomRow(0, 1, random)};
  const auto leastDemand = [&] {
    const std::vector<Island> islands = splitIslands(bodies, contacts, rows);
    const Problem problem = assemble(bodies, contacts, rows, islands.at(0));
    EXPECT_GE(problem.demand(), problem.leastDemand);
    return problem.leastDemand;
  };
  EXPECT_EQ(leastDemand(), 1e4);
  for (const int held : {fixedWorld, 2}) {
    rows.push_back(randomRow(1, held, random));
    EXPECT_EQ(leastDemand(), 0) << held;
    rows.pop_back();
  }
  bodies[1].gain = 0;
  EXPECT_EQ(leastDemand(), 0);
}

// u = W r + q, seen from the bodies: the reactions push them, and then their motion is read.
TEST(Assemble, WIsWhatReactionsDoToTheBodies) {
  Random random(32);
  for (int k = 0; k < 50; ++k) {
    const Step s(random);
    const Island island = splitIslands(s.bodies, s.contacts, s.rows).at(0);
    const Problem problem = assemble(s.bodies, s.contacts, s.rows, island);
    const VectorXd r = normalVector(problem.size(), random);
    std::vector<Body> after = s.bodies;
    applyReaction(after, s.contacts, s.rows, island, r);
    const VectorXd u = relativeVelocity(after, s.contacts, s.rows, island) +
                       compliances(s.contacts, s.rows, island).cwiseProduct(r);
    const VectorXd predicted = problem.W * r + problem.q;
    EXPECT_LT((predicted - u).norm(), 1e-13 * (1 + u.norm())) << "sample " << k;

    // Bodies that cannot move have not moved.
    EXPECT_EQ(after[5].velocity, s.bodies[5].velocity);
    EXPECT_EQ(after[1].velocity[2], s.bodies[1].velocity[2]);
  }
}

// W is symmetric and positive semi-definite, and its parts agree with the whole.
TEST(Assemble, WIsOneMatrixHoweverItIsAsked) {
  Random random(33);
  const Step s(random);
  const Island island = splitIslands(s.bodies, s.contacts, s.rows).at(0);
  const Problem problem = assemble(s.bodies, s.contacts, s.rows, island);
  const MatrixXd W = problem.W.dense();
  EXPECT_LT((W - W.transpose()).norm(), 1e-14 * W.norm());
  EXPECT_LT((problem.W.diagonal() - W.diagonal()).norm(), 1e-14 * W.norm());
  for (int i = 0; i < problem.contacts(); ++i)
    EXPECT_LT((problem.W.contactBlock(3 * i) - W.block<3, 3>(3 * i, 3 * i)).norm(),
              1e-14 * W.norm());
  const VectorXd r = normalVector(problem.size(), random);
  EXPECT_LT((problem.W * r - W * r).norm(), 1e-13 * W.norm() * r.norm());
  EXPECT_GT(r.dot(W * r), 0);
}

// What one contact or row responds to itself needs no W.
TEST(Assemble, ItsDiagonalIsThatOfTheSinglePartsAndTheirCompliance) {
  Random random(34);
  const Step s(random);
  const Island island = splitIslands(s.bodies, s.contacts, s.rows).at(0);
  const VectorXd expected = assemble(s.bodies, s.contacts, s.rows, island).W.diagonal() -
                            compliances(s.contacts, s.rows, island);
  std::vector<double> alone;
  for (const int k : island.frictional)
    for (int axis = 0; axis < 3; ++axis) alone.push_back(diagonal(s.bodies, s.contacts[k], axis));
  for (const int k : island.frictionless) alone.push_back(diagonal(s.bodies, s.contacts[k], 0));
  for (const int k : island.rows) alone.push_back(diagonal(s.bodies, s.rows[k]));
  ASSERT_EQ(static_cast<int>(alone.size()), expected.size());
  for (std::size_t i = 0; i < alone.size(); ++i)
    EXPECT_NEAR(alone[i], expected[static_cast<int>(i)], 1e-13 * expected.maxCoeff()) << i;
}

TEST(Assemble, UnknownsStandInTheirOrderWithFrictionAndBounds) {
  Random random(34);
  const Step s(random);
  const Island island = splitIslands(s.bodies, s.contacts, s.rows).at(0);
  const Problem problem = assemble(s.bodies, s.contacts, s.rows, island);
  EXPECT_EQ(island.frictionless, (std::vector<int>{0, 3, 6}));
  EXPECT_EQ(island.frictional, (std::vector<int>{1, 2, 4, 5}));
  ASSERT_EQ(problem.contacts(), 4);
  ASSERT_EQ(problem.rows(), 3 + 7);
  for (int i = 0; i < 4; ++i)
    EXPECT_EQ(problem.friction[i], s.contacts[island.frictional[i]].friction);
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(problem.lower[i], 0);
    EXPECT_EQ(problem.upper[i], infinity);
  }
  for (int i = 0; i < 7; ++i) {
    EXPECT_EQ(problem.lower[3 + i], s.rows[i].lower);
    EXPECT_EQ(problem.upper[3 + i], s.rows[i].upper);
  }
}

//    0 --- 2     1 --- 4        3
// Body 5 is immovable and touches 2 and 4; 3 touches nothing.
TEST(SplitIslands, ImmovableBodiesAndTheGroundLinkNothing) {
  Random random(35);
  std::vector<Body> bodies(6);
  for (int i = 0; i < 5; ++i) bodies[i] = randomBody(random);
  const std::vector<Contact> contacts = {
      randomContact(4, 5, 1, random),          randomContact(0, 2, 0, random),
      randomContact(2, 5, 1, random),          randomContact(5, fixedWorld, 1, random),
      randomContact(fixedWorld, 0, 1, random), randomContact(1, fixedWorld, 1, random),
  };
  const std::vector<Row> rows = {randomRow(4, 1, random), randomRow(fixedWorld, 5, random)};

  const std::vector<Island> islands = splitIslands(bodies, contacts, rows);
  ASSERT_EQ(islands.size(), 2u);
  EXPECT_EQ(islands[0].bodies, (std::vector<int>{0, 2}));
  EXPECT_EQ(islands[0].frictional, (std::vector<int>{2, 4}));
  EXPECT_EQ(islands[0].frictionless, (std::vector<int>{1}));
  EXPECT_TRUE(islands[0].rows.empty());
  EXPECT_EQ(islands[1].bodies, (std::vector<int>{1, 4}));
  EXPECT_EQ(islands[1].frictional, (std::vector<int>{0, 5}));
  EXPECT_EQ(islands[1].rows, (std::vector<int>{0}));
}

// Random graphs compared with plain reachability.
TEST(SplitIslands, AreTheConnectedComponents) {
  Random random(36);
  for (int k = 0; k < 200; ++k) {
    const int n = 1 + k % 25;
    std::vector<Body> bodies(n);
    for (Body& body : bodies)
      if (uniform(random, 0, 1) < 0.9) body = randomBody(random);
    std::uniform_int_distribution<int> any(-1, n - 1);
    std::vector<Contact> contacts;
    Eigen::MatrixXi linked = Eigen::MatrixXi::Identity(n, n);
    for (int i = 0; i < n; ++i) {
      const int a = any(random), b = any(random);
      if (a == b) continue;
      contacts.push_back(randomContact(a, b, i % 2, random));
      if (a >= 0 && b >= 0 && bodies[a].movable() && bodies[b].movable())
        linked(a, b) = linked(b, a) = 1;
    }
    for (int m = 0; m < n; ++m) linked = (linked * linked).cwiseMin(1);

    std::size_t seen = 0;
    int firstBody = -1;
    for (const Island& island : splitIslands(bodies, contacts, {})) {
      EXPECT_GT(island.bodies.front(), firstBody);
      firstBody = island.bodies.front();
      EXPECT_TRUE(std::is_sorted(island.bodies.begin(), island.bodies.end()));
      EXPECT_EQ(static_cast<int>(island.bodies.size()), linked.row(firstBody).sum());
      for (const int body : island.bodies) EXPECT_TRUE(linked(firstBody, body));
      for (const auto* list : {&island.frictional, &island.frictionless}) {
        EXPECT_TRUE(std::is_sorted(list->begin(), list->end()));
        seen += list->size();
        for (const int i : *list)
          for (const int body : {contacts[i].a, contacts[i].b})
            EXPECT_TRUE(body < 0 || !bodies[body].movable() || linked(firstBody, body));
      }
    }
    const auto felt = std::count_if(contacts.begin(), contacts.end(), [&](const Contact& c) {
      return (c.a >= 0 && bodies[c.a].movable()) || (c.b >= 0 && bodies[c.b].movable());
    });
    EXPECT_EQ(static_cast<std::ptrdiff_t>(seen), felt);
  }
}

// An Assembler keeps storage from step to step; that does not show.
TEST(Assembler, HasNoMemory) {
  Random random(37);
  Assembler assembler;
  for (int k = 0; k < 5; ++k) {
    Step s(random);
    s.contacts.resize(7 - k);
    s.rows.resize(k);
    assembler.split(s.bodies, s.contacts, s.rows);
    const std::vector<Island> fresh = splitIslands(s.bodies, s.contacts, s.rows);
    ASSERT_EQ(assembler.islands(), static_cast<int>(fresh.size()));
    for (int i = 0; i < assembler.islands(); ++i) {
      const Problem& kept = assembler.assemble(s.bodies, s.contacts, s.rows, assembler.island(i));
      const Problem problem = assemble(s.bodies, s.contacts, s.rows, fresh[i]);
      EXPECT_EQ(kept.q, problem.q);
      EXPECT_EQ(kept.W.dense(), problem.W.dense());
      EXPECT_EQ(kept.friction, problem.friction);
      EXPECT_EQ(kept.lower, problem.lower);
      EXPECT_EQ(kept.upper, problem.upper);
      EXPECT_EQ(kept.roundOff, problem.roundOff);
    }
  }
}

}  // namespace
}  // namespace delassus
