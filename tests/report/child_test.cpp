// Work in a process of its own: its numbers come back, its accidents do not.
#include "demos/report/child.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
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

/// True once no process of that number runs any more; looks for a while.
bool goesAway(pid_t process) {
  for (int i = 0; i < 200; ++i) {
    if (kill(process, 0) != 0) return true;
    usleep(50000);
  }
  return false;
}

// Whoever kills a process with work apart does not know of the work.
TEST(RunApart, endsWithItsParent) {
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  const pid_t parent = fork();
  if (parent == 0) {
    runApart(
        [&]() -> std::vector<double> {
          const pid_t self = getpid();
          if (write(ends[1], &self, sizeof self) != sizeof self) _exit(1);
          while (true) pause();
        },
        {60});
    _exit(0);
  }
  pid_t work = 0;
  ASSERT_EQ(read(ends[0], &work, sizeof work), ssize_t(sizeof work));
  kill(parent, SIGKILL);
  waitpid(parent, nullptr, 0);
  EXPECT_TRUE(goesAway(work));
  close(ends[0]);
  close(ends[1]);
}

TEST(CallCommand, returnsStatusAndText) {
  const CommandResult echo = callCommand({"echo", "two words"});
  EXPECT_EQ(echo.status, 0);
  EXPECT_EQ(echo.text, "two words\n");
  EXPECT_EQ(callCommand({"no-such-command-anywhere"}).status, 127);
}

}  // namespace
}  // namespace demos::report
