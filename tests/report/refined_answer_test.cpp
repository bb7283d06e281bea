// The reference in extended precision, judged by statics that are known exactly.
#include "demos/report/refined_answer.h"

#include <gtest/gtest.h>

#include <cmath>

#include "delassus/solver.h"

namespace demos::report {
namespace {

using delassus::Body;
using delassus::Contact;
using delassus::Island;
using delassus::Mat3;
using delassus::Row;
using delassus::Vec3;
using delassus::VectorXd;

constexpr double fall = 0.1635;  // g h, m/s

Body block(double mass, const Vec3& velocity) {
  Body body;
  body.inverseMass.setConstant(1 / mass);
  body.inverseInertia = Mat3::Identity() * (6 / mass);
  body.velocity.head<3>() = velocity;
  return body;
}

/// A contact with its normal along e_y, through the centres.
Contact under(int body, int below, double mu) {
  Contact contact;
  contact.a = body;
  contact.b = below;
  contact.frame << 0, 1, 0, 1, 0, 0, 0, 0, 1;
  contact.friction = mu;
  return contact;
}

struct Step {
  std::vector<Body> bodies;
  std::vector<Contact> contacts;
  std::vector<Row> rows;

  /// Refines the answer of double precision after every reaction has been made wrong by 1e-6 of it.
  RefinedAnswer refined() const {
    const Island island = delassus::splitIslands(bodies, contacts, rows).front();
    const VectorXd r = delassus::solve(delassus::assemble(bodies, contacts, rows, island)).r;
    return refine(bodies, contacts, rows, island, (1 + 1e-6) * r);
  }
};

TEST(RefinedAnswer, AColumnUnderAWeightOfABillionStands) {
  Step step;
  double above = 0;
  for (int i = 0; i < 10; ++i) {
    const double mass = i == 9 ? 1e9 : 1;
    step.bodies.push_back(block(mass, {0, -fall, 0}));
    step.contacts.push_back(under(i, i - 1, 0.5));
    above += mass;
  }
  const RefinedAnswer answer = step.refined();
  EXPECT_TRUE(answer.certified());
  EXPECT_LT(answer.motion.cwiseAbs().maxCoeff(), 1e-18);
  EXPECT_NEAR(answer.r[0] / (above * fall), 1, 1e-15);
}

TEST(RefinedAnswer, ABlockSlidesAsCoulombSays) {
  // The centre is the point of touch, so nothing turns the block: v_t loses μ g h.
  const double mu = 0.3, speed = 2, heading = 0.7;
  Step step;
  step.bodies = {block(3, {speed * std::cos(heading), -fall, speed * std::sin(heading)})};
  step.contacts = {under(0, delassus::fixedWorld, mu)};
  const RefinedAnswer answer = step.refined();
  EXPECT_TRUE(answer.certified());
  const VectorXd& v = answer.motion;
  EXPECT_NEAR(std::hypot(v[0], v[2]), speed - mu * fall, 1e-15);
  EXPECT_NEAR(v[2] / v[0], std::tan(heading), 1e-15);
  EXPECT_LT(std::abs(v[1]), 1e-18);
}

TEST(RefinedAnswer, RedundantPointsStillGiveOneMotion) {
  Step step;
  step.bodies = {block(1, {0.1, -fall, 0})};
  for (const double x : {-0.5, 0.5})
    for (const double z : {-0.5, 0.5}) {
      step.contacts.push_back(under(0, delassus::fixedWorld, 0.9));
      step.contacts.back().armA = {x, -0.1, z};
    }
  const RefinedAnswer answer = step.refined();
  EXPECT_TRUE(answer.certified());
  // The speed of 0.1 m/s is less than what friction takes: the block stands.
  EXPECT_LT(answer.motion.cwiseAbs().maxCoeff(), 1e-18);
}

TEST(RefinedAnswer, RowsEndAtTheirBounds) {
  // A motor asks for 2 m/s along e_x, with at most 0.5 N·s.
  Step step;
  step.bodies = {block(4, Vec3::Zero())};
  Row motor;
  motor.a = 0;
  motor.jacobianA[0] = 1;
  motor.target = 2;
  motor.lower = -0.5;
  motor.upper = 0.5;
  step.rows = {motor};
  const RefinedAnswer answer = step.refined();
  EXPECT_TRUE(answer.certified());
  EXPECT_EQ(answer.r[0], 0.5);
  EXPECT_EQ(answer.motion[0], 0.125);
}

TEST(RefinedAnswer, ContradictionsAreNotCertified) {
  // A block between two floors that close on it.
  Step step;
  step.bodies = {block(1, Vec3::Zero())};
  step.contacts = {under(0, delassus::fixedWorld, 0), under(0, delassus::fixedWorld, 0)};
  step.contacts[1].frame.col(0) *= -1;
  for (Contact& contact : step.contacts) contact.target[0] = 1;
  const RefinedAnswer answer = step.refined();
  EXPECT_FALSE(answer.certified());
}

}  // namespace
}  // namespace demos::report
