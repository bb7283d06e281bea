#include "tests/support/shared_data.h"

#include <algorithm>
#include <cstdlib>
#include <system_error>

namespace delassus::test {

std::filesystem::path sharedFolder() {
  std::filesystem::path folder;
  if (const char* named = std::getenv("DELASSUS_SHARED")) folder = named;
  if (folder.empty()) folder = DELASSUS_SHARED_DIR;
  std::error_code ignored;
  return std::filesystem::is_directory(folder, ignored) ? folder : std::filesystem::path();
}

std::vector<std::filesystem::path> sharedFiles(const std::string& subfolder,
                                               const std::vector<std::string>& suffixes) {
  std::vector<std::filesystem::path> files;
  const std::filesystem::path folder = sharedFolder() / subfolder;
  std::error_code ignored;
  if (sharedFolder().empty() || !std::filesystem::is_directory(folder, ignored)) return files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (std::find(suffixes.begin(), suffixes.end(), entry.path().extension()) != suffixes.end())
      files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<std::filesystem::path> sharedProblems() {
  return sharedFiles("problems", {".fc3d", ".lcp"});
}

}  // namespace delassus::test
