#include "demos/report/csv.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "delassus/whole_file.h"
#include "demos/report/read_file.h"

namespace demos::report {

namespace {

std::string quoted(const std::string& word) {
  if (word.find_first_of(",\"\n") == std::string::npos) return word;
  std::string text = "\"";
  for (const char c : word) text += c == '"' ? "\"\"" : std::string(1, c);
  return text + '"';
}

std::string joined(const std::vector<std::string>& words) {
  std::string line;
  for (std::size_t i = 0; i < words.size(); ++i) line += (i == 0 ? "" : ",") + quoted(words[i]);
  return line + '\n';
}

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> words(1);
  bool inQuotes = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"') {
      // Two quotes within quotes stand for one.
      if (inQuotes && i + 1 < line.size() && line[i + 1] == '"')
        words.back() += line[++i];
      else
        inQuotes = !inQuotes;
    } else if (line[i] == ',' && !inQuotes) {
      words.emplace_back();
    } else {
      words.back() += line[i];
    }
  }
  return words;
}

}  // namespace

void CsvTable::add(std::vector<std::string> row) {
  if (row.size() != columns_.size()) throw std::logic_error("a row as long as the heading");
  rows_.push_back(std::move(row));
}

const std::string& CsvTable::text(int row, const std::string& column) const {
  const auto found = std::find(columns_.begin(), columns_.end(), column);
  if (found == columns_.end()) throw std::out_of_range("no column '" + column + "'");
  return rows_.at(std::size_t(row))[std::size_t(found - columns_.begin())];
}

double CsvTable::number(int row, const std::string& column) const {
  const std::string& word = text(row, column);
  char* end = nullptr;
  const double value = std::strtod(word.c_str(), &end);
  const bool good = !word.empty() && *end == '\0';
  return good ? value : std::numeric_limits<double>::quiet_NaN();
}

void CsvTable::write(const std::filesystem::path& file) const {
  std::string text = joined(columns_);
  for (const auto& row : rows_) text += joined(row);
  delassus::writeFile(file, text);
}

CsvTable CsvTable::read(const std::filesystem::path& file) {
  std::istringstream text(readFile(file));
  std::string line;
  std::getline(text, line);
  CsvTable table(split(line));
  while (std::getline(text, line)) {
    std::vector<std::string> row = split(line);
    if (row.size() != table.columns_.size())
      throw std::runtime_error(file.string() + ": this line does not have " +
                               std::to_string(table.columns_.size()) + " cells: " + line +
                               "; delete the file to have it made anew");
    table.rows_.push_back(std::move(row));
  }
  return table;
}

std::string csvNumber(double value) {
  char word[32];
  std::snprintf(word, sizeof word, "%.9g", value);
  return word;
}

}  // namespace demos::report
