#pragma once
/// What tests of reading and writing share for problem texts.

#include <gtest/gtest.h>

#include <sstream>
#include <string>

#include "tests/support/problem_texts.h"

namespace delassus::test {

/// The complaint about `text` when it is read; empty if there is none.
inline std::string complaint(const std::string& text) {
  try {
    fromText(text);
  } catch (const ProblemTextError& error) {
    return error.what();
  }
  return "";
}

/// The problems are the same, bit for bit, with the same stored entries.
inline void expectSame(const Problem& a, const Problem& b) { EXPECT_EQ(difference(a, b), ""); }

/// `text` with line `line` (from 1) replaced.
inline std::string withLine(const std::string& text, int line, const std::string& replacement) {
  std::istringstream in(text);
  std::string out, current;
  for (int i = 1; std::getline(in, current); ++i) out += (i == line ? replacement : current) + "\n";
  return out;
}

}  // namespace delassus::test
