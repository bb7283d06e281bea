#include "delassus/pile_kind.h"

namespace delassus {

bool isHeap(const Problem& problem) {
  constexpr int fewContacts = 20, perBody = 3;
  constexpr int manyContacts = 1000, perBodyOfMany = 6;
  const int n = problem.contacts();
  if (!problem.W.inBodySpace() || n <= fewContacts || problem.rows() > n) return false;
  return n <= (n > manyContacts ? perBodyOfMany : perBody) * problem.W.bodySpace().bodies;
}

bool isLargeHeap(const Problem& problem) {
  constexpr int fewContacts = 600;
  return isHeap(problem) && problem.contacts() > fewContacts;
}

bool isLargeButNoHeap(const Problem& problem) {
  constexpr int fewParts = 200;
  return !isHeap(problem) && problem.parts() > fewParts;
}

}  // namespace delassus
