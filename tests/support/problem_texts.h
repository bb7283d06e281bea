#pragma once
/// Two small problem texts, texts to problems and back, and whether two problems are the same, bit
/// for bit.

#include <cstring>
#include <string>

#include "delassus/problem_text.h"

namespace delassus::test {

// Two contacts; the first block off the diagonal is absent. The tests of errors use the line
// numbers.
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

Problem fromText(const std::string& text);
std::string toText(const Problem& problem);

/// Equal as bits: tells 0 from -0.
template <class X>
bool sameBits(const X* a, const X* b, Eigen::Index n) {
  return n == 0 || std::memcmp(a, b, static_cast<std::size_t>(n) * sizeof(X)) == 0;
}

inline bool sameBits(const VectorXd& a, const VectorXd& b) {
  return a.size() == b.size() && sameBits(a.data(), b.data(), a.size());
}

/// The difference of two problems in words, stored entries included; empty if they are the same,
/// bit for bit.
std::string difference(const Problem& a, const Problem& b);

}  // namespace delassus::test
