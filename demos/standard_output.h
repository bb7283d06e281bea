#pragma once

#include <sys/stat.h>
#include <unistd.h>

#include <cstdio>
#include <iostream>
#include <string>

namespace demos {

/// Whether `file` is what standard output goes to, by whatever name (/dev/stdout). Opened once more
/// it would be written from its beginning, over what has been printed or under what will be.
inline bool isStandardOutput(const std::string& file) {
  struct stat named {
  }, standard{};
  return stat(file.c_str(), &named) == 0 && fstat(STDOUT_FILENO, &standard) == 0 &&
         named.st_dev == standard.st_dev && named.st_ino == standard.st_ino;
}

/// Where to print what there is to say about `file`: not into it.
inline std::FILE* wordsAbout(const std::string& file) {
  return isStandardOutput(file) ? stderr : stdout;
}

/// Calls `write` with the name of the file, or with the stream that is standard output.
template <class Write>
void writeTo(const std::string& file, const Write& write) {
  if (isStandardOutput(file))
    write(std::cout);
  else
    write(file);
}

}  // namespace demos
