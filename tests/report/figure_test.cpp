// Figures: what a script says is what is meant.
#include "demos/report/figure.h"

#include <gtest/gtest.h>

namespace demos::report {
namespace {

TEST(Figure, LiteralsAreNeitherEndedNorRun) {
  EXPECT_EQ(literal("a {b}_c"), R"("a {b}_c")");
  EXPECT_EQ(literal(R"(say "x" \n)"), R"("say \"x\" \\n")");
  EXPECT_EQ(literal("`ls`"), R"("\`ls\`")");
}

}  // namespace
}  // namespace demos::report
