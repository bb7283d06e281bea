#include "demos/report/markdown.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace demos::report {

MarkdownTable::MarkdownTable(const std::vector<std::string>& heading) {
  add(heading);
  text_ += "|---|";
  for (std::size_t i = 1; i < heading.size(); ++i) text_ += "--:|";
  text_ += '\n';
}

void MarkdownTable::add(const std::vector<std::string>& row) {
  text_ += '|';
  for (const std::string& cell : row) text_ += ' ' + cell + " |";
  text_ += '\n';
}

std::string picture(const std::string& folder, const std::string& name, const std::string& alt) {
  return "![" + alt + "](" + folder + "/" + name + ".svg)\n\n";
}

std::string code(const std::string& name) { return "`" + name + "`"; }

std::string shortMs(double milliseconds) {
  if (!(milliseconds > 0)) return "0";
  // So many digits after the point that two digits count.
  const int digits = std::clamp(1 - int(std::floor(std::log10(milliseconds))), 0, 5);
  char word[32];
  std::snprintf(word, sizeof word, "%.*f", digits, milliseconds);
  return word;
}

}  // namespace demos::report
