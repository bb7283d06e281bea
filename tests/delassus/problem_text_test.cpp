#include "delassus/problem_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <locale>
#include <random>
#include <sstream>

#include "tests/support/problem_samples.h"
#include "tests/support/shared_data.h"

namespace delassus {
namespace {

using test::contactText;
using test::expectSame;
using test::fromText;
using test::rowText;
using test::toText;
using test::withLine;
using ::testing::HasSubstr;
using ::testing::StartsWith;

TEST(ProblemText, ReadsContacts) {
  const Problem problem = fromText(contactText);
  EXPECT_EQ(problem.name, "two");
  EXPECT_EQ(problem.contacts(), 2);
  EXPECT_EQ(problem.rows(), 0);
  EXPECT_EQ(problem.friction, Eigen::Vector2d(0.5, 0));
  EXPECT_EQ(problem.q, (Vec6() << -1, 0.25, -0.125, 1e-3, 0, 3).finished());
  MatrixXd W = MatrixXd::Identity(6, 6);
  W(0, 0) = 2;
  W(0, 1) = W(1, 0) = 0.5;
  W(5, 2) = 1e-300;
  EXPECT_EQ(problem.W.dense(), W);
  EXPECT_EQ(problem.W.entries().nonZeros(), 27) << "zeros inside blocks are stored";
}

TEST(ProblemText, ReadsRows) {
  const Problem problem = fromText(rowText);
  EXPECT_EQ(problem.contacts(), 0);
  EXPECT_EQ(problem.lower, Eigen::Vector2d(-infinity, -0.5));
  EXPECT_EQ(problem.upper, Eigen::Vector2d(infinity, 2));
  EXPECT_EQ(problem.q, Eigen::Vector2d(-1, 3));
  EXPECT_EQ(problem.W.dense(), (MatrixXd(2, 2) << 0, 0, -1, 4).finished());

  const Problem unilateral = fromText("lcp v1\nname n\nsize 1\nentries 1\nq\n-1\nM\n0 0 1\nend\n");
  EXPECT_EQ(unilateral.lower[0], 0);
  EXPECT_EQ(unilateral.upper[0], infinity);
}

TEST(ProblemText, NumbersMayHaveAPlusSign) {
  const Problem problem =
      fromText("lcp v1\nname x\nsize 1\nentries 1\nq\n+0.5\nM\n0 0 +1e+0\nend\n");
  EXPECT_EQ(problem.q[0], 0.5);
  EXPECT_EQ(problem.W.dense()(0, 0), 1);
}

TEST(ProblemText, LineBreaksCarryNoMeaningInListsAndEndingsDoNotMatter) {
  std::string oneLine = contactText;
  for (std::size_t i = oneLine.find("mu"); i < oneLine.size(); ++i)
    if (oneLine[i] == '\n') oneLine[i] = ' ';
  expectSame(fromText(contactText), fromText(oneLine));

  std::string windows;
  for (const char c : std::string(contactText)) windows += c == '\n' ? "\r\n" : std::string(1, c);
  expectSame(fromText(contactText), fromText(windows));

  const std::string commented = withLine(contactText, 9, "# between sections\n\n#too\nq");
  expectSame(fromText(contactText), fromText(commented));
}

TEST(ProblemText, RoundTripOfSharedProblems) {
  if (test::sharedFolder().empty()) GTEST_SKIP() << test::noSharedFolder;
  const auto files = test::sharedProblems();
  EXPECT_FALSE(files.empty());
  for (const auto& file : files) {
    SCOPED_TRACE(file.filename());
    const Problem problem = readProblem(file.string());
    EXPECT_EQ(problem.name, file.stem());
    EXPECT_EQ(problem.contacts() > 0, file.extension() == ".fc3d");
    const std::string text = toText(problem);
    const Problem again = fromText(text);
    expectSame(problem, again);
    EXPECT_EQ(text, toText(again));
  }
}

TEST(ProblemText, RoundTripOfAnyDouble) {
  std::mt19937_64 random(1920);
  VectorXd numbers(3000);
  for (double& x : numbers) {
    do {
      const std::uint64_t bits = random();
      std::memcpy(&x, &bits, sizeof x);
    } while (!std::isfinite(x));
  }
  numbers.head<6>() << -0.0, 0.1, std::numeric_limits<double>::denorm_min(),
      std::numeric_limits<double>::max(), std::numeric_limits<double>::min(), -1e22;

  Problem problem;
  problem.name = "any";
  problem.q = numbers;
  problem.lower = VectorXd::Constant(numbers.size(), -infinity);
  problem.upper = numbers;
  DelassusMatrix::Sparse diagonal(numbers.size(), numbers.size());
  diagonal.setIdentity();
  problem.W = DelassusMatrix(diagonal);
  expectSame(problem, fromText(toText(problem)));
}

TEST(ProblemText, UnilateralRowsNeedNoBoundsButNegativeZeroDoes) {
  Problem problem = fromText(rowText);
  problem.lower.setZero();
  problem.upper.setConstant(infinity);
  EXPECT_THAT(toText(problem), ::testing::Not(HasSubstr("bounds")));
  expectSame(problem, fromText(toText(problem)));
  problem.lower[1] = -0.0;
  expectSame(problem, fromText(toText(problem)));
}

TEST(ProblemText, EmptyProblem) {
  const Problem nothing = fromText("lcp v1\nname none\nsize 0\nentries 0\nq\nM\nend\n");
  EXPECT_EQ(nothing.size(), 0);
  expectSame(nothing, fromText(toText(nothing)));
  EXPECT_EQ(fromText(toText(Problem())).name, "unnamed");
}

TEST(ProblemText, WritesDiagonalBlocksEvenIfAbsent) {
  Problem problem = fromText(contactText);
  problem.W = DelassusMatrix(DelassusMatrix::Sparse(6, 6));
  EXPECT_THAT(toText(problem), HasSubstr("blocks 2\n"));
  EXPECT_TRUE(fromText(toText(problem)).W.dense().isZero(0));
}

TEST(ProblemText, DoesNotDependOnTheLocale) {
  struct Comma : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
  };
  const std::string text = toText(fromText(contactText));
  const std::locale before = std::locale::global(std::locale(std::locale::classic(), new Comma));
  const std::string textWithCommas = toText(fromText(contactText));
  std::locale::global(before);
  EXPECT_EQ(text, textWithCommas);
}

TEST(ProblemText, BodySpaceIsWrittenAsEntries) {
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  const auto draw = [&](double) { return normal(random); };

  // Three bodies in a row on the ground: contact 0 touches body 0 only, contact 3 body 2 only.
  BodySpace space;
  space.bodies = 3;
  space.compliance = VectorXd::Zero(12).unaryExpr(draw).cwiseAbs();
  for (int i = -1; i < 3; ++i) {
    const Mat36 Ja = Mat36::Zero().unaryExpr(draw), Jb = Mat36::Zero().unaryExpr(draw);
    space.contacts.push_back({i, i < 2 ? i + 1 : fixedWorld, Ja, Jb});
  }
  Problem problem;
  problem.W = DelassusMatrix(space);
  problem.q = VectorXd::Zero(12).unaryExpr(draw);
  problem.friction = VectorXd::Constant(4, 0.3);

  const Problem written = fromText(toText(problem));
  const MatrixXd W = written.W.dense();
  EXPECT_EQ(W, MatrixXd(W.transpose())) << "both triangles to the last bit";
  EXPECT_TRUE(W.isApprox(problem.W.dense(), 1e-15));
  EXPECT_EQ(written.W.entries().nonZeros(), 9 * (4 + 2 * 3)) << "only contacts that share a body";
  expectSame(written, fromText(toText(written)));
}

TEST(ProblemText, WritesSolutions) {
  const Problem problem = fromText(contactText);
  Solution solution;
  solution.r = VectorXd::LinSpaced(6, 0, 5);
  solution.u = -solution.r;
  solution.status = Status::OutOfBudget;
  std::ostringstream out;
  writeSolution(out, problem, solution);
  EXPECT_EQ(
      out.str(),
      "solution v1\nname two\nstatus out_of_budget\nr\n0 1 2\n3 4 5\nu\n-0 -1 -2\n-3 -4 -5\nend\n");

  const Problem rows = fromText(rowText);
  solution.r = Eigen::Vector2d(0.1, 2);
  solution.u = Eigen::Vector2d(0, 1e-20);
  solution.status = Status::Solved;
  std::ostringstream one;
  writeSolution(one, rows, solution);
  EXPECT_EQ(one.str(), "solution v1\nname boxed\nstatus solved\nr\n0.1\n2\nu\n0\n1e-20\nend\n");
  EXPECT_EQ(toString(Status::Incompatible), "incompatible");
  EXPECT_EQ(toString(Status::NonFinite), "non_finite");
}

TEST(ProblemText, WhatHasNoTextIsRefused) {
  const Problem good = fromText(contactText), rows = fromText(rowText);
  const auto refused = [](Problem problem) {
    std::ostringstream out;
    EXPECT_THROW(writeProblem(out, problem), std::invalid_argument);
    EXPECT_EQ(out.str(), "") << "nothing is written before the problem is known to be writable";
  };
  Problem bad = good;
  for (const std::string& name : {std::string("two words"), std::string(5000, 'x')}) {
    bad.name = name;
    refused(bad);
  }
  bad = good;
  bad.q[3] = std::nan("");
  refused(bad);
  bad = good;
  bad.friction[0] = -0.1;
  refused(bad);
  bad = rows;
  bad.upper[1] = -1;
  refused(bad);
  bad = rows;
  bad.lower[0] = infinity;
  refused(bad);
  bad = rows;
  DelassusMatrix::Sparse W = rows.W.entries();
  W.coeffRef(0, 0) = infinity;
  bad.W = DelassusMatrix(W);
  refused(bad);

  Problem both = good;
  both.lower = both.upper = VectorXd::Zero(1);
  both.q = VectorXd::Zero(7);
  both.W = DelassusMatrix(DelassusMatrix::Sparse(7, 7));
  refused(both);
}

TEST(ProblemText, FilesAndTheirNames) {
  const auto folder = std::filesystem::temp_directory_path() / "delassus_problem_text_test";
  std::filesystem::create_directories(folder);
  const std::string good = (folder / "good.fc3d").string(),
                    empty = (folder / "empty.fc3d").string();
  const auto complaintAbout = [](const std::string& path) -> std::string {
    try {
      readProblem(path);
    } catch (const ProblemTextError& error) {
      return error.what();
    }
    return "";
  };

  writeProblem(good, fromText(contactText));
  expectSame(readProblem(good), fromText(contactText));
  std::ofstream(empty).close();
  EXPECT_THAT(complaintAbout(empty), StartsWith(empty + ":1: expected 'delassus-problem v1'"));
  EXPECT_THAT(complaintAbout(folder.string()),
              StartsWith(folder.string() + ": expected a problem file, found a directory"));
  EXPECT_THAT(complaintAbout((folder / "missing.lcp").string()),
              HasSubstr("missing.lcp: expected"));
  EXPECT_THAT(complaintAbout((folder / "missing.lcp").string()), HasSubstr("No such file"));

  const std::string nowhere = (folder / "no" / "such.fc3d").string();
  try {
    writeProblem(nowhere, fromText(contactText));
    FAIL() << "wrote into a folder that does not exist";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), StartsWith(nowhere + ": cannot be written: No such file"));
  }
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace delassus
