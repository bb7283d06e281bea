#include "delassus/problem_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <locale>
#include <random>
#include <sstream>

#include "tests/support/shared_data.h"

namespace delassus {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr double infinity = std::numeric_limits<double>::infinity();

Problem fromText(const std::string& text) {
  std::istringstream in(text);
  return readProblem(in, "text");
}

std::string toText(const Problem& problem) {
  std::ostringstream out;
  writeProblem(out, problem);
  return out.str();
}

/// What reading `text` complains about; empty if it does not.
std::string complaint(const std::string& text) {
  try {
    fromText(text);
  } catch (const ProblemTextError& error) {
    return error.what();
  }
  return "";
}

/// Equal as bits: tells 0 from -0.
template <class X>
bool sameBits(const X* a, const X* b, Eigen::Index n) {
  return n == 0 || std::memcmp(a, b, static_cast<std::size_t>(n) * sizeof(X)) == 0;
}

bool sameBits(const VectorXd& a, const VectorXd& b) {
  return a.size() == b.size() && sameBits(a.data(), b.data(), a.size());
}

/// The same problem, bit for bit, with the same stored entries.
void expectSame(const Problem& a, const Problem& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_TRUE(sameBits(a.q, b.q));
  EXPECT_TRUE(sameBits(a.friction, b.friction));
  EXPECT_TRUE(sameBits(a.lower, b.lower));
  EXPECT_TRUE(sameBits(a.upper, b.upper));
  const DelassusMatrix::Sparse &A = a.W.entries(), &B = b.W.entries();
  ASSERT_EQ(A.rows(), B.rows());
  ASSERT_EQ(A.nonZeros(), B.nonZeros());
  EXPECT_TRUE(sameBits(A.outerIndexPtr(), B.outerIndexPtr(), A.rows() + 1));
  EXPECT_TRUE(sameBits(A.innerIndexPtr(), B.innerIndexPtr(), A.nonZeros()));
  EXPECT_TRUE(sameBits(A.valuePtr(), B.valuePtr(), A.nonZeros()));
}

// Two contacts, the first block off the diagonal absent. Line numbers matter to the tests of errors below.
const char* const contactText =
    "delassus-problem v1\n"        // 1
    "# where it comes from\n"      // 2
    "name two\n"                   // 3
    "contacts 2\n"                 // 4
    "blocks 3\n"                   // 5
    "mu\n"                         // 6
    "0.5\n"                        // 7
    "0\n"                          // 8
    "q\n"                          // 9
    "-1 0.25 -0.125\n"             // 10
    "1e-3 -0 3\n"                  // 11
    "W\n"                          // 12
    "0 0 2 .5 0 .5 1 0 0 0 1\n"    // 13
    "1 0 0 0 0 0 0 0 0 0 1e-300\n" // 14
    "1 1 1 0 0 0 1 0 0 0 1\n"      // 15
    "end\n";                       // 16

const char* const rowText =
    "lcp v1\n"       // 1
    "name boxed\n"   // 2
    "size 2\n"       // 3
    "entries 3\n"    // 4
    "bounds\n"       // 5
    "-inf inf\n"     // 6
    "-0.5 2\n"       // 7
    "q\n"            // 8
    "-1\n"           // 9
    "3\n"            // 10
    "M\n"            // 11
    "0 0 0\n"        // 12
    "1 0 -1\n"       // 13
    "1 1 4\n"        // 14
    "end\n";         // 15

/// `text` with line `line` (from 1) replaced.
std::string withLine(const std::string& text, int line, const std::string& replacement) {
  std::istringstream in(text);
  std::string out, current;
  for (int i = 1; std::getline(in, current); ++i)
    out += (i == line ? replacement : current) + "\n";
  return out;
}

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

  const Problem unilateral =
      fromText("lcp v1\nname n\nsize 1\nentries 1\nq\n-1\nM\n0 0 1\nend\n");
  EXPECT_EQ(unilateral.lower[0], 0);
  EXPECT_EQ(unilateral.upper[0], infinity);
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
  EXPECT_EQ(out.str(),
            "solution v1\nname two\nstatus out_of_budget\nr\n0 1 2\n3 4 5\nu\n-0 -1 -2\n-3 -4 -5\nend\n");

  const Problem rows = fromText(rowText);
  solution.r = Eigen::Vector2d(0.1, 2);
  solution.u = Eigen::Vector2d(0, 1e-20);
  solution.status = Status::Solved;
  std::ostringstream one;
  writeSolution(one, rows, solution);
  EXPECT_EQ(one.str(), "solution v1\nname boxed\nstatus solved\nr\n0.1\n2\nu\n0\n1e-20\nend\n");
  EXPECT_EQ(toString(Status::Incompatible), "incompatible");
}

TEST(ProblemText, WhatHasNoTextIsRefused) {
  const Problem good = fromText(contactText), rows = fromText(rowText);
  const auto refused = [](Problem problem) {
    std::ostringstream out;
    EXPECT_THROW(writeProblem(out, problem), std::invalid_argument);
    EXPECT_EQ(out.str(), "") << "nothing is written before the problem is known to be writable";
  };
  Problem bad = good;
  bad.name = "two words";
  refused(bad);
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
  const std::string good = (folder / "good.fc3d").string(), empty = (folder / "empty.fc3d").string();
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
  EXPECT_THAT(complaintAbout((folder / "missing.lcp").string()), HasSubstr("missing.lcp: expected"));
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

/// A line of one of the texts above made wrong, and what is said about it. Line 0: the text as a whole.
struct BadLine {
  const char* base;
  int line;
  const char* replacement;
  const char* message;
};

TEST(ProblemText, ErrorsNameTheLineAndWhatWasExpected) {
  const BadLine cases[] = {
      // Format and head.
      {contactText, 1, "delassus-problem v2", ":1: expected 'delassus-problem v1' or 'lcp v1', found 'delassus-problem v2'"},
      {contactText, 1, " delassus-problem v1", ":1: expected 'delassus-problem v1' or 'lcp v1', found"},
      {contactText, 1, "\xef\xbb\xbf" "delassus-problem v1", "found '\\xef\\xbb\\xbfdelassus-problem v1'"},
      {contactText, 3, "nome two", ":3: expected 'name', found 'nome'"},
      {contactText, 3, "name two words", ":3: expected 'contacts', found 'words'"},
      {contactText, 4, "contacts two", ":4: expected the number of contacts from 0 to 238609294, found 'two'"},
      {contactText, 4, "contacts -1", ":4: expected the number of contacts from 0 to 238609294, found '-1'"},
      {contactText, 4, "contacts 1.0", ", found '1.0'"},
      {contactText, 4, "contacts 99999999999999999999", ", found '99999999999999999999'"},
      {contactText, 4, "size 2", ":4: expected 'contacts', found 'size'"},
      {contactText, 5, "blocks 1", ":5: expected the number of blocks from 2 to 4, found '1'"},
      {contactText, 5, "blocks 5", ":5: expected the number of blocks from 2 to 4, found '5'"},
      // Lists that are too short, too long, or not numbers.
      {contactText, 4, "contacts 1\nblocks 1", ":6: expected 'mu', found 'blocks'"},
      {contactText, 8, "", ":9: expected a finite number in entry 2 of 2 of 'mu', found 'q'"},
      {contactText, 8, "0\n0", ":9: expected 'q', found '0'"},
      {contactText, 7, "-0.5", ":7: expected a friction coefficient of at least 0 in entry 1 of 2 of 'mu', found '-0.5'"},
      {contactText, 7, "nan", ":7: expected a finite number in entry 1 of 2 of 'mu', found 'nan'"},
      {contactText, 10, "-1 inf 0", ":10: expected a finite number in entry 1 of 2 of 'q', found 'inf'"},
      {contactText, 10, "-1 1e999 0", ", found '1e999'"},
      {contactText, 10, "-1 0x10 0", ", found '0x10'"},
      {contactText, 10, "-1 0,5 0", ", found '0,5'"},
      {contactText, 10, "-1 1e 0", ", found '1e'"},
      {contactText, 11, "# not here\n1 2 3", ":11: expected a finite number in entry 2 of 2 of 'q', found a comment"},
      {contactText, 12, "M", ":12: expected 'W', found 'M'"},
      // Places in the matrix.
      {contactText, 13, "0 2 2 .5 0 .5 1 0 0 0 1", ":13: expected a column from 0 to 1 in entry 1 of 3 of 'W', found '2'"},
      {contactText, 14, "-1 0 0 0 0 0 0 0 0 0 1", ":14: expected a row from 0 to 1 in entry 2 of 3 of 'W', found '-1'"},
      {contactText, 14, "0 0 0 0 0 0 0 0 0 0 1", ":14: expected a place after 0 0, sorted by row, then column, none twice in entry 2 of 3 of 'W', found '0 0'"},
      {contactText, 15, "0 1 1 0 0 0 1 0 0 0 1", ":15: expected a place after 1 0"},
      {contactText, 13, "0 1 2 .5 0 .5 1 0 0 0 1", ":13: expected the diagonal place 0 0, present even if zero in entry 1 of 3 of 'W', found '0 1'"},
      {contactText, 15, "1 0 1 0 0 0 1 0 0 0 1", ":15: expected a place after 1 0"},
      {contactText, 14, "0 1 0 0 0 0 0 0 0 0 1\n1 0 1 1 1 1 1 1 1 1 1\n#", ":15: expected the diagonal place 1 1, present even if zero in entry 3 of 3 of 'W', found the last entry without it"},
      {contactText, 15, "1 1 1 0 0 0 1 0 0 0", ":16: expected a finite number in entry 3 of 3 of 'W', found 'end'"},
      {contactText, 15, "1 1 1 0 0 0 1 0 0 0 1 1", ":15: expected 'end', found '1'"},
      // The end.
      {contactText, 16, "", ": expected 'end', found the end of the text"},
      {contactText, 16, "end of it", ":16: expected nothing after 'end', found 'of'"},
      // Rows.
      {rowText, 3, "size 99999999999", ":3: expected the number of unknowns from 0 to 2147483647, found '99999999999'"},
      {rowText, 6, "inf inf", ":6: expected a finite number or -inf in entry 1 of 2 of 'bounds', found 'inf'"},
      {rowText, 6, "-inf -inf", ":6: expected a finite number or inf in entry 1 of 2 of 'bounds', found '-inf'"},
      {rowText, 6, "-inf infinity", ", found 'infinity'"},
      {rowText, 7, "nan 2", ":7: expected a finite number or -inf in entry 2 of 2 of 'bounds', found 'nan'"},
      {rowText, 7, "3 2", ":7: expected an upper bound not below the lower bound in entry 2 of 2 of 'bounds', found '2'"},
      {rowText, 8, "p", ":8: expected 'q', found 'p'"},
      {rowText, 10, "inf", ":10: expected a finite number in entry 2 of 2 of 'q', found 'inf'"},
      {rowText, 14, "1 1 -inf", ":14: expected a finite number in entry 3 of 3 of 'M', found '-inf'"},
  };
  for (const BadLine& bad : cases) {
    const std::string said = complaint(withLine(bad.base, bad.line, bad.replacement));
    EXPECT_THAT(said, StartsWith("text:")) << bad.replacement;
    EXPECT_THAT(said, HasSubstr(bad.message));
    EXPECT_EQ(said.find('\n'), std::string::npos);
  }
}

TEST(ProblemText, EveryTruncationIsAnError) {
  for (const std::string text : {contactText, rowText}) {
    const std::size_t complete = text.find("end") + 3;
    for (std::size_t length = 0; length < complete; ++length)
      EXPECT_THAT(complaint(text.substr(0, length)), HasSubstr("expected")) << length;
    EXPECT_EQ(complaint(text.substr(0, complete)), "");
  }
}

TEST(ProblemText, HugeCountsAskForNoMemory) {
  const std::string head = "delassus-problem v1\nname n\ncontacts 200000000\nblocks 200000000\nmu\n1\n";
  EXPECT_THAT(complaint(head), HasSubstr("in entry 2 of 200000000 of 'mu', found the end of the text"));
  EXPECT_THAT(complaint("lcp v1\nname n\nsize 2000000000\nentries 2147483647\nbounds\n0"),
              HasSubstr("in entry 1 of 2000000000 of 'bounds', found the end of the text"));
}

/// A text without end, and a device that fails after a few characters.
struct Endless : std::streambuf {
  explicit Endless(char c) : c_(c) { setg(&c_, &c_, &c_ + 1); }
  int_type underflow() override {
    setg(&c_, &c_, &c_ + 1);
    return traits_type::to_int_type(c_);
  }
  char c_;
};

struct Failing : std::stringbuf {
  using std::stringbuf::stringbuf;
  int_type underflow() override { throw std::ios_base::failure("device"); }
};

TEST(ProblemText, EndlessTextsAndFailingDevices) {
  for (const char c : {'\0', 'x'}) {
    Endless buffer(c);
    std::istream in(&buffer);
    EXPECT_THROW(readProblem(in, "endless"), ProblemTextError);
  }
  const std::string longName = "lcp v1\nname " + std::string(5000, 'x');
  EXPECT_THAT(complaint(longName), HasSubstr("text:2: expected a word of at most 4096 characters"));

  Failing buffer("lcp v1\nname n\n", std::ios::in);
  std::istream in(&buffer);
  try {
    readProblem(in, "device");
    FAIL() << "read beyond the failure";
  } catch (const ProblemTextError& error) {
    EXPECT_THAT(error.what(), HasSubstr("expected readable text, found a device error"));
  }
}

/// Whatever happens to a text, it is read or refused with one clear line; and what is read can be written.
TEST(ProblemText, MutatedTextsAreReadOrRefused) {
  std::mt19937_64 random(20);
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
  const std::string bytes("0123456789+-.eE#infa \n\r\t\0\xff", 26);
  int read = 0;
  for (int k = 0; k < 2000; ++k) {
    std::string text = k % 2 ? contactText : rowText;
    for (std::size_t edits = 1 + below(3); edits > 0 && !text.empty(); --edits) {
      const std::size_t at = below(text.size());
      switch (below(4)) {
        case 0: text.erase(at, 1 + below(20)); break;
        case 1: text.insert(at, 1, bytes[below(bytes.size())]); break;
        case 2: text[at] = bytes[below(bytes.size())]; break;
        case 3: text.insert(at, text.substr(below(text.size()), 1 + below(20))); break;
      }
    }
    try {
      const Problem problem = fromText(text);
      expectSame(problem, fromText(toText(problem)));
      ++read;
    } catch (const ProblemTextError& error) {
      EXPECT_THAT(error.what(), StartsWith("text:"));
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
    } catch (const std::exception& error) {
      ADD_FAILURE() << error.what() << " for\n" << text;
    }
  }
  EXPECT_GT(read, 50) << "mutations that only ever break the first line test nothing";
  EXPECT_LT(read, 1950);
}

}  // namespace
}  // namespace delassus
