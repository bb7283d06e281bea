#pragma once

#include <string>
#include <vector>

namespace demos::report {

/// What one method reaches in which time. Which unit the cost is in, and what the error is of, its
/// owner knows.
struct Effort {
  std::string method, family;
  double cost, costLow, costHigh;
  double error;
};

/// Those that no other beats in both cost and error, by rising cost.
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
  const Effort* own;  ///< the cheapest of the family that is as good, or null if none is
};

/// Where the curve of `family` is not on or below the others', for errors below `error`. Every
/// corner of the others' front is looked at; between them nothing changes for the worse. Costs
/// whose spreads overlap are equal.
std::vector<Defeat> defeats(const std::vector<Effort>& efforts, const std::string& family,
                            double error);

}  // namespace demos::report
