#include "delassus/pile_kind.h"

namespace delassus {

bool isHeap(const Problem& problem) {
  constexpr int fewContacts = 20, perBody = 3;
  return problem.W.inBodySpace() && problem.contacts() > fewContacts &&
         problem.contacts() <= perBody * problem.W.bodySpace().bodies;
}

bool isLargePile(const Problem& problem) {
  constexpr int fewParts = 200;
  return !isHeap(problem) && problem.contacts() + problem.rows() > fewParts;
}

}  // namespace delassus
