#pragma once
/// Finds the problem files and worlds that tests read but the repository does not hold.

#include <filesystem>
#include <string>
#include <vector>

namespace delassus::test {

/// The folder with problems/ and worlds/: environment variable DELASSUS_SHARED, or else the one
/// given when the tests were built. Empty if there is none.
std::filesystem::path sharedFolder();

/// What a test says that skips because there is no such folder.
inline constexpr const char* noSharedFolder =
    "No folder with problem files: set DELASSUS_SHARED to the one that holds problems/ and "
    "worlds/.";

/// The files of `subfolder` with one of the suffixes (".fc3d", ".lcp"), in the order of their
/// names.
std::vector<std::filesystem::path> sharedFiles(const std::string& subfolder,
                                               const std::vector<std::string>& suffixes);

std::vector<std::filesystem::path> sharedProblems();

}  // namespace delassus::test
