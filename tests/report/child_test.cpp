// Work in a process of its own: its numbers come back, its accidents do not.
#include "demos/report/child.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>

namespace demos::report {
namespace {

TEST(RunApart, bringsTheNumbersBack) {
  std::vector<double> sent;
  for (int i = 0; i < 100000; ++i) sent.push_back(1.0 / (i + 1));
  const ApartResult result = runApart([&] { return sent; }, {60});
  EXPECT_EQ(result.ending, Ending::Done);
  EXPECT_EQ(result.numbers, sent);
}

TEST(RunApart, leavesThisProcessAsItIs) {
  int state = 1;
  runApart(
      [&] {
        state = 2;
        return std::vector<double>{};
      },
      {60});
  EXPECT_EQ(state, 1);
}

TEST(RunApart, endsWorkThatNeverEnds) {
  const ApartResult result = runApart(
      []() -> std::vector<double> {
        while (true) pause();
      },
      {0.05});
  EXPECT_EQ(result.ending, Ending::TimeLimit);
  EXPECT_TRUE(result.numbers.empty());
}

TEST(RunApart, survivesACrashAndAnException) {
  EXPECT_EQ(runApart([]() -> std::vector<double> { _exit(3); }, {60}).ending, Ending::Crashed);
  EXPECT_EQ(runApart([]() -> std::vector<double> { throw 1; }, {60}).ending, Ending::Crashed);
}

TEST(CallCommand, returnsStatusAndText) {
  const CommandResult echo = callCommand({"echo", "two words"});
  EXPECT_EQ(echo.status, 0);
  EXPECT_EQ(echo.text, "two words\n");
  EXPECT_EQ(callCommand({"no-such-command-anywhere"}).status, 127);
}

}  // namespace
}  // namespace demos::report
