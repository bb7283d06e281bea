#pragma once
/// Finds the problem files and worlds that tests read but the repository does not hold.

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

namespace delassus::test {

/// The folder with problems/ and worlds/: environment variable DELASSUS_SHARED, else the one given when the tests were
/// built. Empty if there is none.
inline std::filesystem::path sharedFolder() {
  std::filesystem::path folder;
  if (const char* named = std::getenv("DELASSUS_SHARED")) folder = named;
#ifdef DELASSUS_SHARED_DIR
  if (folder.empty()) folder = DELASSUS_SHARED_DIR;
#endif
  std::error_code ignored;
  return std::filesystem::is_directory(folder, ignored) ? folder : std::filesystem::path();
}

/// What a test that skips for want of the folder says.
inline constexpr const char* noSharedFolder =
    "No folder with problem files: set DELASSUS_SHARED to the one that holds problems/ and "
    "worlds/.";

/// The files of `subfolder` with one of the suffixes (".fc3d", ".lcp"), in the order of their names.
inline std::vector<std::filesystem::path> sharedFiles(const std::string& subfolder,
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

inline std::vector<std::filesystem::path> sharedProblems() {
  return sharedFiles("problems", {".fc3d", ".lcp"});
}

}  // namespace delassus::test
