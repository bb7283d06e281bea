// What the command does with problem files: `solve` and `dump`.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "tests/command_call.h"
#include "tests/support/shared_data.h"

namespace {

using nlohmann::json;

using delassus::test::lines;
using delassus::test::Outcome;
using delassus::test::read;

class ProblemFiles : public delassus::test::CommandCall {
 protected:
  /// One ball with W = 1 is pressed on a plane with friction: the solution is plain.
  std::string easyProblem() const {
    return write("easy.fc3d",
                 "delassus-problem v1\nname easy\ncontacts 1\nblocks 1\nmu\n0.5\nq\n-1 0.1 0\n"
                 "W\n0 0 1 0 0 0 1 0 0 0 1\nend\n");
  }
};

TEST_F(ProblemFiles, SolvesAProblem) {
  const Outcome outcome = call("solve " + easyProblem() + " --json --solution " + file("solution"));
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const json solved = json::parse(outcome.out);
  for (const char* key :
       {"name", "kind", "size", "status", "rel", "vel", "ms", "regions", "islands"})
    EXPECT_TRUE(solved.contains(key)) << key;
  EXPECT_EQ(solved["name"], "easy");
  EXPECT_EQ(solved["size"], 1);
  EXPECT_EQ(solved["islands"], 1);
  EXPECT_EQ(solved["status"], "solved");
  EXPECT_LE(solved["vel"].get<double>(), 1e-8);
  EXPECT_EQ(read(file("solution")).rfind("solution v1\n", 0), 0U);
}

// The kind of an empty problem is that of its file's format.
TEST_F(ProblemFiles, TellsTheKindOfAProblemByItsFormat) {
  const std::string contacts =
      write("none.fc3d", "delassus-problem v1\nname none\ncontacts 0\nblocks 0\nmu\nq\nW\nend\n");
  const std::string rows = write("none.lcp", "lcp v1\nname none\nsize 0\nentries 0\nq\nM\nend\n");
  for (const auto& [path, kind] : {std::pair(contacts, "fc3d"), std::pair(rows, "lcp")}) {
    const Outcome outcome = call("solve --json " + path);
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(json::parse(outcome.out)["kind"], kind);
    EXPECT_EQ(json::parse(outcome.out)["size"], 0);
  }
  EXPECT_NE(call("solve " + contacts).out.find("fc3d, 0 contacts in"), std::string::npos);
}

// printf may give NaN a sign.
TEST_F(ProblemFiles, SaysNanInWordsAndNullInJson) {
  std::string text = read(easyProblem());
  text.replace(text.find("-1 0.1"), 6, "-1e200 0.1");
  const std::string huge = write("huge.fc3d", text);
  const Outcome words = call("solve " + huge);
  EXPECT_EQ(words.status, 3);
  EXPECT_NE(words.out.find("non_finite  rel nan  vel nan  "), std::string::npos) << words.out;
  EXPECT_TRUE(json::parse(call("solve --json " + huge).out)["rel"].is_null());
}

TEST_F(ProblemFiles, DoesNotWriteOverItsInput) {
  const std::string problem = easyProblem(), before = read(problem);
  std::filesystem::create_symlink(problem, file("link"));
  for (const std::string& solution : {problem, file("link"), folder_.string() + "/./easy.fc3d"}) {
    const Outcome outcome = call("solve " + problem + " --solution " + solution);
    EXPECT_EQ(outcome.status, 2) << solution;
    EXPECT_EQ(lines(outcome.err), 1) << outcome.err;
    EXPECT_NE(outcome.err.find(solution), std::string::npos) << outcome.err;
    EXPECT_EQ(read(problem), before);
  }

  // Worlds are recognised by their name, or by how Bullet's files begin.
  write("world.bullet", "somebody's");
  write("world", "BULLETd_v287...");
  write("many-3.bullet", "somebody's");
  for (const auto& [scene, out] :
       {std::pair("one_box", "world.bullet"), std::pair("one_box", "world"),
        std::pair("box_headings", "many.bullet")}) {
    const Outcome outcome = call(std::string("dump ") + scene + " --at 0 --out " + file(out));
    EXPECT_EQ(outcome.status, 2) << out;
    EXPECT_EQ(lines(outcome.err), 1) << outcome.err;
  }
  EXPECT_EQ(read(file("world.bullet")), "somebody's");
  EXPECT_EQ(read(file("many-3.bullet")), "somebody's");
  EXPECT_FALSE(std::filesystem::exists(file("many-0.bullet"))) << "nothing or all of it";
  EXPECT_EQ(call("dump one_box --at 0 --out " + file("new.fc3d")).status, 0);
  EXPECT_EQ(call("dump one_box --at 0 --out " + file("new.fc3d")).status, 0) << "its own, again";
}

// A file keeps what it has until what replaces it is complete.
TEST_F(ProblemFiles, LosesNothingWhereThereIsNoRoom) {
  const std::string problem = easyProblem();
  const std::string solution = write("old.sol", "somebody's"),
                    dumped = write("old.fc3d", "somebody's");
  for (const auto& [arguments, target] :
       {std::pair("solve " + problem + " --solution " + solution, solution),
        std::pair("dump stack_10 --at 0 --out " + dumped, dumped)}) {
    // Files of at most no blocks.
    const std::string line = "(trap '' XFSZ; ulimit -f 0; " + std::string(DELASSUS_COMMAND) + " " +
                             arguments + " 2>&1) | cat > " + file("said");
    ASSERT_EQ(std::system(("bash -c \"" + line + "\"").c_str()), 0);
    EXPECT_NE(read(file("said")).find(target + ": cannot be written"), std::string::npos)
        << read(file("said"));
    EXPECT_EQ(read(target), "somebody's");
    EXPECT_FALSE(std::filesystem::exists(target + ".unfinished"));
  }
}

TEST_F(ProblemFiles, ALinkToASolutionStaysOne) {
  const std::string solution = write("real.sol", "somebody's");
  std::filesystem::create_symlink(solution, file("link.sol"));
  ASSERT_EQ(call("solve " + easyProblem() + " --solution " + file("link.sol")).status, 0);
  EXPECT_TRUE(std::filesystem::is_symlink(file("link.sol")));
  EXPECT_EQ(read(solution).rfind("solution v1\n", 0), 0U);
}

TEST_F(ProblemFiles, NamesFilesOfAnEarlierDump) {
  for (const char* island : {"0", "11", "12", "13"})
    write(std::string("step-") + island + ".fc3d", "older");
  const Outcome outcome = call("dump box_headings --at 0 --out " + file("step.fc3d"));
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(lines(outcome.err), 1) << outcome.err;
  EXPECT_NE(outcome.err.find(file("step-12.fc3d") + " to " + file("step-13.fc3d")),
            std::string::npos)
      << outcome.err;
  EXPECT_NE(read(file("step-11.fc3d")), "older");
  EXPECT_EQ(read(file("step-12.fc3d")), "older");
}

// In a wide cone the published measures hardly show that a contact approaches.
TEST_F(ProblemFiles, NothingApproachesWhereItIsSolved) {
  for (const char* mu : {"1e3", "1e8", "1e101", "1e140", "1e300"}) {
    std::string text = read(easyProblem());
    text.replace(text.find("0.5"), 3, mu);
    const Outcome outcome =
        call("solve " + write("wide.fc3d", text) + " --json --solution " + file("wide.sol"));
    const json solved = json::parse(outcome.out);
    EXPECT_EQ(outcome.status, solved["status"] == "solved" ? 0 : 3) << mu;
    if (solved["status"] != "solved") continue;
    // The contact sticks: r = −q.
    EXPECT_NE(read(file("wide.sol")).find("\n1 -0.1 "), std::string::npos)
        << mu << read(file("wide.sol"));
  }
}

// No reaction is an answer by the published measures, if not by the law.
TEST_F(ProblemFiles, AContactThatApproachesIsNotSolved) {
  const std::string problem =
      write("steep.fc3d",
            "delassus-problem v1\nname steep\ncontacts 1\nblocks 1\nmu\n33722426538.861431\nq\n"
            "-0.013011549919581672 -0.10291165236798777 0.12703675542250514\nW\n0 0 "
            "3.7799439831603694 1.7871619075166614 -0.33642749722869553 "
            "1.7871619075166614 0.85535067580058211 -0.17356254580427519 "
            "-0.33642749722869553 -0.17356254580427519 0.05023352235098906\nend\n");
  const Outcome outcome = call("solve " + problem + " --json");
  const json solved = json::parse(outcome.out);
  EXPECT_LE(solved["rel"].get<double>(), 1e-8);
  EXPECT_LE(solved["vel"].get<double>(), 1e-8);
  EXPECT_EQ(solved["status"], "out_of_budget");
  EXPECT_EQ(outcome.status, 3);
}

// Names are bytes, but JSON is UTF-8.
TEST_F(ProblemFiles, TellsAnyNameInJson) {
  const std::string problem = easyProblem();
  std::string text = read(problem);
  text.replace(text.find("easy"), 4, "e\xe4sy");
  const Outcome outcome = call("solve " + write("odd.fc3d", text) + " --json");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(json::parse(outcome.out)["name"], "e\xef\xbf\xbdsy");
}

TEST_F(ProblemFiles, EndsWithThreeAboveTheTolerance) {
  // u = −1 whatever r is, so there is no solution.
  const std::string hopeless =
      write("hopeless.lcp", "lcp v1\nname hopeless\nsize 1\nentries 1\nq\n-1\nM\n0 0 0\nend\n");
  const Outcome outcome = call("solve " + hopeless + " --json");
  EXPECT_EQ(outcome.status, 3) << outcome.err;
  EXPECT_NE(json::parse(outcome.out)["status"], "solved");
}

TEST_F(ProblemFiles, NamesAProblemThatCannotBeRead) {
  const std::string good = read(easyProblem());
  std::string twoContacts = good;
  twoContacts.replace(twoContacts.find("contacts 1"), 10, "contacts 2");
  for (const std::string& path :
       {write("truncated.fc3d", good.substr(0, 60)), write("empty.fc3d", ""), folder_.string(),
        file("missing.lcp"), write("one_contact_of_two.fc3d", twoContacts),
        write("rows.lcp", "lcp v1\nname x\nsize 2\nentries 9\nq\n0 0\n"),
        write("nan.fc3d", "delassus-problem v1\nname x\ncontacts 1\nblocks 1\nmu\nnan\n")}) {
    const Outcome outcome = call("solve " + path);
    EXPECT_EQ(outcome.status, 1) << path;
    EXPECT_NE(outcome.err.find(path), std::string::npos) << outcome.err;
    EXPECT_EQ(lines(outcome.err), 1) << outcome.err;
  }
}

TEST_F(ProblemFiles, DumpsWhatItCanSolve) {
  const Outcome dumped = call("dump stack_10 --at 0.1 --out " + file("stack.fc3d"));
  ASSERT_EQ(dumped.status, 0) << dumped.err;
  const Outcome solved = call("solve " + file("stack.fc3d") + " --json");
  EXPECT_EQ(solved.status, 0) << solved.out << solved.err;
  EXPECT_EQ(json::parse(solved.out)["size"], 40);
}

// If the file is standard output, or a pipe that is, it holds what any other file would. Messages
// about it go elsewhere.
TEST_F(ProblemFiles, WritesToStandardOutputAsToAFile) {
  const std::string problem = easyProblem();
  for (const auto& [command, flag] :
       {std::pair<std::string, std::string>("dump one_box --at 0", " --out "),
        {"solve " + problem, " --solution "},
        {"solve --json " + problem, " --solution "}}) {
    const Outcome plain = call(command + flag + file("plain"));
    ASSERT_EQ(plain.status, 0) << plain.err;
    const Outcome direct = call(command + flag + "/dev/stdout", "timeout 20");
    EXPECT_EQ(direct.status, 0) << direct.err;
    EXPECT_EQ(direct.out, read(file("plain"))) << command;
    EXPECT_EQ(lines(direct.err), lines(plain.out)) << direct.err;

    const std::string line = std::string("timeout 20 ") + DELASSUS_COMMAND + " " + command + flag +
                             "/dev/stdout 2>" + file("said") + " | cat >" + file("piped");
    ASSERT_EQ(std::system(line.c_str()), 0);
    EXPECT_EQ(read(file("piped")), read(file("plain"))) << command;
  }
  const Outcome many = call("dump box_headings --at 0 --out /dev/stdout");
  EXPECT_EQ(many.status, 2);
  EXPECT_EQ(many.out, "");
  EXPECT_EQ(lines(many.err), 1) << many.err;
}

TEST_F(ProblemFiles, DumpsContactsWithJointsAsContacts) {
  const Outcome dumped = call("dump gripper --at 1 --out " + file("gripper.fc3d"));
  ASSERT_EQ(dumped.status, 0) << dumped.err;
  EXPECT_NE(dumped.out.find(" equations put in"), std::string::npos) << dumped.out;
  EXPECT_EQ(dumped.err, "");
  const Outcome solved = call("solve " + file("gripper.fc3d") + " --json");
  EXPECT_EQ(solved.status, 0) << solved.out << solved.err;
}

TEST_F(ProblemFiles, DumpsAnIslandAFile) {
  const Outcome dumped = call("dump box_headings --at 0 --out " + file("box.fc3d"));
  ASSERT_EQ(dumped.status, 0) << dumped.err;
  for (int i = 0; i < 12; ++i)
    EXPECT_TRUE(std::filesystem::exists(file("box-" + std::to_string(i) + ".fc3d"))) << i;
  const Outcome free = call("dump bead_under_plane --at 0.9 --out " + file("none"));
  EXPECT_EQ(free.status, 1);
  EXPECT_NE(free.err.find("nothing touches"), std::string::npos) << free.err;
  const Outcome rolling = call("dump rolling_balls --at 0 --out " + file("ball.fc3d"));
  EXPECT_EQ(rolling.status, 1);
  EXPECT_NE(rolling.err.find("island 4 has rolling or spinning friction"), std::string::npos);
}

// The name in a problem is one word; the name of a file need not be.
TEST_F(ProblemFiles, DumpsFilesOfAnyName) {
  const std::filesystem::path world = delassus::test::sharedFolder() / "worlds" / "spider.bullet";
  if (!std::filesystem::exists(world)) GTEST_SKIP() << delassus::test::noSharedFolder;
  std::filesystem::copy_file(world, file("my\tblack spider.bullet"));
  const Outcome dumped =
      call("dump '" + file("my\tblack spider.bullet") + "' --at 0 --out " + file("spider.fc3d"));
  ASSERT_EQ(dumped.status, 0) << dumped.err;
  EXPECT_EQ(dumped.err, "");
  const Outcome solved = call("solve " + file("spider-1.fc3d") + " --json");
  ASSERT_EQ(solved.status, 0) << solved.err;
  EXPECT_EQ(json::parse(solved.out)["name"], "my_black_spider-0-1");
}

}  // namespace
