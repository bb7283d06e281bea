#pragma once

#include <iosfwd>
#include <stdexcept>
#include <string>

#include "delassus/problem.h"
#include "delassus/solution.h"

namespace delassus {

/// A problem text that cannot be read: "file:line: what was expected, what stands there".
class ProblemTextError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Lists of numbers, divided by blanks or new lines; lines that begin with # stand between sections
/// only. A block of W is that of the contacts `row` and `col`, from 0, its nine entries row by row;
/// each contact has its normal first. Both triangles are written, what is not there is zero, blocks
/// and entries are sorted.
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
/// `bounds`, which may be left out (then [0, ∞)), alone may hold inf and -inf.
enum class ProblemFormat {
  Contacts,  ///< `delassus-problem v1`: contacts with friction
  Rows,      ///< `lcp v1`: rows with bounds
};

/// Reads one of the formats, told apart by the first line; where the problem is empty, only
/// `format` says which it was. Throws ProblemTextError. The overload with a stream uses `source` as
/// the file's name in errors.
Problem readProblem(const std::string& path, ProblemFormat* format = nullptr);
Problem readProblem(std::istream& in, const std::string& source, ProblemFormat* format = nullptr);

/// Writes the format that fits: `lcp v1` if the problem has no contacts, `delassus-problem v1` if
/// it has no rows. A problem with both is not expressible and throws std::invalid_argument. W in
/// body space is written as entries. Numbers have as many digits as reproduce them exactly: reading
/// back gives the same W, q, friction and bounds, bit for bit. std::invalid_argument is thrown for
/// a name of two words, numbers that are none, μ < 0, crossed bounds and disks, too;
/// std::runtime_error where the path cannot be written. Of a stream, look at the state.
void writeProblem(std::ostream& out, const Problem& problem);
void writeProblem(const std::string& path, const Problem& problem);

/// Writes `solution v1`. Throws as writeProblem.
void writeSolution(std::ostream& out, const Problem& problem, const Solution& solution);
void writeSolution(const std::string& path, const Problem& problem, const Solution& solution);

}  // namespace delassus
