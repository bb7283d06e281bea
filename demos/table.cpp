#include "demos/table.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace demos {

Table::Table(std::vector<std::string> heading) { rows_.push_back(std::move(heading)); }

void Table::add(std::vector<std::string> row) { rows_.push_back(std::move(row)); }

std::string Table::text() const {
  std::vector<std::size_t> width;
  for (const auto& row : rows_) {
    width.resize(std::max(width.size(), row.size()), 0);
    for (std::size_t i = 0; i < row.size(); ++i) width[i] = std::max(width[i], row[i].size());
  }
  std::string text;
  for (const auto& row : rows_) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      text += row[i];
      if (i + 1 < row.size()) text.append(width[i] - row[i].size() + 2, ' ');
    }
    text += '\n';
  }
  return text;
}

std::string shortNumber(double value, int digits) {
  if (std::isnan(value)) return "nan";  // printf may give it a sign
  if (value == 0) return "0";           // and to zero
  char word[32];
  std::snprintf(word, sizeof word, "%.*g", digits, value);
  return word;
}

}  // namespace demos
