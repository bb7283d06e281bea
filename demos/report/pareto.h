#pragma once

#include <string>
#include <vector>

namespace demos::report {

/// One method's cost and error. Its owner knows the unit of the cost and the meaning of the error.
struct Effort {
  std::string method, family;
  double cost, costLow, costHigh;
  double error;
};

/// The efforts that no other beats in both cost and error, by rising cost.
std::vector<Effort> front(std::vector<Effort> efforts);

std::vector<Effort> ofFamily(const std::vector<Effort>& efforts, const std::string& family);
std::vector<Effort> ofOthers(const std::vector<Effort>& efforts, const std::string& family);
/// The families in the order of their first appearance.
std::vector<std::string> families(const std::vector<Effort>& efforts);

/// The cheapest one whose error is not above `error`, or null.
const Effort* cheapest(const std::vector<Effort>& efforts, double error);

/// A place where another method is cheaper than all of `family`.
struct Defeat {
  Effort rival;
  const Effort* own;  ///< the cheapest of the family that is as good, or null
};

/// Where the curve of `family` is above those of the others, for errors below `error`. Looks at
/// every corner of the others' front; between corners it gets no worse. Costs whose spreads overlap
/// are equal.
std::vector<Defeat> defeats(const std::vector<Effort>& efforts, const std::string& family,
                            double error);

}  // namespace demos::report
