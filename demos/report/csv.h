#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace demos::report {

/// Rows of words and numbers under a heading: the contents of one CSV file.
class CsvTable {
 public:
  explicit CsvTable(std::vector<std::string> columns) : columns_(std::move(columns)) {}

  void add(std::vector<std::string> row);
  int rows() const { return int(rows_.size()); }
  /// The word in that column; throws std::out_of_range for a column that does not exist.
  const std::string& text(int row, const std::string& column) const;
  /// The same as a number; NaN if it is none.
  double number(int row, const std::string& column) const;

  /// As writeFile.
  void write(const std::filesystem::path& file) const;
  static CsvTable read(const std::filesystem::path& file);

 private:
  std::vector<std::string> columns_;
  std::vector<std::vector<std::string>> rows_;
};

/// A number as CSV files keep it, with nine digits: half of a double's, and more than any measure
/// here is good for.
std::string csvNumber(double value);

}  // namespace demos::report
