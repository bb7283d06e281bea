#pragma once

#include <sys/types.h>

#include <chrono>
#include <string>

namespace demos {

/// What a child writes and this process reads: ends[1] and ends[0]. Throws std::runtime_error if
/// the system gives none.
struct Pipe {
  int ends[2];
  Pipe();
};

/// In a process that was just started: it gets `signal` when its parent ends, in whatever way.
void dieWith(pid_t parent, int signal);

double secondsSince(std::chrono::steady_clock::time_point start);

/// Adds to `text` what comes from `in`. False if that has no end within `seconds` of `start`, or
/// until the user asks to stop.
bool readAll(int in, double seconds, std::chrono::steady_clock::time_point start,
             std::string& text);

}  // namespace demos
