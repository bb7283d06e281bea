#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>
#include <cmath>
#include <cstring>
#include <map>

#include "delassus/problem_text.h"
#include "delassus/whole_file.h"
#include "delassus/word_reader.h"

namespace delassus {
namespace {

using Sparse = DelassusMatrix::Sparse;

/// The fewest digits that read back as the same double, in every locale.
void appendNumber(std::string& text, double x) {
  std::array<char, 32> digits;
  const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), x);
  assert(error == std::errc() && "the shortest form of a double has at most 24 characters");
  text.append(digits.data(), end);
}

void appendLine(std::string& text, const std::string& line) { text += line + "\n"; }

/// Lines of `perLine` numbers from `first` to before `last`.
void appendLines(std::string& text, const VectorXd& x, int first, int last, int perLine) {
  for (int i = first; i < last; ++i) {
    appendNumber(text, x[i]);
    text += (i - first) % perLine == perLine - 1 ? '\n' : ' ';
  }
}

void requireFinite(const Eigen::Ref<const Eigen::VectorXd>& x, const char* what) {
  if (!x.allFinite())
    throw std::invalid_argument(
        std::string("a problem text holds no infinite numbers and no NaN in ") + what);
}

/// A nameless problem is written as "unnamed", since the format needs a word there.
std::string nameWord(const std::string& name) {
  if (name.size() > WordReader::longestWord || !std::all_of(name.begin(), name.end(), isVisible))
    throw std::invalid_argument("the name of a problem must be one word to be written");
  return name.empty() ? "unnamed" : name;
}

struct MatrixText {
  int entries = 0;
  std::string text;
};

/// All side x side blocks with a stored value, and the diagonal ones.
MatrixText matrixText(const DelassusMatrix& W, int side) {
  Sparse matrix = W.asEntries();
  matrix.makeCompressed();
  requireFinite(Eigen::Map<const Eigen::VectorXd>(matrix.valuePtr(), matrix.nonZeros()),
                "the matrix");
  MatrixText out;
  for (int row = 0; row < W.size() / side; ++row) {
    std::map<int, std::array<double, 9>> blocks{{row, {}}};
    for (int i = 0; i < side; ++i)
      for (Sparse::InnerIterator w(matrix, row * side + i); w; ++w) {
        const int column = static_cast<int>(w.col());
        blocks[column / side][i * side + column % side] = w.value();
      }
    for (const auto& [column, values] : blocks) {
      out.text += std::to_string(row) + " " + std::to_string(column);
      for (int i = 0; i < side * side; ++i) {
        out.text += ' ';
        appendNumber(out.text, values[i]);
      }
      out.text += '\n';
    }
    out.entries += static_cast<int>(blocks.size());
  }
  return out;
}

bool unilateral(double lower, double upper) {
  return lower == 0 && !std::signbit(lower) && upper == infinity;
}

void appendBounds(std::string& text, const Problem& problem) {
  bool standard = true;
  for (int i = 0; i < problem.rows(); ++i) {
    if (!(problem.lower[i] <= problem.upper[i]) || problem.lower[i] == infinity ||
        problem.upper[i] == -infinity)
      throw std::invalid_argument(
          "a problem text needs lower bounds that are not above the upper ones");
    standard = standard && unilateral(problem.lower[i], problem.upper[i]);
  }
  if (standard) return;
  appendLine(text, "bounds");
  for (int i = 0; i < problem.rows(); ++i) {
    appendNumber(text, problem.lower[i]);
    text += ' ';
    appendNumber(text, problem.upper[i]);
    text += '\n';
  }
}

std::string problemText(const Problem& problem) {
  assert(problem.q.size() == problem.size() && problem.W.size() == problem.size() &&
         "W, q, friction and bounds speak of the same unknowns");
  if (problem.contacts() > 0 && problem.rows() > 0)
    throw std::invalid_argument("a problem with both contacts and rows has no text format");
  if (!problem.disks.empty())
    throw std::invalid_argument("a problem with rolling or spinning friction has no text format");
  requireFinite(problem.q, "q");
  requireFinite(problem.friction, "the friction");
  if ((problem.friction.array() < 0).any())
    throw std::invalid_argument("a problem text needs friction coefficients of at least 0");

  const bool contacts = problem.contacts() > 0;
  const MatrixText matrix = matrixText(problem.W, contacts ? 3 : 1);
  std::string text;
  appendLine(text, contacts ? "delassus-problem v1" : "lcp v1");
  appendLine(text, "name " + nameWord(problem.name));
  if (contacts) {
    appendLine(text, "contacts " + std::to_string(problem.contacts()));
    appendLine(text, "blocks " + std::to_string(matrix.entries));
    appendLine(text, "mu");
    appendLines(text, problem.friction, 0, problem.contacts(), 1);
  } else {
    appendLine(text, "size " + std::to_string(problem.rows()));
    appendLine(text, "entries " + std::to_string(matrix.entries));
    appendBounds(text, problem);
  }
  appendLine(text, "q");
  appendLines(text, problem.q, 0, problem.size(), contacts ? 3 : 1);
  appendLine(text, contacts ? "W" : "M");
  text += matrix.text;
  appendLine(text, "end");
  return text;
}

std::string solutionText(const Problem& problem, const Solution& solution) {
  assert(solution.r.size() == problem.size() && solution.u.size() == problem.size() &&
         "the solution belongs to the problem");
  requireFinite(solution.r, "r");
  requireFinite(solution.u, "u");
  std::string text;
  const auto appendVector = [&](const char* letter, const VectorXd& x) {
    appendLine(text, letter);
    appendLines(text, x, 0, 3 * problem.contacts(), 3);
    appendLines(text, x, 3 * problem.contacts(), problem.size(), 1);
  };
  appendLine(text, "solution v1");
  appendLine(text, "name " + nameWord(problem.name));
  appendLine(text, "status " + toString(solution.status));
  appendVector("r", solution.r);
  appendVector("u", solution.u);
  appendLine(text, "end");
  return text;
}

void writeText(std::ostream& out, const std::string& text) {
  out.write(text.data(), static_cast<std::streamsize>(text.size()));
}

}  // namespace

void writeProblem(std::ostream& out, const Problem& problem) {
  writeText(out, problemText(problem));
}

void writeProblem(const std::string& path, const Problem& problem) {
  writeFile(path, problemText(problem));
}

void writeSolution(std::ostream& out, const Problem& problem, const Solution& solution) {
  writeText(out, solutionText(problem, solution));
}

void writeSolution(const std::string& path, const Problem& problem, const Solution& solution) {
  writeFile(path, solutionText(problem, solution));
}

}  // namespace delassus
