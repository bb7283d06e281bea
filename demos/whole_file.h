#pragma once

#include <filesystem>
#include <string>

namespace demos {

/// Writes `text` completely or not at all: a file of that name is always complete. Throws
/// std::runtime_error that names the file.
void writeFile(const std::filesystem::path& file, const std::string& text);
/// The whole contents. Throws std::runtime_error that names the file.
std::string readFile(const std::filesystem::path& file);

}  // namespace demos
