#pragma once

#include <string>
#include <vector>

namespace demos {

/// Rows of words under a heading, in columns as wide as their widest word.
class Table {
 public:
  explicit Table(std::vector<std::string> heading);
  void add(std::vector<std::string> row);
  std::string text() const;

 private:
  std::vector<std::vector<std::string>> rows_;
};

/// `value` with `digits` significant digits.
std::string shortNumber(double value, int digits = 3);

}  // namespace demos
