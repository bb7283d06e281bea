// The command as its users meet it: exit status, messages, JSON.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cerrno>
#include <cstring>
#include <nlohmann/json.hpp>

#include "demos/progress_bar.h"
#include "tests/command_call.h"
#include "tests/support/shared_data.h"

namespace {

using nlohmann::json;

using delassus::test::lines;
using delassus::test::Outcome;
using delassus::test::read;

class Command : public delassus::test::CommandCall {};

TEST_F(Command, HelpsEverywhere) {
  for (const char* sub : {"", "scenes", "run", "render", "report", "solve", "dump", "atlas"}) {
    const Outcome outcome = call(std::string(sub) + " --help");
    EXPECT_EQ(outcome.status, 0) << sub;
    EXPECT_GT(outcome.out.size(), 80U) << sub;
  }
}

TEST_F(Command, RefusesBadUsageWithTwo) {
  for (const char* bad :
       {"", "fly", "run", "run --no-such-flag", "run one_box --hz 0", "run one_box --seconds -1",
        "run one_box --seconds nan", "run one_box --hz many", "solve", "dump one_box --at 1",
        "scenes extra"}) {
    const Outcome outcome = call(bad);
    EXPECT_EQ(outcome.status, 2) << bad;
    EXPECT_FALSE(outcome.err.empty()) << bad;
  }
}

TEST_F(Command, NamesTheCommandThatIsUnknownAndThoseThatExist) {
  for (const std::string arguments : {"fly one_box", ""}) {
    const Outcome outcome = call(arguments);
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(lines(outcome.err), 1) << outcome.err;
    for (const char* word : {arguments.empty() ? "required" : "'fly'", "scenes", "run", "render",
                             "report", "solve", "dump", "atlas"})
      EXPECT_NE(outcome.err.find(word), std::string::npos) << word << '\n' << outcome.err;
  }
}

TEST_F(Command, NamesTheOptionThatIsUnknownAndThoseThatExist) {
  for (const char* arguments :
       {"run --no-such-flag", "run one_box --no-such-flag",
        "run one_box --seconds 1 --no-such-flag", "run --no-such-flag si:10 one_box --json"}) {
    const Outcome outcome = call(arguments);
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(
        outcome.err,
        "delassus: run has no option '--no-such-flag'; there are --help, --solver, --seconds, "
        "--hz, --threads, --no-geometric-stiffness, --explain, --json\n")
        << arguments;
  }
  for (const char* sub : {"scenes", "render", "report", "solve", "dump", "atlas"}) {
    const Outcome outcome = call(std::string(sub) + " --no-such-flag");
    EXPECT_EQ(outcome.status, 2);
    EXPECT_NE(outcome.err.find("'--no-such-flag'; there are --help"), std::string::npos)
        << outcome.err;
  }
  // Numbers may be negative, and surplus words are not options.
  EXPECT_EQ(call("run one_box --seconds -1").err.find("no option"), std::string::npos);
  EXPECT_EQ(call("scenes extra").err.find("no option"), std::string::npos);
}

TEST_F(Command, LostOutputIsAFailure) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  for (const char* arguments : {"run one_box --seconds 0.1", "scenes", "run --help"}) {
    const std::string line =
        std::string(DELASSUS_COMMAND) + " " + arguments + " >/dev/full 2>" + file("said");
    const int answer = std::system(line.c_str());
    ASSERT_TRUE(WIFEXITED(answer));
    EXPECT_EQ(WEXITSTATUS(answer), 1) << arguments;
    EXPECT_EQ(lines(read(file("said"))), 1) << read(file("said"));
  }
}

TEST_F(Command, RefusesRunsWithoutEnd) {
  for (const std::string& endless : {std::string("run one_box --seconds 1e30"),
                                     std::string("run one_box --hz 1e16 --seconds 1e-15"),
                                     "dump one_box --at 1e30 --out " + file("a.fc3d")}) {
    const Outcome outcome = call(endless);
    EXPECT_EQ(outcome.status, 1) << endless;
    EXPECT_EQ(lines(outcome.err), 1) << outcome.err;
  }
}

TEST_F(Command, NamesTheNearestScene) {
  const Outcome outcome = call("run one_bx");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.err.find("one_box"), std::string::npos);
  EXPECT_EQ(lines(outcome.err), 1);
}

TEST_F(Command, NamesTheSolversThatExist) {
  const Outcome outcome = call("run one_box --solver delassus,sj:10");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.err.find("sj:10"), std::string::npos);
  EXPECT_NE(outcome.err.find("si:N"), std::string::npos);
  EXPECT_EQ(lines(outcome.err), 1);
}

// A name that was lost on the way, for example as an empty variable.
TEST_F(Command, RefusesSolversWithoutName) {
  for (const char* list : {"si:10,,delassus", "si:10,", ",si:10", "''"})
    for (const char* command : {"run one_box --solver ", "render one_box --solver "}) {
      const Outcome outcome = call(std::string(command) + list);
      EXPECT_EQ(outcome.status, 2) << command << list;
      EXPECT_NE(outcome.err.find("a solver's name is empty"), std::string::npos) << outcome.err;
      EXPECT_EQ(lines(outcome.err), 1) << outcome.err;
      EXPECT_EQ(outcome.out, "");
    }
}

TEST_F(Command, NamesAFileThatCannotBeRead) {
  for (const std::string& path :
       {file("no/such.bullet"), folder_.string() + "/", write("bad.bullet", "nonsense")}) {
    const Outcome outcome = call("run " + path);
    EXPECT_EQ(outcome.status, 1) << path;
    EXPECT_NE(outcome.err.find(path), std::string::npos) << outcome.err;
    EXPECT_EQ(lines(outcome.err), 1) << outcome.err;
  }
}

// A file that cannot be opened is not called damaged.
TEST_F(Command, SaysWhyAWorldCannotBeOpened) {
  std::filesystem::create_symlink("loop.bullet", file("loop.bullet"));
  const std::string tooLong = folder_.string() + "/" + std::string(300, 'a');
  for (const auto& [path, why] :
       {std::pair(file("loop.bullet"), ELOOP), std::pair(tooLong, ENAMETOOLONG),
        std::pair(file("none.bullet"), ENOENT)})
    for (const char* command : {"run ", "dump --at 0 --out none "}) {
      const Outcome outcome = call(command + path);
      EXPECT_EQ(outcome.status, 1) << path;
      EXPECT_EQ(outcome.err,
                "delassus: " + path + ": cannot be opened: " + std::strerror(why) + "\n");
    }
}

// The command would wait for a pipe without end.
TEST_F(Command, RefusesWhatIsNoRegularFile) {
  ASSERT_EQ(mkfifo(file("pipe.bullet").c_str(), 0600), 0);
  const Outcome outcome = call("run " + file("pipe.bullet"), "timeout 20");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.err.find(file("pipe.bullet") + ": is not a regular file"), std::string::npos)
      << outcome.err;
}

TEST_F(Command, NamesWhatItDoesNotUnderstand) {
  const auto fault = [this](const std::string& arguments) {
    const Outcome outcome = call(arguments);
    EXPECT_EQ(outcome.status, 2) << arguments;
    return outcome.err;
  };
  EXPECT_NE(fault("--foo").find("'--foo'"), std::string::npos);
  EXPECT_NE(fault("foo").find("'foo'"), std::string::npos);
  EXPECT_NE(fault("render one_box --out ''").find("--out"), std::string::npos);
  EXPECT_NE(fault("render one_box --plain --timing").find("--plain"), std::string::npos);
  EXPECT_EQ(call("--version").status, 0);
  // A world whose name does not look like a file.
  write("world", "no world");
  const Outcome outcome = call("run world", "cd '" + file("") + "'; ");
  EXPECT_NE(outcome.err.find("./world"), std::string::npos) << outcome.err;
}

TEST_F(Command, TellsWhichOptionsChangeNothing) {
  const std::string options =
      "run one_box --seconds 0.1 --threads 2 --no-geometric-stiffness --explain --solver ";
  const Outcome stock = call(options + "si:10,dantzig");
  EXPECT_EQ(stock.status, 0);
  EXPECT_EQ(lines(stock.err), 3) << stock.err;
  for (const char* option : {"--threads", "--no-geometric-stiffness", "--explain"})
    EXPECT_NE(stock.err.find(option), std::string::npos) << option;
  EXPECT_EQ(call(options + "si:10,delassus").err, "");
}

TEST_F(Command, ExplainsWhatAStepIsMadeOf) {
  const Outcome words = call("run one_box --solver delassus,si:10 --seconds 0.5 --explain");
  ASSERT_EQ(words.status, 0) << words.err;
  for (const char* line :
       {"contacts with friction     4 ", "no push problem", "no events", "gather"})
    EXPECT_NE(words.out.find(line), std::string::npos) << line << '\n' << words.out;

  const Outcome outcome =
      call("run one_box --solver delassus,si:10 --seconds 0.5 --explain --json");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  std::istringstream out(outcome.out);
  std::string line;
  ASSERT_TRUE(std::getline(out, line));
  const json explained = json::parse(line).at("explain");
  EXPECT_EQ(explained["asked_for"]["frictional"], 4);
  EXPECT_EQ(explained["asked_for"]["frictionless"], 0);
  EXPECT_EQ(explained["asked_for"]["unknowns"], 12);
  EXPECT_EQ(explained["asked_for"]["islands"], 1);
  EXPECT_EQ(explained["asked_for"]["listeners"], 0);
  EXPECT_EQ(explained["push_islands"], 0);
  EXPECT_EQ(explained["events"], 0);
  for (const char* key :
       {"stiffened", "opposed", "held", "sweeps", "patches", "softened", "push_softened"})
    EXPECT_EQ(explained.value(key, -1.0), 0) << key;
  // The first step is solved; from then on the box stands.
  EXPECT_GT(explained["matrices"], 0);
  EXPECT_LT(explained["matrices"], 0.2);
  EXPECT_GT(explained["islands"]["kept"], 0.8);
  double islands = 0;
  for (const auto& [tier, count] : explained["islands"].items()) islands += double(count);
  EXPECT_NEAR(islands, 1, 1e-12);
  EXPECT_GT(explained["microseconds"]["gather"], 0);
  EXPECT_EQ(explained["microseconds"]["push"], 0);
  // Two unknowns more for each ball that resists rolling.
  const json rolling =
      json::parse(call("run rolling_balls --seconds 0.02 --explain --json").out).at("explain");
  EXPECT_EQ(rolling["asked_for"]["rolling"], 5);
  EXPECT_EQ(rolling["asked_for"]["spinning"], 0);
  EXPECT_EQ(rolling["asked_for"]["unknowns"], 25);
  // Bullet's own solvers report nothing of the kind.
  ASSERT_TRUE(std::getline(out, line));
  EXPECT_FALSE(json::parse(line).contains("explain"));
}

// Links of 0.1 kg under 100 kg turn faster than a step of 1/60 s can follow.
TEST_F(Command, TellsHowManyBodiesAreStiffened) {
  const std::string arguments = "run heavy_ball_chain --hz 60 --seconds 0.3 --explain";
  const json run = json::parse(call(arguments + " --json").out);
  const int most = run.at("stiffened");
  EXPECT_GT(most, 10);
  EXPECT_LE(most, run.at("bodies"));
  const double mean = run.at("explain").at("stiffened");
  EXPECT_GT(mean, 0.5 * most);
  EXPECT_LE(mean, most);
  EXPECT_NE(call(arguments).out.find("; " + std::to_string(most) + " bodies stiffened in a step"),
            std::string::npos);

  const std::string off = arguments + " --no-geometric-stiffness";
  EXPECT_EQ(json::parse(call(off + " --json").out).at("stiffened"), 0);
  EXPECT_EQ(call(off).out.find("stiffened"), std::string::npos);
  EXPECT_FALSE(
      json::parse(call("run one_box --seconds 0.1 --solver si:10 --json").out).count("stiffened"));
}

TEST_F(Command, RunsAndTellsInJson) {
  const Outcome outcome = call("run one_box --solver delassus,si:10 --seconds 0.5 --json");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  std::istringstream out(outcome.out);
  for (const char* solver : {"delassus", "si:10"}) {
    std::string line;
    ASSERT_TRUE(std::getline(out, line));
    const json run = json::parse(line);
    for (const char* key : {"scene",
                            "solver",
                            "precision",
                            "steps",
                            "hz",
                            "bodies",
                            "contacts_max",
                            "ms_first",
                            "ms_mean",
                            "ms_median",
                            "ms_p95",
                            "residual_rms",
                            "residual_max",
                            "penetration_max_m",
                            "kinetic_energy_j",
                            "drift_max_m",
                            "joint_error_max_m",
                            "reaction_over_weight",
                            "modes",
                            "regions_per_step",
                            "factorisations_per_step",
                            "statuses",
                            "fallbacks"})
      EXPECT_TRUE(run.contains(key)) << key;
    EXPECT_EQ(run["scene"], "one_box");
    EXPECT_EQ(run["solver"], solver);
    EXPECT_EQ(run["steps"], 30);
    EXPECT_EQ(run["contacts_max"], 4);
    EXPECT_NEAR(run["reaction_over_weight"].get<double>(), 1, 0.05);
    if (run["solver"] == "delassus") {
      EXPECT_EQ(run["left_out"], 0);
      EXPECT_TRUE(run["messages"].empty());
      EXPECT_EQ(run["statuses"]["non_finite"], 0);
    }
  }
}

TEST_F(Command, RunsOnSeveralThreadsToTheSameEnd) {
  const auto summary = [&](const std::string& threads) {
    const Outcome run = call("run ragdolls --seconds 0.5 --json --threads " + threads);
    EXPECT_EQ(run.status, 0) << run.err;
    json told = json::parse(run.out);
    for (const char* time : {"ms_first", "ms_mean", "ms_median", "ms_p95"}) told.erase(time);
    return told;
  };
  EXPECT_EQ(summary("2"), summary("1"));
  EXPECT_EQ(call("run one_box --threads 0").status, 2);
}

TEST_F(Command, TellsHowFarASceneIsFromItsLaw) {
  const Outcome outcome = call("run force_plate --solver delassus,si:10 --json");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  std::istringstream runs(outcome.out);
  std::string ours, stock;
  std::getline(runs, ours);
  std::getline(runs, stock);
  EXPECT_LT(json::parse(ours)["law_error"].get<double>(), 1e-6);
  EXPECT_GT(json::parse(stock)["law_error"].get<double>(), 0.01);

  const Outcome table = call("run force_plate --seconds 0.1");
  EXPECT_NE(table.out.find("force and moments under the feet against statics"), std::string::npos);
  const Outcome lawless = call("run one_box --seconds 0.1 --json");
  EXPECT_EQ(json::parse(lawless.out).count("law_error"), 0U);
}

// NNCG loses the ragdolls at once. The rest of such a world moves no more and touches nothing.
TEST_F(Command, CallsALostWorldLost) {
  const std::string arguments = "run ragdolls --solver nncg:1000,delassus --seconds 0.1";
  const Outcome outcome = call(arguments + " --json");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  std::istringstream out(outcome.out);
  for (const bool lost : {true, false}) {
    std::string line;
    ASSERT_TRUE(std::getline(out, line));
    const json run = json::parse(line);
    EXPECT_EQ(run["finite"], !lost);
    EXPECT_EQ(run["steps_lost"] > 0, lost);
    EXPECT_EQ(run["steps_above_1e-6"], run["steps_lost"]);
    for (const char* key : {"residual_max", "residual_rms", "drift_max_m", "joint_error_max_m"})
      EXPECT_EQ(run[key].is_null(), lost) << key;
  }
  const Outcome table = call(arguments);
  EXPECT_NE(table.out.find("nncg:1000: the world is lost: "), std::string::npos) << table.out;
  EXPECT_EQ(table.out.find("delassus: the world is lost"), std::string::npos) << table.out;
}

TEST_F(Command, ComparesSolversInOneTable) {
  const Outcome outcome = call("run one_box --solver delassus,si:10 --seconds 0.2");
  EXPECT_EQ(outcome.status, 0);
  EXPECT_NE(outcome.out.find("\ndelassus "), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("\nsi:10 "), std::string::npos) << outcome.out;
  EXPECT_TRUE(outcome.err.empty()) << "no progress bar to a file";
}

TEST_F(Command, ListsScenes) {
  const Outcome outcome = call("scenes");
  EXPECT_EQ(outcome.status, 0);
  for (const char* scene : {"bead_in_angle", "stack_10_heavy_top", "arch_thin", "gripper"})
    EXPECT_NE(outcome.out.find(scene), std::string::npos) << scene;
}

TEST(ProgressLine, FitsIntoItsTerminal) {
  using demos::progressLine;
  EXPECT_EQ(progressLine("one_box si:10", 0.5, 200),
            "one_box si:10 [" + std::string(20, '#') + std::string(20, ' ') + "]  50 %");
  const std::string name = "12/480 own_trajectory stack_10_heavy_top \u00b5";
  for (std::size_t columns = 1; columns < 120; ++columns)
    for (const double fraction : {0.0, 0.37, 1.0}) {
      const std::string line = progressLine(name, fraction, columns);
      EXPECT_LT(line.size(), columns + (columns == 0)) << columns;
      EXPECT_TRUE(columns < 20 || line.find(" %") != std::string::npos) << columns << line;
    }
  // Letters of several bytes stay whole.
  EXPECT_EQ(progressLine("\u00b5\u00b5\u00b5", 0, 4), "\u00b5");
}

}  // namespace
