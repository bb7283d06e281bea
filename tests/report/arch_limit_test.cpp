// The least thickness of arches, compared with what is known of it.
#include "demos/report/stability/arch_limit.h"

#include <gtest/gtest.h>

namespace demos::report::stability {
namespace {

// Milankovitch 1907: t/R tends to 0.1075 for ever more joints.
TEST(ArchLimit, OfManyVoussoirsIsMilankovitchs) {
  EXPECT_NEAR(leastArchThickness(400, 1), 0.1075, 5e-4);
}

TEST(ArchLimit, FewerJointsNeedLess) {
  EXPECT_LT(leastArchThickness(6, 1), leastArchThickness(12, 1));
  EXPECT_LT(leastArchThickness(12, 1), leastArchThickness(400, 1) + 1e-3);
}

TEST(ArchLimit, IsAShareOfTheRadius) {
  EXPECT_NEAR(leastArchThickness(6, 5), 5 * leastArchThickness(6, 1), 1e-9);
}

}  // namespace
}  // namespace demos::report::stability
