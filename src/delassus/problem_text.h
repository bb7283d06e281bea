#pragma once

#include <iosfwd>
#include <stdexcept>
#include <string>

#include "delassus/problem.h"
#include "delassus/solution.h"

namespace delassus {

/// A problem text that cannot be read: "file:line: what was expected, what was found".
class ProblemTextError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Lists of numbers, separated by blanks or new lines. Lines that begin with # may stand only
/// between sections. A block of W belongs to the contacts `row` and `col`, counted from 0; its nine
/// entries come row by row, and each contact has its normal first. Both triangles are written,
/// missing blocks and entries are zero, and blocks and entries are sorted.
///
///     delassus-problem v1           lcp v1                        solution v1
///     name NAME                     name NAME                     name NAME
///     contacts N                    size N                        status STATUS
///     blocks B                      entries E                     r
///     mu    N numbers               bounds N times lower upper    ...
///     q     3 N numbers             q     N numbers               u
///     W     B times row col w00..   M     E times row col value   ...
///     end                           end                           end
///
/// `bounds` may be left out (then [0, ∞)). Only there may numbers be inf or -inf.
enum class ProblemFormat {
  Contacts,  ///< `delassus-problem v1`: contacts with friction
  Rows,      ///< `lcp v1`: rows with bounds
};

/// Reads either format; the first line tells which. For an empty problem only `format` tells which
/// it was. Throws ProblemTextError. The overload with a stream uses `source` as the file's name in
/// errors.
Problem readProblem(const std::string& path, ProblemFormat* format = nullptr);
Problem readProblem(std::istream& in, const std::string& source, ProblemFormat* format = nullptr);

/// Writes the format that fits: `lcp v1` if the problem has no contacts, `delassus-problem v1` if
/// it has no rows. W in body space is written as entries. Numbers have enough digits to reproduce
/// them exactly: reading back gives the same W, q, friction and bounds, bit for bit. Throws
/// std::invalid_argument for a problem with both contacts and rows, which neither format can
/// express, a name of two words, values that are not numbers, μ < 0, crossed bounds, and disks.
/// Throws std::runtime_error if the path cannot be written; with a stream, check its state instead.
void writeProblem(std::ostream& out, const Problem& problem);
void writeProblem(const std::string& path, const Problem& problem);

/// Writes `solution v1`. Throws as writeProblem.
void writeSolution(std::ostream& out, const Problem& problem, const Solution& solution);
void writeSolution(const std::string& path, const Problem& problem, const Solution& solution);

}  // namespace delassus
