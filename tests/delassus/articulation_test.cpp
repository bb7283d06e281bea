/// Trees of bodies that move together: the problem of an island compared with W = J M⁻¹ Jᵀ, written
/// out.

#include "delassus/articulation.h"

#include <gtest/gtest.h>

#include <sstream>

#include "delassus/motion_space.h"
#include "delassus/problem_text.h"
#include "delassus/solver.h"
#include "tests/support/random_problems.h"

namespace delassus {
namespace {

MatrixXd rootOf(const MatrixXd& inverseMass) {
  MatrixXd B;
  RootFinder().find(inverseMass, B);
  return B;
}

TEST(Articulation, RootOfInverseMassSquaresToIt) {
  Random random(3);
  for (int n : {1, 4, 13}) {
    const MatrixXd inverseMass = randomDelassus(n, 1e4, random);
    const MatrixXd B = rootOf(inverseMass);
    EXPECT_LE((B * B.transpose() - inverseMass).norm(), 1e-12 * inverseMass.norm());
  }
}

TEST(Articulation, RootOfInverseMassWithAFixedBase) {
  Random random(4);
  MatrixXd inverseMass = MatrixXd::Zero(9, 9);
  inverseMass.bottomRightCorner(3, 3) = randomDelassus(3, 100, random);
  const MatrixXd B = rootOf(inverseMass);
  EXPECT_LE((B * B.transpose() - inverseMass).norm(), 1e-14);
  EXPECT_TRUE(B.topRows(6).isZero(0));
  EXPECT_TRUE(rootOf(MatrixXd::Zero(6, 6)).isZero(0));
}

/// A tree of eight freedoms with two limbs, a rigid body, and a body apart from both. The limbs lie
/// on the rigid body and on the ground; a row pulls a joint towards the rigid body.
struct Scene {
  static constexpr int freedoms = 8, limb1 = 0, limb2 = 1, rigid = 2, stem = 3, apart = 4;

  Scene() : random(5), inverseMass(randomDelassus(freedoms, 50, random)) {
    L1 = normalMatrix(6, freedoms, random);
    L2 = normalMatrix(6, freedoms, random);
    v = normalVector(freedoms, random);
    const MatrixXd B = rootOf(inverseMass);
    articulation.trees.push_back({B});
    articulation.limbs.push_back({limb1, 0, L1 * B});
    articulation.limbs.push_back({limb2, 0, L2 * B});
    articulation.limbs.push_back({stem, 0, Matrix6X::Zero(6, freedoms)});

    bodies.resize(5);
    for (Body& body : bodies) {
      body.inverseMass.setOnes();
      body.inverseInertia.setIdentity();
    }
    bodies[limb1].velocity = L1 * v;
    bodies[limb2].velocity = L2 * v;
    bodies[rigid].inverseMass.setConstant(0.5);
    bodies[rigid].inverseInertia = randomDelassus(3, 10, random);
    bodies[rigid].velocity = normalVector(6, random);

    addContact(limb1, rigid, 0.7);
    addContact(limb2, fixedWorld, 0);
    addContact(apart, fixedWorld, 0.3);
    jointEffect = normalVector(freedoms, random);
    Row row;
    row.a = stem;
    row.b = rigid;
    row.jacobianB = normalVector(6, random).transpose();
    row.target = 0.2 - jointEffect.dot(v);
    rows.push_back(row);
    articulation.jointRows.push_back({0, 0, B.transpose() * jointEffect});
  }

  void addContact(int a, int b, double friction) {
    Contact contact;
    contact.a = a;
    contact.b = b;
    contact.armA = normalVector(3, random);
    contact.armB = normalVector(3, random);
    contact.friction = friction;
    contact.compliance = 0.01;
    contacts.push_back(contact);
  }

  /// Velocity of the contact's point on a body: [ I, −[arm]× ].
  static MatrixXd pointJacobian(const Vec3& arm) {
    MatrixXd J(3, 6);
    J << MatrixXd::Identity(3, 3),
        (Mat3() << 0, arm[2], -arm[1], -arm[2], 0, arm[0], arm[1], -arm[0], 0).finished();
    return J;
  }

  Random random;
  MatrixXd inverseMass, L1, L2;
  VectorXd v, jointEffect;
  Articulation articulation;
  std::vector<Body> bodies;
  std::vector<Contact> contacts;
  std::vector<Row> rows;
};

TEST(Articulation, JoinsIslandsThatATreeCouples) {
  Scene scene;
  Assembler assembler;
  assembler.split(scene.bodies, scene.contacts, scene.rows);
  EXPECT_EQ(assembler.islands(), 3);
  IslandJoiner joiner;
  const KeptList<Island>& islands = joiner.join(assembler, scene.articulation);
  ASSERT_EQ(islands.size(), 2u);
  EXPECT_EQ(islands[0].bodies, (std::vector<int>{0, 1, 2, 3}));
  EXPECT_EQ(islands[0].frictional, std::vector<int>{0});
  EXPECT_EQ(islands[0].frictionless, std::vector<int>{1});
  EXPECT_EQ(islands[0].rows, std::vector<int>{0});
  EXPECT_EQ(islands[1].frictional, std::vector<int>{2});
  EXPECT_TRUE(scene.articulation.moves(islands[0]));
  EXPECT_FALSE(scene.articulation.moves(islands[1]));
}

/// The island of the tree with a contact that couples its two limbs; and the same written out.
struct Coupled {
  static constexpr int n = Scene::freedoms;

  Coupled() : J(MatrixXd::Zero(8, n + 6)), inverseMass(MatrixXd::Zero(n + 6, n + 6)) {
    scene.addContact(Scene::limb1, Scene::limb2, 0.5);
    assembler.split(scene.bodies, scene.contacts, scene.rows);
    const Island island = IslandJoiner().join(assembler, scene.articulation)[0];
    const Problem& apart = assembler.assemble(scene.bodies, scene.contacts, scene.rows, island);
    problem = coupling.couple(scene.articulation, apart, island);

    // Unknowns: three each of contacts 0 and 3, the normal of contact 1, the row. Freedoms: those
    // of the tree, then those of the rigid body.
    const auto at = [&](int contact, bool a) {
      const Contact& c = scene.contacts[contact];
      return Scene::pointJacobian(a ? c.armA : c.armB);
    };
    J.topLeftCorner(3, n) = at(0, true) * scene.L1;
    J.topRightCorner(3, 6) = -at(0, false);
    J.block(3, 0, 3, n) = at(3, true) * scene.L1 - at(3, false) * scene.L2;
    J.row(6).head(n) = at(1, true).row(0) * scene.L2;
    J.row(7).head(n) = scene.jointEffect.transpose();
    J.row(7).tail(6) = scene.rows[0].jacobianB;
    const Body& rigid = scene.bodies[Scene::rigid];
    inverseMass.topLeftCorner(n, n) = scene.inverseMass;
    inverseMass.block<3, 3>(n, n) = rigid.inverseMass.asDiagonal();
    inverseMass.bottomRightCorner<3, 3>() = rigid.inverseInertia;
  }

  Scene scene;
  Assembler assembler;
  Coupling coupling;
  Problem problem;
  MatrixXd J, inverseMass;
};

TEST(Articulation, ProblemAndGainAreThoseOfTheWholeMassMatrix) {
  Coupled c;
  MatrixXd W = c.J * c.inverseMass * c.J.transpose();
  for (int normal : {0, 3, 6}) W(normal, normal) += 0.01;
  VectorXd velocity(Coupled::n + 6);
  velocity << c.scene.v, c.scene.bodies[Scene::rigid].velocity;
  VectorXd q = c.J * velocity;
  q[7] -= 0.2;
  EXPECT_LE((c.problem.W.dense() - W).norm(), 1e-12 * W.norm());
  EXPECT_LE((c.problem.W.diagonal() - W.diagonal()).norm(), 1e-12 * W.norm());
  for (int contact : {0, 3})
    EXPECT_LE((c.problem.W.contactBlock(contact) - W.block<3, 3>(contact, contact)).norm(),
              1e-12 * W.norm());
  EXPECT_LE((c.problem.q - q).norm(), 1e-12 * q.norm());
  EXPECT_EQ(c.problem.friction, Vec2(0.7, 0.5));

  const VectorXd r = normalVector(8, c.scene.random);
  EXPECT_LE((c.problem.W * r - W * r).norm(), 1e-12 * W.norm() * r.norm());
  TreeGains gains;
  gains.reset(c.scene.articulation);
  c.coupling.addGain(c.scene.articulation, r, gains);
  const VectorXd gain = c.scene.inverseMass * c.J.leftCols(Coupled::n).transpose() * r;
  EXPECT_LE((gains.of[0] - gain).norm(), 1e-12 * gain.norm());
}

TEST(Articulation, NewtonMatrixOfARegionIsThatOfTheWholeJacobian) {
  Coupled c;
  Stiffness G;
  MatrixXd dense = MatrixXd::Zero(8, 8);
  for (int i : {0, 1}) {
    G.contacts.emplace_back(randomDelassus(3, 10, c.scene.random));
    G.contacts.back()(1, 2) += 0.3;  // sliding contacts have no symmetric derivative
    dense.block<3, 3>(3 * i, 3 * i) = G.contacts.back();
  }
  G.rows = Vec2(2, 3);
  dense.bottomRightCorner(2, 2) = G.rows.asDiagonal();

  const BodySpace& space = c.problem.W.bodySpace();
  const int columns = 6 * space.bodies;
  MatrixXd J(8, columns);
  for (int k = 0; k < columns; ++k) {
    VectorXd u;
    space.relativeVelocity(VectorXd::Unit(columns, k), u);
    J.col(k) = u;
  }
  BodyMotion motion;
  motion.setProblem(c.problem);
  ASSERT_TRUE(motion.factorise(G));
  const VectorXd y = normalVector(columns, c.scene.random);
  VectorXd x = y;
  motion.solve(x);
  EXPECT_LE((x + J.transpose() * dense * J * x - y).norm(), 1e-11 * y.norm());
}

TEST(Articulation, ProblemIsSolvedAsItsExplicitEntriesAre) {
  const Coupled c;
  Problem written = c.problem;
  written.W = DelassusMatrix(DelassusMatrix::Sparse(c.problem.W.dense().sparseView()));
  const Solution ours = solve(c.problem), theirs = solve(written);
  EXPECT_EQ(ours.status, Status::Solved);
  EXPECT_EQ(ours.activeSet, theirs.activeSet);
  EXPECT_LE((ours.u - theirs.u).norm(), 1e-7 * c.problem.q.norm());
}

TEST(Articulation, ContactsOfATreeAreWrittenWithAllTheyMove) {
  const Coupled c;
  BodySpace space = c.problem.W.bodySpace();
  space.rows.clear();
  space.parts.erase(space.partsOf(6).begin() - space.parts.data() + space.parts.begin(),
                    space.parts.end());
  space.compliance = VectorXd(space.compliance.head(6));
  Problem contacts;
  contacts.W = DelassusMatrix(space);
  contacts.q = c.problem.q.head(6);
  contacts.friction = c.problem.friction;
  std::stringstream text;
  writeProblem(text, contacts);
  const MatrixXd W = contacts.W.dense();
  EXPECT_LE((readProblem(text, "text").W.dense() - W).norm(), 1e-14 * W.norm());
}

}  // namespace
}  // namespace delassus
