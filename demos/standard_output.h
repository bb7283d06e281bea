#pragma once

#include <sys/stat.h>
#include <unistd.h>

#include <cstdio>
#include <iostream>
#include <string>

namespace demos {

/// Whether standard output goes to `file`, by whatever name (/dev/stdout). If the file were opened
/// again, it would be written from its beginning, over earlier output or under later output.
inline bool isStandardOutput(const std::string& file) {
  struct stat named {
  }, standard{};
  return stat(file.c_str(), &named) == 0 && fstat(STDOUT_FILENO, &standard) == 0 &&
         named.st_dev == standard.st_dev && named.st_ino == standard.st_ino;
}

/// The stream for messages about `file`: never the file itself.
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
