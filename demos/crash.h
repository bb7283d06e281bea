#pragma once

#include <string>

namespace demos {

/// From now on a crash of this process is one line on standard error, which names `file`, and exit
/// status 1: a damaged file may have led Bullet's importer to write into any memory, and what that
/// breaks may break later.
void blameCrashesOn(const std::string& file);

/// While one lives, a crash of this process is `line` on standard error, after `finished` on
/// standard output, and exit status 1; afterwards what it was before.
class CrashBlame {
 public:
  explicit CrashBlame(const std::string& line, std::string finished = "");
  ~CrashBlame();
  CrashBlame(const CrashBlame&) = delete;
  CrashBlame& operator=(const CrashBlame&) = delete;

 private:
  std::string before_, finished_;
};

}  // namespace demos
