#pragma once

#include <string>

namespace demos {

/// From now on a crash of this process is one line on standard error, which names `file`, and exit
/// status 1: a damaged file may have led Bullet's importer to write into any memory, and what that
/// breaks may break later.
void blameCrashesOn(const std::string& file);

}  // namespace demos
