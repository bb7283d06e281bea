#pragma once

#include <sys/types.h>

#include <chrono>
#include <string>

namespace demos {

/// A pipe from a child, which writes to ends[1], to this process, which reads from ends[0]. Throws
/// std::runtime_error if the system gives none.
struct Pipe {
  int ends[2];
  Pipe();
};

/// Call it in a process that was just started: the process gets `signal` when its parent ends, in
/// whatever way.
void dieWith(pid_t parent, int signal);

double secondsSince(std::chrono::steady_clock::time_point start);

/// Appends to `text` what comes from `in`. Returns false if the input has not ended `seconds` after
/// `start`, or when the user asks to stop.
bool readAll(int in, double seconds, std::chrono::steady_clock::time_point start,
             std::string& text);

}  // namespace demos
