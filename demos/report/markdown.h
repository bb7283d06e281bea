#pragma once

#include <string>
#include <vector>

namespace demos::report {

/// A table of Markdown; all columns but the first are set to the right.
class MarkdownTable {
 public:
  explicit MarkdownTable(const std::vector<std::string>& heading);
  void add(const std::vector<std::string>& row);
  std::string text() const { return text_ + '\n'; }

 private:
  std::string text_;
};

/// "![alt](folder/name.svg)", with a line feed.
std::string picture(const std::string& folder, const std::string& name, const std::string& alt);

/// A method's name as code.
std::string code(const std::string& name);

/// Two significant digits, never as a power: 0.012, 3.4, 120.
std::string shortMs(double milliseconds);

}  // namespace demos::report
