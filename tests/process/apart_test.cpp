// Work in a process of its own: its numbers come back, its accidents do not.
#include "demos/process/apart.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>

namespace demos {
namespace {

TEST(RunApart, BringsTheNumbersBack) {
  std::vector<double> sent;
  for (int i = 0; i < 100000; ++i) sent.push_back(1.0 / (i + 1));
  const ApartResult result = runApart([&] { return sent; }, {60});
  EXPECT_EQ(result.ending, Ending::Done);
  EXPECT_EQ(result.numbers, sent);
}

TEST(RunApart, LeavesThisProcessAsItIs) {
  int state = 1;
  runApart(
      [&] {
        state = 2;
        return std::vector<double>{};
      },
      {60});
  EXPECT_EQ(state, 1);
}

TEST(RunApart, EndsWorkThatNeverEnds) {
  const ApartResult result = runApart(
      []() -> std::vector<double> {
        while (true) pause();
      },
      {0.05});
  EXPECT_EQ(result.ending, Ending::TimeLimit);
  EXPECT_TRUE(result.numbers.empty());
}

TEST(RunApart, SurvivesACrashAndAnException) {
  EXPECT_EQ(runApart([]() -> std::vector<double> { _exit(3); }, {60}).ending, Ending::Crashed);
  EXPECT_EQ(runApart([]() -> std::vector<double> { throw 1; }, {60}).ending, Ending::Crashed);
}

/// The status with which a child of this process ended; 0 if it still runs after ten seconds.
int statusOf(pid_t child) {
  int status = 0;
  for (int i = 0; i < 200; ++i) {
    if (waitpid(child, &status, WNOHANG) == child) return status;
    usleep(50000);
  }
  return 0;
}

// Whoever kills a process with work apart does not know of that work: it must end as well.
TEST(RunApart, EndsWithItsParent) {
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  // An orphan becomes a child of this process.
  ASSERT_EQ(prctl(PR_SET_CHILD_SUBREAPER, 1), 0);
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
  const int status = statusOf(work);
  EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL) << status;
  if (status == 0) kill(work, SIGKILL);
  prctl(PR_SET_CHILD_SUBREAPER, 0);
  close(ends[0]);
  close(ends[1]);
}

}  // namespace
}  // namespace demos
