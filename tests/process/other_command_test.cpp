#include "demos/process/other_command.h"

#include <gtest/gtest.h>

namespace demos {
namespace {

TEST(CallCommand, ReturnsStatusAndText) {
  const CommandResult echo = callCommand({"echo", "two words"});
  EXPECT_EQ(echo.status, 0);
  EXPECT_EQ(echo.text, "two words\n");
  EXPECT_EQ(callCommand({"no-such-command-anywhere"}).status, 127);
}

}  // namespace
}  // namespace demos
