#include "delassus/solution.h"

namespace delassus {

std::string toString(Status status) {
  switch (status) {
    case Status::Solved:
      return "solved";
    case Status::OutOfBudget:
      return "out_of_budget";
    case Status::Incompatible:
      return "incompatible";
    case Status::NonFinite:
      return "non_finite";
  }
  return "unknown";  // unreachable for the values above; keeps the function total
}

}  // namespace delassus
