// The report as its readers meet it, on two small scenes and two solvers.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <vector>

#include "tests/command_call.h"

namespace {

namespace fs = std::filesystem;

using delassus::test::lines;
using delassus::test::Outcome;
using delassus::test::read;

/// The rows of a CSV file without quotes, each with the names of its columns.
std::vector<std::map<std::string, std::string>> rowsOf(const fs::path& path) {
  std::ifstream file(path);
  std::vector<std::string> heading;
  std::vector<std::map<std::string, std::string>> rows;
  for (std::string line; std::getline(file, line);) {
    std::vector<std::string> words;
    std::istringstream text(line);
    for (std::string word; std::getline(text, word, ',');) words.push_back(word);
    if (heading.empty()) {
      heading = words;
      continue;
    }
    rows.emplace_back();
    for (std::size_t i = 0; i < words.size(); ++i) rows.back()[heading[i]] = words[i];
  }
  return rows;
}

class Report : public delassus::test::CommandCall {
 protected:
  fs::path out() const { return folder_ / "report"; }

  /// `delassus report` on the small scenes. Returns the exit status.
  int report(const std::string& flags, const std::string& before = "") {
    const auto outcome =
        call("report --quick --solvers delassus:1e-8,si:10 --out " + out().string() + " " + flags,
             before);
    said_ = outcome.out + outcome.err;
    return outcome.status;
  }
  /// The output of the last report on both streams.
  const std::string& said() const { return said_; }

 private:
  std::string said_;
};

TEST_F(Report, JudgesTheSameProblemBySolvers) {
  ASSERT_EQ(report("--scenes stack_10 --parts same_problem,persisting"), 0) << said();
  const auto rows = rowsOf(out() / "same_problem" / "stack_10.csv");
  ASSERT_FALSE(rows.empty());
  for (auto row : rows) {
    EXPECT_EQ(row["ending"], "done");
    EXPECT_LT(std::stod(row["certificate_residual"]), 1e-9);
    EXPECT_LT(std::stod(row["certificate_agreement"]), 1e-6);
    EXPECT_GT(std::stod(row["seconds"]), 0);
    // The errors that the tolerances promise, and the error that ten sweeps leave in a stack from
    // cold.
    if (row["method"] == "delassus:1e-8") {
      EXPECT_LT(std::stod(row["error"]), 1e-5) << row["phase"];
    } else if (row["view"] == "cold") {
      EXPECT_GT(std::stod(row["error"]), 1e-2) << row["phase"];
    }
  }
  const std::string page = read(out() / "report.md");
  // The command as it was called. The note for --resume is the same wherever the folder lies.
  const std::string command =
      "report --quick --scenes stack_10 --solvers delassus:1e-8,si:10 "
      "--parts same_problem,persisting --out ";
  EXPECT_NE(page.find("\n    " DELASSUS_COMMAND " " + command + out().string() + "\n"),
            std::string::npos)
      << page.substr(0, 500);
  EXPECT_EQ(read(out() / "command.txt").rfind("delassus " + command + ".\n", 0), 0U);
  for (const char* words : {"Bullet", "Who reaches which error",
                            "Where `delassus` is not the fastest", "stack_10", "si:10"})
    EXPECT_NE(page.find(words), std::string::npos) << words;
}

// The samples come from a world that measures only watch. With one more method, the samples of the
// others stay the same to the last digit.
TEST_F(Report, MeasuresLeaveTheWorldAsItIs) {
  const auto rows = [&](const std::string& flags) {
    EXPECT_EQ(report("--scenes card_house --parts same_problem" + flags), 0) << said();
    std::map<std::string, std::map<std::string, std::string>> all;
    for (const auto& row : rowsOf(out() / "same_problem" / "card_house.csv"))
      all[row.at("phase") + ' ' + row.at("view") + ' ' + row.at("method")] = row;
    return all;
  };
  const auto few = rows(""), many = rows(" --solvers nncg:20");
  ASSERT_FALSE(few.empty());
  EXPECT_EQ(2 * many.size(), 3 * few.size());
  for (const auto& [sample, row] : few)
    for (const char* column :
         {"step", "contacts", "error", "residual_max", "wrong_modes", "certificate_residual"})
      EXPECT_EQ(many.at(sample).at(column), row.at(column)) << sample << ' ' << column;
}

TEST_F(Report, GoesOnWhereItWasInterrupted) {
  const std::string what = "--scenes one_box,stack_10 --parts own_trajectory";
  ASSERT_EQ(report(what), 0) << said();
  const fs::path kept = out() / "own_trajectory" / "one_box.csv",
                 lost = out() / "own_trajectory" / "stack_10.csv";
  const std::string before = read(kept);
  fs::remove(lost);
  ASSERT_EQ(report(what + " --resume"), 0) << said();
  EXPECT_EQ(read(kept), before);  // times differ from run to run: it was not measured again
  EXPECT_TRUE(fs::exists(lost));
}

TEST_F(Report, DoesNotMixTwoReports) {
  const std::string what = "--scenes one_box --parts own_trajectory";
  ASSERT_EQ(report(what), 0) << said();
  EXPECT_EQ(report("--scenes one_box,incline --parts own_trajectory --resume"), 1);
  EXPECT_NE(said().find("--scenes one_box"), std::string::npos) << said();

  // Nor reports of two precisions.
  std::string stamp = read(out() / "command.txt");
  ASSERT_NE(stamp.find("double"), std::string::npos) << stamp;
  stamp.replace(stamp.find("double"), 6, "float");
  write("report/command.txt", stamp);
  EXPECT_EQ(report(what + " --resume"), 1);
  EXPECT_NE(said().find("in float precision"), std::string::npos) << said();
}

// Whoever left old measures there, and whether or not a command is noted beside them.
TEST_F(Report, TakesNoOldMeasuresForNewOnes) {
  const std::string what = "--scenes one_box --parts own_trajectory";
  for (const char* leftThere : {"own_trajectory/one_box.csv", "own_trajectory/one_box.svg"}) {
    fs::create_directories(out() / "own_trajectory");
    write(std::string("report/") + leftThere, "method,family\nold,old\n");
  }
  ASSERT_EQ(report(what, "PATH=/nowhere"), 0) << said();
  EXPECT_EQ(rowsOf(out() / "own_trajectory" / "one_box.csv").size(), 2U);
  EXPECT_FALSE(fs::exists(out() / "own_trajectory" / "one_box.svg")) << "nobody could draw it";
}

TEST_F(Report, LeavesOtherPeoplesFilesAlone) {
  const std::string what = "--scenes one_box --parts own_trajectory";
  fs::create_directories(out() / "own_trajectory");
  write("report/own_trajectory/notes.txt", "mine");
  ASSERT_EQ(report(what), 0) << said();
  ASSERT_EQ(report(what), 0) << said();
  EXPECT_EQ(read(out() / "own_trajectory" / "notes.txt"), "mine");

  write("report/command.txt", "make coffee\n");
  EXPECT_EQ(report(what), 1);
  EXPECT_NE(said().find("command.txt' is not of a report"), std::string::npos) << said();
  EXPECT_EQ(read(out() / "command.txt"), "make coffee\n");
  EXPECT_TRUE(fs::exists(out() / "own_trajectory" / "one_box.csv"));
}

TEST_F(Report, SaysWhatToDoWhereNoFolderCanBe) {
  write("plain", "mine");
  for (const std::string where : {"plain", "plain/in"})
    for (const char* which : {"--parts time_step", "--stability --one-precision --parts angles"}) {
      const Outcome outcome =
          call(std::string("report --quick ") + which + " --out " + file(where));
      EXPECT_EQ(outcome.status, 1);
      EXPECT_EQ(outcome.err.rfind("delassus: cannot make the folder '" + file(where), 0), 0U)
          << outcome.err;
      EXPECT_NE(outcome.err.find("name another folder by --out"), std::string::npos) << outcome.err;
      EXPECT_EQ(lines(outcome.err), 1) << outcome.err;
    }
  EXPECT_EQ(read(file("plain")), "mine");

  fs::create_directories(out());
  write("report/time_step", "mine");
  EXPECT_EQ(report("--parts time_step"), 1);
  EXPECT_NE(said().find("cannot make the folder '" + (out() / "time_step").string()),
            std::string::npos)
      << said();
  // A folder in the way of a measure is not removed with its contents.
  fs::create_directories(out() / "ablation" / "one_box.csv" / "in the way");
  EXPECT_EQ(report("--scenes one_box --parts ablation"), 1);
  EXPECT_NE(said().find("cannot remove '"), std::string::npos) << said();
  EXPECT_EQ(lines(said()), 2) << said();  // the other one says that --solvers is idle
}

// NNCG throws the ragdolls out of the numbers at once.
TEST_F(Report, CallsALostWorldLost) {
  ASSERT_EQ(report("--scenes ragdolls --solvers nncg:1000 --parts own_trajectory"), 0) << said();
  for (auto row : rowsOf(out() / "own_trajectory" / "ragdolls.csv"))
    EXPECT_EQ(row["drift"] == "nan", row["method"] == "nncg:1000") << row["method"];
  EXPECT_NE(read(out() / "report.md").find("lost: not a number"), std::string::npos);
}

TEST_F(Report, WhatPersistsIsMeasuredToo) {
  ASSERT_EQ(report("--scenes one_box --parts persisting"), 0) << said();
  EXPECT_NE(read(out() / "report.md").find("Which contacts persist"), std::string::npos);
}

TEST_F(Report, TellsWhatItLacks) {
  EXPECT_EQ(report("--scenes one_bx"), 1);
  EXPECT_NE(said().find("one_box"), std::string::npos);
  EXPECT_EQ(report("--parts nonsense"), 2);
  EXPECT_NE(said().find("own_trajectory"), std::string::npos);
  EXPECT_FALSE(fs::exists(out()));

  ASSERT_EQ(report("--scenes one_box --parts own_trajectory", "PATH=/nowhere"), 0) << said();
  EXPECT_NE(said().find("gnuplot is missing"), std::string::npos) << said();
  EXPECT_NE(read(out() / "report.md").find("gnuplot is missing"), std::string::npos);
}

TEST_F(Report, FindsTheOrderOfTheIntegrator) {
  ASSERT_EQ(report("--parts time_step"), 0) << said();
  for (const char* scene : {"ball_off_ball", "sliding_ladder", "incline"}) {
    std::map<double, double> errors;
    for (auto row : rowsOf(out() / "time_step" / (std::string(scene) + ".csv")))
      if (row["method"] == "delassus:1e-8")
        errors[std::stod(row["rate"])] = std::stod(row["error"]);
    ASSERT_EQ(errors.size(), 5U) << scene;
    // First order: half the step, half the error. At some rates Bullet loses points of a sliding
    // box, which adds to the error.
    std::vector<double> perStep;
    for (const auto& [rate, error] : errors) perStep.push_back(rate * error);
    std::sort(perStep.begin(), perStep.end());
    EXPECT_NEAR(perStep[1] / perStep[0], 1, 0.05) << scene;
    if (std::string(scene) != "incline") {
      EXPECT_NEAR(errors[240] / errors[480], 2, 0.1) << scene;
    }
  }
}

// Wedges down to the angle where rounding ends them: both precisions, stock beside ours.
TEST_F(Report, MapsWhatHoldsUpToWhere) {
  ASSERT_EQ(report("--stability --parts angles,wedge_pair"), 0) << said();
  const auto rows = rowsOf(out() / "stability" / "double" / "angles" / "opposite.csv");
  ASSERT_FALSE(rows.empty());
  for (auto row : rows) {
    const double angle = std::stod(row["value"]);
    if (row["method"] == "delassus:1e-8" && angle > 1e-5) {
      EXPECT_EQ(row["verdict"], "holds") << angle;
      EXPECT_LT(std::stod(row["worst_error"]), std::stod(row["allowed"])) << angle;
      // Compared with the answer in extended precision: 1/angle of the residual's digits are lost.
      EXPECT_EQ(row["first_certified"], "1") << angle;
      EXPECT_LT(std::stod(row["first_error"]), 1e-9 / angle) << angle;
      EXPECT_LT(std::stod(row["last_error"]), 1e-7 / angle) << angle;
    } else if (row["method"] == "si:10" && angle < 1e-2) {
      EXPECT_EQ(row["verdict"], "fails") << angle;
      EXPECT_GT(std::stod(row["first_error"]), 0.5) << angle;
    }
  }
  const std::string page = read(out() / "stability.md");
  for (const char* words : {"delassus report --stability --quick", "At a glance",
                            "half angle of the wedge", "delassus:1e-8", "si:10",
                            // the second thing and its rows
                            "| friction |", "| μ = 0.3 |"})
    EXPECT_NE(page.find(words), std::string::npos) << words;
  EXPECT_TRUE(fs::exists(out() / "stability" / "wedge_pair.svg"));
}

TEST_F(Report, MapGoesOnWhereItWasInterrupted) {
  const std::string what = "--stability --one-precision --parts angles";
  ASSERT_EQ(report(what), 0) << said();
  const fs::path folder = out() / "stability" / "double" / "angles";
  const std::string kept = read(folder / "opposite.csv");
  fs::remove(folder / "parallel.csv");
  ASSERT_EQ(report(what + " --resume"), 0) << said();
  EXPECT_EQ(read(folder / "opposite.csv"), kept);
  EXPECT_TRUE(fs::exists(folder / "parallel.csv"));
  EXPECT_NE(said().find("/stability/double\n"), std::string::npos) << said();
  EXPECT_FALSE(fs::exists(out() / "stability.md")) << "that is the business of both precisions";
  EXPECT_EQ(report("--stability --scenes one_box"), 2) << "the map has worlds of its own";
  EXPECT_EQ(report("--stability --parts nonsense"), 2);
  EXPECT_NE(said().find("long_runs"), std::string::npos) << said();
}

// Without one economy at a time there is more work, but the same motion. A part that is named twice
// is made once; options that a part does not use are reported.
TEST_F(Report, TellsWhatEachEconomyIsWorth) {
  ASSERT_EQ(report("--scenes stack_10,ball_off_ball --parts ablation,ablation"), 0) << said();
  EXPECT_NE(said().find("--solvers is for same_problem"), std::string::npos) << said();
  EXPECT_EQ(said().find("--scenes is for"), std::string::npos) << said();
  const std::string page = read(out() / "report.md"), heading = "## What is left out";
  EXPECT_NE(page.find(heading), std::string::npos);
  EXPECT_EQ(page.find(heading), page.rfind(heading));
  const auto rowsByName = [&](const char* scene) {
    std::map<std::string, std::map<std::string, std::string>> rows;
    for (const auto& row : rowsOf(out() / "ablation" / (std::string(scene) + ".csv")))
      rows[row.at("without")] = row;
    return rows;
  };
  for (const char* scene : {"stack_10", "ball_off_ball"}) {
    auto rows = rowsByName(scene);
    ASSERT_EQ(rows.size(), 12U) << scene;
    for (auto& [without, row] : rows) {
      EXPECT_LT(std::stod(row["difference"]), 1e-5) << scene << ' ' << without;
      EXPECT_GT(std::stod(row["busy_ratio"]), 0) << scene << ' ' << without;
    }
    EXPECT_EQ(std::stod(rows["nothing"]["events"]), 0);
    EXPECT_EQ(std::stod(rows["nothing"]["push_islands"]), 0);
    EXPECT_GT(std::stod(rows["pushes"]["push_islands"]), 0) << scene;
  }
  auto stack = rowsByName("stack_10"), ball = rowsByName("ball_off_ball");
  EXPECT_LT(std::stod(stack["nothing"]["matrices"]), 0.1);
  EXPECT_EQ(std::stod(stack["kept"]["matrices"]), 1);
  EXPECT_GT(std::stod(ball["nothing"]["unknowns"]), 0);
  EXPECT_NEAR(std::stod(ball["tangents"]["unknowns"]), 3 * std::stod(ball["nothing"]["unknowns"]),
              1e-6);
  for (const char* words : {"Calm steps", "stack_10", "one region"})
    EXPECT_NE(page.find(words), std::string::npos) << words;
}

}  // namespace
