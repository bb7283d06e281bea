#include "delassus/pile_kind.h"

namespace delassus {
namespace {

constexpr int largeHeap = 600;  ///< contacts; more are a large heap

int rowsThatCount(const Problem& problem) {
  return problem.contacts() > largeHeap ? problem.plainRows() : problem.rows();
}

}  // namespace

bool isHeap(const Problem& problem) {
  constexpr int fewContacts = 20, perBody = 3;
  constexpr int manyContacts = 1000, perBodyOfMany = 6;
  const int n = problem.contacts();
  if (!problem.W.inBodySpace() || n <= fewContacts || rowsThatCount(problem) > n) return false;
  return n <= (n > manyContacts ? perBodyOfMany : perBody) * problem.W.bodySpace().bodies;
}

bool isLargeHeap(const Problem& problem) {
  return isHeap(problem) && problem.contacts() > largeHeap;
}

bool isLargeButNoHeap(const Problem& problem) {
  constexpr int fewParts = 200;
  return !isHeap(problem) && problem.contacts() + rowsThatCount(problem) > fewParts;
}

}  // namespace delassus
