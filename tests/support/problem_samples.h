#pragma once
/// Two small problem texts, and what tests of reading and writing do with such texts.

#include <gtest/gtest.h>

#include <cstring>
#include <sstream>
#include <string>

#include "delassus/problem_text.h"

namespace delassus::test {

inline Problem fromText(const std::string& text) {
  std::istringstream in(text);
  return readProblem(in, "text");
}

inline std::string toText(const Problem& problem) {
  std::ostringstream out;
  writeProblem(out, problem);
  return out.str();
}

/// What reading `text` complains about; empty if it does not.
inline std::string complaint(const std::string& text) {
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

inline bool sameBits(const VectorXd& a, const VectorXd& b) {
  return a.size() == b.size() && sameBits(a.data(), b.data(), a.size());
}

/// The same problem, bit for bit, with the same stored entries.
inline void expectSame(const Problem& a, const Problem& b) {
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
inline const char* const contactText =
    "delassus-problem v1\n"         // 1
    "# where it comes from\n"       // 2
    "name two\n"                    // 3
    "contacts 2\n"                  // 4
    "blocks 3\n"                    // 5
    "mu\n"                          // 6
    "0.5\n"                         // 7
    "0\n"                           // 8
    "q\n"                           // 9
    "-1 0.25 -0.125\n"              // 10
    "1e-3 -0 3\n"                   // 11
    "W\n"                           // 12
    "0 0 2 .5 0 .5 1 0 0 0 1\n"     // 13
    "1 0 0 0 0 0 0 0 0 0 1e-300\n"  // 14
    "1 1 1 0 0 0 1 0 0 0 1\n"       // 15
    "end\n";                        // 16

inline const char* const rowText =
    "lcp v1\n"      // 1
    "name boxed\n"  // 2
    "size 2\n"      // 3
    "entries 3\n"   // 4
    "bounds\n"      // 5
    "-inf inf\n"    // 6
    "-0.5 2\n"      // 7
    "q\n"           // 8
    "-1\n"          // 9
    "3\n"           // 10
    "M\n"           // 11
    "0 0 0\n"       // 12
    "1 0 -1\n"      // 13
    "1 1 4\n"       // 14
    "end\n";        // 15

/// `text` with line `line` (from 1) replaced.
inline std::string withLine(const std::string& text, int line, const std::string& replacement) {
  std::istringstream in(text);
  std::string out, current;
  for (int i = 1; std::getline(in, current); ++i) out += (i == line ? replacement : current) + "\n";
  return out;
}

}  // namespace delassus::test
