#include "delassus/problem_text.h"

#include <algorithm>
#include <cerrno>
#include <climits>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <utility>
#include <vector>

#include "delassus/word_reader.h"

namespace delassus {
namespace {

using Sparse = DelassusMatrix::Sparse;

// Lists grow with the text, so that a wrong count cannot ask for memory that the text does not
// fill.

VectorXd toVector(const std::vector<double>& numbers) {
  return Eigen::Map<const Eigen::VectorXd>(numbers.data(),
                                           static_cast<Eigen::Index>(numbers.size()));
}

VectorXd readNumbers(WordReader& in, const char* section, int entries, int numbersPerEntry) {
  std::vector<double> numbers;
  in.openSection(section, entries);
  for (int k = 0; k < entries; ++k) {
    in.nextEntry();
    for (int i = 0; i < numbersPerEntry; ++i) numbers.push_back(in.number());
  }
  return toVector(numbers);
}

VectorXd readFriction(WordReader& in, int contacts) {
  std::vector<double> friction;
  in.openSection("mu", contacts);
  for (int k = 0; k < contacts; ++k) {
    in.nextEntry();
    friction.push_back(in.number());
    if (friction.back() < 0) in.fail("a friction coefficient of at least 0");
  }
  return toVector(friction);
}

/// The optional section of bounds. False without it.
bool readBounds(WordReader& in, Problem& problem, int rows) {
  if (!in.openOptionalSection("bounds", rows)) return false;
  std::vector<double> lower, upper;
  for (int k = 0; k < rows; ++k) {
    in.nextEntry();
    lower.push_back(in.numberOr("-inf", -infinity));
    upper.push_back(in.numberOr("inf", infinity));
    if (lower.back() > upper.back()) in.fail("an upper bound not below the lower bound");
  }
  problem.lower = toVector(lower);
  problem.upper = toVector(upper);
  return true;
}

struct Place {
  int row, column;

  bool operator<(const Place& other) const {
    return std::pair(row, column) < std::pair(other.row, other.column);
  }
  std::string text() const { return std::to_string(row) + " " + std::to_string(column); }
};

/// Reads n x n blocks of side x side values, row-major: sorted, none twice, all diagonal blocks
/// present.
Sparse readMatrix(WordReader& in, const char* section, int n, int entries, int side) {
  std::vector<Place> places;
  std::vector<double> values;
  int diagonals = 0;  // the rows before this one have their diagonal block
  const auto expectDiagonal = [&](const std::string& found) {
    in.fail("the diagonal place " + Place{diagonals, diagonals}.text() + ", present even if zero",
            found);
  };

  in.openSection(section, entries);
  for (int k = 0; k < entries; ++k) {
    in.nextEntry();
    Place place{};
    place.row = in.integer("a row", 0, n - 1);
    place.column = in.integer("a column", 0, n - 1);
    if (!places.empty() && !(places.back() < place))
      in.fail("a place after " + places.back().text() + ", sorted by row, then column, none twice",
              "'" + place.text() + "'");
    if (place.row > diagonals || (place.row == diagonals && place.column > place.row))
      expectDiagonal("'" + place.text() + "'");
    if (place.row == place.column) ++diagonals;
    places.push_back(place);
    for (int i = 0; i < side * side; ++i) values.push_back(in.number());
  }
  if (diagonals < n) expectDiagonal("the last entry without it");

  // Every row has at least its diagonal block, so that rows can be appended one after the other.
  Sparse matrix(n * side, n * side);
  matrix.reserve(static_cast<Eigen::Index>(values.size()));
  for (std::size_t begin = 0, end = 0; begin < places.size(); begin = end) {
    while (end < places.size() && places[end].row == places[begin].row) ++end;
    for (int i = 0; i < side; ++i) {
      const int row = places[begin].row * side + i;
      matrix.startVec(row);
      for (std::size_t k = begin; k < end; ++k)
        for (int j = 0; j < side; ++j)
          matrix.insertBack(row, places[k].column * side + j) = values[(k * side + i) * side + j];
    }
  }
  matrix.finalize();
  return matrix;
}

/// The beginning of both formats: name, number of contacts or rows (`size`), number of blocks or
/// entries.
struct Head {
  std::string name;
  int size, entries;
};

Head readHead(WordReader& in, const char* sizeWord, const char* entriesWord, int side) {
  // Eigen's indices are ints: so are the number of unknowns and the number of stored values.
  const long long mostValues = INT_MAX / (side * side);
  Head head{};
  in.keyword("name");
  head.name = in.word("a name");
  in.keyword(sizeWord, " after a name of one word");
  head.size = in.integer("the number of " + std::string(side == 3 ? "contacts" : "unknowns"), 0,
                         mostValues);
  in.keyword(entriesWord);
  head.entries = in.integer(std::string("the number of ") + entriesWord, head.size,
                            std::min<long long>(1LL * head.size * head.size, mostValues));
  return head;
}

Problem readContactProblem(WordReader& in) {
  Problem problem;
  const Head head = readHead(in, "contacts", "blocks", 3);
  problem.name = head.name;
  problem.friction = readFriction(in, head.size);
  problem.q = readNumbers(in, "q", head.size, 3);
  problem.W = DelassusMatrix(readMatrix(in, "W", head.size, head.entries, 3));
  in.end();
  return problem;
}

Problem readRowProblem(WordReader& in) {
  Problem problem;
  const Head head = readHead(in, "size", "entries", 1);
  problem.name = head.name;
  const bool isBounded = readBounds(in, problem, head.size);
  problem.q = readNumbers(in, "q", head.size, 1);
  if (!isBounded) {  // all rows are unilateral
    problem.lower.setZero(problem.q.size());
    problem.upper = VectorXd::Constant(problem.q.size(), infinity);
  }
  problem.W = DelassusMatrix(readMatrix(in, "M", head.size, head.entries, 1));
  in.end();
  return problem;
}

ProblemFormat readFormat(WordReader& in) {
  const std::string line = in.firstLine();
  if (line == "delassus-problem v1") return ProblemFormat::Contacts;
  if (line == "lcp v1") return ProblemFormat::Rows;
  in.fail("'delassus-problem v1' or 'lcp v1'");
}

}  // namespace

Problem readProblem(std::istream& in, const std::string& source, ProblemFormat* format) {
  WordReader words(in, source);
  try {
    const ProblemFormat found = readFormat(words);
    if (format != nullptr) *format = found;
    return found == ProblemFormat::Contacts ? readContactProblem(words) : readRowProblem(words);
  } catch (const std::ios_base::failure&) {
    // A file buffer reports a failing device by this exception, whatever the stream's own settings.
    words.fail("readable text", "a device error");
  }
}

Problem readProblem(const std::string& path, ProblemFormat* format) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored))
    throw ProblemTextError(path + ": expected a problem file, found a directory");
  errno = 0;
  std::ifstream in(path, std::ios::binary);
  if (!in)
    throw ProblemTextError(path + ": expected a problem file, found: " +
                           (errno ? std::strerror(errno) : "a file that cannot be opened"));
  return readProblem(in, path, format);
}

}  // namespace delassus
