#pragma once

#include <string>
#include <vector>

#include "tests/peers/comparison.h"

namespace delassus::peers {

/// What is compared, how, and by which command.
std::string prefaceOfFiles();
std::string prefaceOfPiles();

/// The comparisons as a table of Markdown, line by line, so that one can watch it grow.
std::string tableHeading(int peers);
std::string tableRow(const Comparison& comparison);

/// How many problems we solved, how many of them faster, and by how much.
std::string summary(const std::vector<Comparison>& comparisons, const Conditions& conditions);

}  // namespace delassus::peers
