#pragma once

#include <string>

namespace demos {

/// From now on a crash of this process prints one line on standard error, which names `file`, and
/// ends with exit status 1. A damaged file may have made Bullet's importer write into any memory,
/// and the damage may break something only later.
void blameCrashesOn(const std::string& file);

/// While one lives, a crash of this process prints `finished` on standard output and `line` on
/// standard error, and ends with exit status 1. Afterwards crashes are handled as before.
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
