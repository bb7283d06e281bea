#pragma once

#include <filesystem>
#include <string>

namespace delassus {

/// Writes `text` completely or not at all: a file of that name keeps what it has until the new text
/// is complete. Pipes and devices are written as they are. Throws std::runtime_error that names the
/// file and the reason.
void writeFile(const std::filesystem::path& file, const std::string& text);

}  // namespace delassus
