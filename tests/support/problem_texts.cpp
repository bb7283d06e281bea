#include "tests/support/problem_texts.h"

#include <sstream>

namespace delassus::test {

Problem fromText(const std::string& text) {
  std::istringstream in(text);
  return readProblem(in, "text");
}

std::string toText(const Problem& problem) {
  std::ostringstream out;
  writeProblem(out, problem);
  return out.str();
}

std::string difference(const Problem& a, const Problem& b) {
  const DelassusMatrix::Sparse &A = a.W.entries(), &B = b.W.entries();
  const bool samePlaces = A.rows() == B.rows() && A.nonZeros() == B.nonZeros() &&
                          sameBits(A.outerIndexPtr(), B.outerIndexPtr(), A.rows() + 1) &&
                          sameBits(A.innerIndexPtr(), B.innerIndexPtr(), A.nonZeros());
  std::string parts;
  const auto compare = [&parts](const char* part, bool same) {
    if (!same) parts += (parts.empty() ? "" : ", ") + std::string(part);
  };
  compare("name", a.name == b.name);
  compare("q", sameBits(a.q, b.q));
  compare("friction", sameBits(a.friction, b.friction));
  compare("lower", sameBits(a.lower, b.lower));
  compare("upper", sameBits(a.upper, b.upper));
  compare("places in W", samePlaces);
  compare("W", samePlaces && sameBits(A.valuePtr(), B.valuePtr(), A.nonZeros()));
  return parts;
}

}  // namespace delassus::test
