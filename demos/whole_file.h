#pragma once

#include <filesystem>
#include <string>

namespace demos {

/// Writes `text`, whole or not at all: a file of that name is a complete one. Throws
/// std::runtime_error that names the file.
void writeFile(const std::filesystem::path& file, const std::string& text);
/// All of it. Throws std::runtime_error that names the file.
std::string readFile(const std::filesystem::path& file);

}  // namespace demos
