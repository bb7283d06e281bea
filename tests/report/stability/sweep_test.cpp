/// The errors from which the stability map is drawn.
#include "demos/report/stability/sweep.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "demos/scenes/builders.h"
#include "demos/scenes/measures.h"

namespace demos::report::stability {
namespace {

// A lost body has neither a place nor an energy: no error may call that rest.
TEST(Sweep, ALostBodyIsNotAtRest) {
  const btScalar notANumber = std::numeric_limits<btScalar>::quiet_NaN();
  for (const int lost : {0, 2}) {  // the first and the last body that are looked at
    Trial drift = drifting(buildStack(3, 1), 1), gain = gaining(buildStack(3, 1), 1);
    for (Trial* trial : {&drift, &gain}) {
      EXPECT_EQ(trial->error(0), 0);
      btRigidBody& body = *trial->world->movableBodies()[std::size_t(lost)];
      EXPECT_TRUE(isFinite(*trial->world));
      body.setWorldTransform(btTransform(btQuaternion::getIdentity(), btVector3(0, notANumber, 0)));
      EXPECT_TRUE(std::isnan(trial->error(0)));
      EXPECT_FALSE(isFinite(*trial->world));
    }
  }
}

}  // namespace
}  // namespace demos::report::stability
