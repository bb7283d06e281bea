/// Numbers that are NaN or absurd. The report names the part that has them; the part is left out,
/// and the rest is solved as if it were not there.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "bullet_ext/softness.h"
#include "tests/support/bullet_world.h"

namespace delassus::test {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::IsEmpty;
using ::testing::StartsWith;

constexpr btScalar infinity = std::numeric_limits<btScalar>::infinity();

// ---- Bodies
// -------------------------------------------------------------------------------------------------

struct BrokenBody {
  const char* why;
  std::function<void(btRigidBody&)> breakIt;
};

std::vector<BrokenBody> brokenBodies() {
  const auto place = [](btScalar x) {
    return [x](btRigidBody& body) { body.setWorldTransform(BulletWorld::at({x, 1, 0})); };
  };
  return {
      {"its pose is not finite", place(notANumber)},
      {"its pose is not finite", place(infinity)},
      {"its velocity is not finite",
       [](btRigidBody& body) {
         body.setLinearVelocity({0, notANumber, 0});
       }},
      {"its velocity is not finite",
       [](btRigidBody& body) {
         body.setAngularVelocity({0, infinity, 0});
       }},
      {"its mass is negative",
       [](btRigidBody& body) { body.setMassProps(-1, btVector3(1, 1, 1)); }},
      {"its mass is negative",
       [](btRigidBody& body) {
         body.setLinearFactor({1, -1, 1});
       }},
      {"its mass is negative",
       [](btRigidBody& body) {
         // Turned, so that no diagonal entry of the tensor in world axes is negative.
         body.setWorldTransform(btTransform(btQuaternion(btVector3(1, 1, 1).normalized(), 1),
                                            body.getWorldTransform().getOrigin()));
         body.setMassProps(1, btVector3(1, 1, btScalar(-100)));
         body.updateInertiaTensor();
       }},
      {"its mass is infinite",
       [](btRigidBody& body) { body.setMassProps(infinity, btVector3(1, 1, 1)); }},
      {"its mass is infinite",
       [](btRigidBody& body) { body.setMassProps(SIMD_INFINITY, btVector3(1, 1, 1)); }},
      {"its mass is not finite",
       [](btRigidBody& body) { body.setMassProps(notANumber, btVector3(1, 1, 1)); }},
      {"its mass is not finite",
       [](btRigidBody& body) {
         body.setAngularFactor({1, notANumber, 1});
       }},
      {"the force on it is not finite",
       [](btRigidBody& body) {
         body.applyCentralForce({0, infinity, 0});
       }},
  };
}

TEST(LeftOut, ABrokenBodyIsAsIfItWereNotThere) {
  for (const BrokenBody& broken : brokenBodies()) {
    SCOPED_TRACE(broken.why);
    DelassusWorld world;
    world.addGround();
    btRigidBody& body = world.addCube({0, btScalar(0.5), 0});
    btRigidBody& onIt = world.addCube({0, btScalar(1.5), 0});
    btRigidBody& jointed = world.addCube({0, 5, 0});
    world.addJoint<btPoint2PointConstraint>(body, jointed, btVector3(0, 1, 0), btVector3(0, 1, 0));
    btRigidBody& sound = world.addCube({5, btScalar(0.5), 0});
    world.advance(3);
    btRigidBody* others[] = {&onIt, &jointed};
    for (btRigidBody* other : others) other->setLinearVelocity({0, 0, 0});
    broken.breakIt(body);
    world.advance();

    ASSERT_EQ(world.report().messages.size(), 1u);
    EXPECT_EQ(world.report().messages[0], std::string("body 1 left out: ") + broken.why);
    EXPECT_EQ(world.report().leftOut, 1);
    for (btRigidBody* other : others) {
      EXPECT_NEAR(other->getLinearVelocity().y(), -g * h, 100 * precision) << "falls freely";
      EXPECT_NEAR(other->getAngularVelocity().length(), 0, 100 * precision);
    }
    EXPECT_NEAR(sound.getWorldTransform().getOrigin().y(), 0.5, tolerance(1e-9, 1e-5));
    EXPECT_EQ(world.report().solved, world.report().islands);
  }
}

TEST(LeftOut, NumbersWhoseSquaresOverflow) {
  DelassusWorld world;
  btRigidBody& body = world.addCube({0, 0, 0});
  body.setLinearVelocity({isDouble ? btScalar(1e50) : btScalar(1e35), 0, 0});
  world.advance();
  EXPECT_THAT(world.report().messages, ElementsAre("body 0 left out: its numbers are too large"));
}

TEST(LeftOut, AStaticBodyWithoutAPlace) {
  DelassusWorld world;
  world.addGround();
  btRigidBody& shelf = world.addBox({1, 1, 1}, {5, -1, 0}, 0);
  btRigidBody& onShelf = world.addCube({5, btScalar(0.5), 0});
  world.addJoint<btPoint2PointConstraint>(onShelf, shelf, btVector3(0, 0, 0), btVector3(0, 0, 0));
  shelf.setWorldTransform(BulletWorld::at({5, notANumber, 0}));
  world.advance(3);
  EXPECT_THAT(world.report().messages, ElementsAre("body 1 left out: its pose is not finite"));
  EXPECT_NEAR(onShelf.getLinearVelocity().y(), 0, tolerance(1e-9, 1e-5)) << "the ground is there";
}

TEST(LeftOut, ABodyWithoutMassAndWithoutTheStaticFlagIsAWall) {
  // Users clear the flag by mistake. Such a body has no weight, and nothing is wrong with its
  // numbers.
  DelassusWorld world;
  btRigidBody& wall = world.addBox({5, 1, 5}, {0, -1, 0}, 0);
  wall.setCollisionFlags(0);
  btRigidBody& box = world.addCube({0, btScalar(0.5), 0});
  world.advance(30);
  EXPECT_THAT(world.report().messages, IsEmpty());
  EXPECT_NEAR(box.getWorldTransform().getOrigin().y(), 0.5, tolerance(1e-9, 1e-4));
}

// ---- Contacts
// -------------------------------------------------------------------------------------------------

/// Two balls that fall on the ground with 1 m/s. They are handed over directly, so that nothing
/// refreshes their points.
class TwoContacts {
 public:
  TwoContacts() {
    for (btRigidBody* ball : {&broken_, &sound_}) {
      ball->setWorldTransform(BulletWorld::at({0, btScalar(0.99), 0}));
      ball->setLinearVelocity({0, -1, 0});
    }
  }

  void solve(const std::function<void(btManifoldPoint&)>& breakIt) {
    btPersistentManifold brokenManifold(&broken_, &ground_, 0, btScalar(0.02), 1);
    btPersistentManifold soundManifold(&sound_, &ground_, 0, btScalar(0.02), 1);
    // One centimetre deep.
    btManifoldPoint point({0, -1, 0}, {0, 0, 0}, {0, 1, 0}, btScalar(-0.01));
    point.m_positionWorldOnA = {0, btScalar(-0.01), 0};
    point.m_positionWorldOnB = {0, 0, 0};
    point.m_combinedFriction = btScalar(0.5);
    soundManifold.addManifoldPoint(point);
    breakIt(point);
    brokenManifold.addManifoldPoint(point);

    btPersistentManifold* manifolds[] = {&brokenManifold, &soundManifold};
    btCollisionObject* bodies[] = {&broken_, &sound_};
    btContactSolverInfo info;
    info.m_erp2 = 0;
    info.m_solverMode |=
        SOLVER_ENABLE_FRICTION_DIRECTION_CACHING | SOLVER_USE_2_FRICTION_DIRECTIONS;
    solver.setTroubleListener([this](const ContactEvent& event) { troubles.push_back(event); });
    solver.prepareSolve(2, 2);
    solver.solveGroup(bodies, 2, manifolds, 2, nullptr, 0, info, nullptr, nullptr);
  }
  double brokenSpeed() const { return broken_.getLinearVelocity().y(); }
  double soundSpeed() const { return sound_.getLinearVelocity().y(); }

  btDelassusConstraintSolver solver;
  std::vector<ContactEvent> troubles;

 private:
  btSphereShape shape_{1};
  btRigidBody ground_{0, nullptr, &shape_};
  btRigidBody broken_{1, nullptr, &shape_, btVector3(1, 1, 1)};
  btRigidBody sound_{1, nullptr, &shape_, btVector3(1, 1, 1)};
};

TEST(LeftOut, ABrokenContactIsAsIfItWereNotThere) {
  struct Case {
    const char* why;
    std::function<void(btManifoldPoint&)> breakIt;
  };
  const auto soft = [](btManifoldPoint& p, btScalar cfm) {
    p.m_contactPointFlags = BT_CONTACT_FLAG_HAS_CONTACT_CFM;
    p.m_contactCFM = cfm;
  };
  const Case cases[] = {
      {"its friction is not finite", [](auto& p) { p.m_combinedFriction = notANumber; }},
      {"its restitution is not finite", [](auto& p) { p.m_combinedRestitution = notANumber; }},
      {"its distance is not finite", [](auto& p) { p.m_distance1 = notANumber; }},
      {"its distance is not finite", [](auto& p) { p.m_distance1 = -infinity; }},
      {"its position is not finite", [](auto& p) { p.m_positionWorldOnA[0] = notANumber; }},
      {"its normal is not finite", [](auto& p) { p.m_normalWorldOnB[0] = notANumber; }},
      {"its normal is not a unit vector",
       [](auto& p) {
         p.m_normalWorldOnB = {0, 0, 0};
       }},
      {"its normal is not a unit vector",
       [](auto& p) {
         p.m_normalWorldOnB = {0, 2, 0};
       }},
      {"its normal is not a unit vector",
       [](auto& p) {
         p.m_normalWorldOnB = {0, btScalar(1.0008), 0};
       }},
      {"its normal points into the other body",
       [](auto& p) {
         p.m_normalWorldOnB = {0, -1, 0};
       }},
      {"its softness is not finite", [&](auto& p) { soft(p, notANumber); }},
      {"its softness is not finite", [&](auto& p) { soft(p, infinity); }},
      {"its wanted sliding velocity is not finite",
       [](auto& p) {
         p.m_contactPointFlags = BT_CONTACT_FLAG_LATERAL_FRICTION_INITIALIZED;
         p.m_lateralFrictionDir1 = {1, 0, 0};
         p.m_lateralFrictionDir2 = {0, 0, 1};
         p.m_contactMotion1 = notANumber;
       }},
  };
  for (const Case& c : cases) {
    SCOPED_TRACE(c.why);
    TwoContacts two;
    two.solve(c.breakIt);
    EXPECT_THAT(two.solver.report().messages,
                ElementsAre(AllOf(StartsWith("contact 0 of "), EndsWith(c.why))));
    EXPECT_EQ(two.solver.report().leftOut, 1);
    EXPECT_EQ(two.solver.report().contacts, 1);
    EXPECT_NEAR(two.brokenSpeed(), -1, 10 * precision);
    EXPECT_NEAR(two.soundSpeed(), 0, tolerance(1e-12, 1e-6));

    ASSERT_EQ(two.troubles.size(), 1u);
    EXPECT_EQ(two.troubles[0].trouble, Trouble::LeftOut);
    EXPECT_EQ(two.troubles[0].to, Mode::Open);
  }
}

// Far from the origin, the rounding that is left of a distance may have either sign.
TEST(LeftOut, ADistanceThatIsRoundingDoesNotTellOfItsNormal) {
  TwoContacts two;
  two.solve([](btManifoldPoint& p) {
    p.m_distance1 = -10 * SIMD_EPSILON;
    p.m_positionWorldOnA = {1, 10 * SIMD_EPSILON, 0};
    p.m_positionWorldOnB = {1, 0, 0};
  });
  EXPECT_THAT(two.solver.report().messages, IsEmpty());
  EXPECT_EQ(two.solver.report().contacts, 2);
}

TEST(LeftOut, FrictionWithoutLimitIsNoFault) {
  for (btScalar large : {btScalar(1e18), SIMD_INFINITY, infinity}) {
    DelassusWorld world;
    btRigidBody& ground = world.addGround();
    ground.setWorldTransform(btTransform(btQuaternion(btVector3(0, 0, 1), btScalar(0.7)),
                                         btVector3(btScalar(0.6), btScalar(-0.8), 0)));
    world->updateAabbs();
    btTransform on = ground.getWorldTransform();
    on.setOrigin(on(btVector3(0, btScalar(1.5), 0)));
    btRigidBody& box = world.addBody(std::make_unique<btBoxShape>(btVector3(1, 0.5, 1)), on, 1);
    box.setFriction(large);
    const btVector3 start = box.getWorldTransform().getOrigin();
    gContactAddedCallback = [](btManifoldPoint& point, const btCollisionObjectWrapper* a, int, int,
                               const btCollisionObjectWrapper* b, int, int) {
      // Bullet's own rule limits friction to ten.
      point.m_combinedFriction =
          btMax(a->getCollisionObject()->getFriction(), b->getCollisionObject()->getFriction());
      return true;
    };
    box.setCollisionFlags(btCollisionObject::CF_CUSTOM_MATERIAL_CALLBACK);
    world.advance(60);
    gContactAddedCallback = nullptr;
    EXPECT_THAT(world.report().messages, IsEmpty());
    EXPECT_EQ(world.report().stick, 4);
    EXPECT_EQ(world.report().solved, world.report().islands);
    EXPECT_LT((box.getWorldTransform().getOrigin() - start).length(), 5e-3);
  }
}

// ---- Joints
// -------------------------------------------------------------------------------------------------

/// Holds a body up by one row along y; the row may be broken.
class BrokenJoint : public btTypedConstraint {
 public:
  using Breaking = std::function<void(btConstraintInfo2&)>;
  BrokenJoint(btRigidBody& body, Breaking breakIt)
      : btTypedConstraint(MAX_CONSTRAINT_TYPE, body), breakIt_(std::move(breakIt)) {}
  void getInfo1(btConstraintInfo1* info) override {
    info->m_numConstraintRows = 2;
    info->nub = 4;
  }
  void getInfo2(btConstraintInfo2* info) override {
    info->m_J1linearAxis[0] = 1;
    info->m_J1linearAxis[info->rowskip + 1] = 1;
    breakIt_(*info);
  }
  void setParam(int, btScalar, int) override {}
  btScalar getParam(int, int) const override { return 0; }

 private:
  Breaking breakIt_;
};

TEST(LeftOut, ABrokenRowOfAJointIsAsIfItWereNotThere) {
  struct Case {
    const char* why;
    BrokenJoint::Breaking breakIt;
  };
  const Case cases[] = {
      {"its axis is not finite", [](auto& info) { info.m_J1linearAxis[0] = notANumber; }},
      {"its axis is not finite", [](auto& info) { info.m_J1angularAxis[2] = infinity; }},
      {"its target velocity is not finite",
       [](auto& info) { info.m_constraintError[0] = notANumber; }},
      {"a bound is not a number", [](auto& info) { info.m_lowerLimit[0] = notANumber; }},
      {"a bound is not a number", [](auto& info) { info.m_upperLimit[0] = notANumber; }},
      {"its lower bound is above its upper one",
       [](auto& info) {
         info.m_lowerLimit[0] = 1;
         info.m_upperLimit[0] = -1;
       }},
      {"it asks for an infinite impulse", [](auto& info) { info.m_lowerLimit[0] = SIMD_INFINITY; }},
      {"its softness is not a number >= 0", [](auto& info) { info.cfm[0] = notANumber; }},
      {"its softness is not a number >= 0", [](auto& info) { info.cfm[0] = -1; }},
  };
  for (const Case& c : cases) {
    SCOPED_TRACE(c.why);
    DelassusWorld world;
    btRigidBody& body = world.addCube({0, 0, 0});
    world.addJoint<BrokenJoint>(body, c.breakIt);
    body.setLinearVelocity({1, 0, 0});
    world.advance();
    EXPECT_THAT(world.report().messages,
                ElementsAre(AllOf(StartsWith("row 0 of a joint of body 0 and the world "),
                                  EndsWith(c.why))));
    EXPECT_EQ(world.report().leftOut, 1);
    EXPECT_NEAR(body.getLinearVelocity().x(), 1, 10 * precision);
    EXPECT_NEAR(body.getLinearVelocity().y(), 0, 2 * bullet::leastSoftness * g * h)
        << "the other row holds";
  }
}

// With stock its rows come to nothing, too: what they do to one end they undo at the other.
TEST(LeftOut, AJointOfABodyWithItself) {
  DelassusWorld world;
  btRigidBody& body = world.addCube({0, 5, 0});
  auto& joint = world.addJoint<btHingeConstraint>(
      body, body, btVector3(1, 0, 0), btVector3(-1, 0, 0), btVector3(0, 0, 1), btVector3(0, 0, 1));
  joint.enableAngularMotor(true, 10, 1);
  world.advance();
  EXPECT_THAT(world.report().messages, ElementsAre(EndsWith("it joins a body with itself")));
  EXPECT_NEAR(body.getLinearVelocity().y(), -g * h, 10 * precision);
  EXPECT_LT(body.getAngularVelocity().length(), 10 * precision);
}

TEST(LeftOut, DampingThatIsNoNumberTakesAllRowsOfItsJoint) {
  DelassusWorld world;
  btRigidBody& body = world.addCube({0, 0, 0});
  world.addJoint<BrokenJoint>(body, [](auto& info) { info.m_damping = notANumber; });
  world.advance();
  EXPECT_EQ(world.report().leftOut, 2);
  EXPECT_NEAR(body.getLinearVelocity().y(), -g * h, 100 * precision);
}

}  // namespace
}  // namespace delassus::test
