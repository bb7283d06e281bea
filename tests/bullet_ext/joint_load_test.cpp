/// The reactions from which the rows of a joint start: those that bear its last load.
#include "bullet_ext/joint_load.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <utility>
#include <vector>

#include "bullet_ext/convert.h"
#include "bullet_ext/memory.h"
#include "bullet_ext/solve_group.h"
#include "tests/support/bullet_world.h"

namespace delassus::test {
namespace {

using namespace delassus::bullet;

/// A joint that ties a body to the world, as the solver gathers it.
class Tie {
 public:
  /// A limit of the turn about the last of `axes`, if there is one, comes first. The other rows
  /// hold the point at `arm`, and the turns about the first two axes.
  Group rowsOf(const Mat3& axes, bool withLimit) {
    Group group;
    group.bodies.emplace_back().inverseMass.setOnes();
    group.bodySources = {{&body_, Vec6::Zero()}};
    const auto addRow = [&](const Vec3& linear, const Vec3& angular) -> Row& {
      Row& row = group.rows.emplace_back();
      row.a = 0;
      row.jacobianA << linear.transpose(), angular.transpose();
      return row;
    };
    if (withLimit) addRow(Vec3::Zero(), axes.col(2)).lower = 0;
    for (int i : {0, 1, 2}) addRow(axes.col(i), arm_.cross(axes.col(i)));
    for (int i : {0, 1}) addRow(Vec3::Zero(), axes.col(i));
    const auto rows = static_cast<int>(group.rows.size());
    group.joints = {{&joint_, 0, rows, rows - 1, lastImpulse_}};
    return group;
  }
  /// The guess for `rows` after a step in which the rows of `last` had these reactions.
  std::vector<double> recall(const Group& last, const std::vector<double>& reactions, Group rows) {
    Answer answer;
    answer.rows = reactions;
    lastImpulse_ = rows.joints[0].lastImpulse = reactions.back();
    Memory memory;
    memory.nextStep();
    memory.keep(last, answer, h);
    memory.nextStep();
    memory.recall(rows);
    return rows.rowGuess;
  }
  static Vec6 wrench(const Group& group, const std::vector<double>& reactions) {
    Vec6 sum = Vec6::Zero();
    for (std::size_t i = 0; i < group.rows.size(); ++i)
      sum += reactions[i] * group.rows[i].jacobianA.transpose();
    return sum;
  }

 private:
  DelassusWorld world_;
  btRigidBody& body_ = world_.addBox({1, 0.5, btScalar(0.2)}, {0, 0, 0}, 3);
  btPoint2PointConstraint joint_{body_, btVector3(0, 0, 0)};
  const Vec3 arm_{1, 0.2, -0.3};
  double lastImpulse_ = 0;
};

TEST(JointLoad, ARowThatStaysHasAllItsDigits) {
  Tie tie;
  const Group last = tie.rowsOf(Mat3::Identity(), true);
  const Mat3 turned = Eigen::AngleAxisd(0.01, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  const std::vector<double> reactions{0.5, 1, 2, 3, 4, 5};
  EXPECT_EQ(tie.recall(last, reactions, tie.rowsOf(turned, true)), reactions);
}

// What rows push against each other, as motors against limits, is no load, but rounding.
TEST(JointLoad, RowsThatPushAgainstEachOtherKeepTheirDigits) {
  Tie tie;
  const auto rowsAt = [&](double angle) {
    Group group = tie.rowsOf(Mat3::Identity(), false);
    for (int i = 0; i < 3; ++i) {
      const double turn = angle + i * 2 * M_PI / 3;
      group.rows[i].jacobianA << std::cos(turn), std::sin(turn), 0, 0, 0, 0;
    }
    return group;
  };
  const std::vector<double> reactions{7, 7, 7, 0, 0x1p-60};  // a float, as a joint carries it
  EXPECT_EQ(tie.recall(rowsAt(0), reactions, rowsAt(0.01)), reactions);
}

// A limit that comes or goes shifts the rows of its joint, and Bullet may turn the others about the
// joint's axis. The joint bears the same load all the same.
TEST(JointLoad, AJointWithOtherRowsBearsOn) {
  Tie tie;
  const Mat3 before = Mat3::Identity();
  const Mat3 turned = Eigen::AngleAxisd(1, Vec3::UnitZ()).toRotationMatrix();
  for (const bool hadLimit : {false, true}) {
    for (const bool hasLimit : {false, true}) {
      for (const Mat3& after : {before, turned}) {
        if (hadLimit == hasLimit && after == before) continue;
        SCOPED_TRACE(testing::Message() << hadLimit << hasLimit << "\n" << after);
        const Group last = tie.rowsOf(before, hadLimit), now = tie.rowsOf(after, hasLimit);
        std::vector<double> reactions{1, 2, 3, 4, 5};
        if (hadLimit) reactions.insert(reactions.begin(), 0);
        const Vec6 load = tie.wrench(last, reactions);
        const std::vector<double> guess = tie.recall(last, reactions, now);
        EXPECT_LT((tie.wrench(now, guess) - load).norm(), 1e-6 * load.norm());
        if (hasLimit) {
          EXPECT_NEAR(guess[0], 0, 1e-6) << "the others can bear it";
        }
      }
    }
  }
}

// What the other rows cannot bear they miss by as little as possible: no row could help, measured
// by what impulses and moments do to the body.
TEST(JointLoad, ALimitThatGoesTakesItsLoadAlong) {
  Tie tie;
  const Group last = tie.rowsOf(Mat3::Identity(), true), now = tie.rowsOf(Mat3::Identity(), false);
  const std::vector<double> reactions{7, 0, 0, 0, 0, 1};
  const btRigidBody& body = *now.bodySources[0].rigid;
  Vec6 answers;  // of the body to impulses and moments
  answers << Vec3::Constant(body.getInvMass()),
      Vec3::Constant(toCore(body.getInvInertiaTensorWorld()).trace() / 3);
  const Vec6 missed =
      tie.wrench(now, tie.recall(last, reactions, now)) - tie.wrench(last, reactions);
  EXPECT_GT(missed.norm(), 1);
  for (const Row& row : now.rows)
    EXPECT_NEAR(row.jacobianA * answers.cwiseProduct(missed), 0, 1e-6);
}

// Forces go on where the length of steps changes, and impulses are these forces times h.
TEST(JointLoad, IsThatOfAStepOfThisLength) {
  Tie tie;
  Group last = tie.rowsOf(Mat3::Identity(), false);
  for (Row& row : last.rows) row.jacobianB = -2 * row.jacobianA;
  Answer answer;
  answer.rows = {1, 2, 3, 4, 0};
  Memory memory;
  memory.nextStep();
  memory.keep(last, answer, h);
  memory.nextStep();
  Group now = last;
  now.joints[0].lastImpulse = -0.0;  // as such joints carry it
  memory.recall(now);
  memory.fitTimeStep(now, h / 2);
  const Vec6 half = Tie::wrench(last, answer.rows) / 2;
  EXPECT_LT((now.joints[0].lastLoad.onA - half).norm(), 1e-9);
  EXPECT_LT((now.joints[0].lastLoad.onB + 2 * half).norm(), 1e-9);
}

// The joint bears on as its other body feels it, about another centre.
TEST(JointLoad, AJointWhoseFirstBodyStopsBearsOn) {
  Tie tie;
  Group last = tie.rowsOf(Mat3::Identity(), true), now = tie.rowsOf(Mat3::Identity(), false);
  for (Group* group : {&last, &now}) {
    for (Row& row : group->rows) {
      row.jacobianB = row.jacobianA;
      row.jacobianA.tail<3>() += Vec3(1, 2, 3).cross(row.jacobianA.head<3>().transpose());
    }
  }
  for (Row& row : now.rows) std::swap(row.a, row.b);
  const auto wrenchOnB = [](const Group& group, const std::vector<double>& reactions) {
    Vec6 sum = Vec6::Zero();
    for (std::size_t i = 0; i < group.rows.size(); ++i)
      sum += reactions[i] * group.rows[i].jacobianB.transpose();
    return sum;
  };
  const std::vector<double> reactions{0, 1, 2, 3, 4, 5};
  const Vec6 load = wrenchOnB(last, reactions);
  EXPECT_LT((wrenchOnB(now, tie.recall(last, reactions, now)) - load).norm(), 1e-6 * load.norm());
}

}  // namespace
}  // namespace delassus::test
