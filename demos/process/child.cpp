#include "demos/process/child.h"

#include <poll.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <algorithm>
#include <stdexcept>

#include "demos/process/interrupt.h"

namespace demos {

Pipe::Pipe() {
  if (pipe(ends) != 0) throw std::runtime_error("no pipe to a process of its own");
}

void dieWith(pid_t parent, int signal) {
  prctl(PR_SET_PDEATHSIG, signal);
  // The parent may have ended before that.
  if (getppid() != parent) _exit(1);
}

double secondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

bool readAll(int in, double seconds, std::chrono::steady_clock::time_point start,
             std::string& text) {
  char buffer[1 << 16];
  while (true) {
    const double left = seconds - secondsSince(start);
    if (left <= 0 || InterruptWatch::asked()) return false;
    pollfd waiting{in, POLLIN, 0};
    // Short waits, so that Ctrl-C is seen soon.
    const int ready = poll(&waiting, 1, int(std::min(left * 1000 + 1, 200.0)));
    if (ready <= 0) continue;
    const ssize_t size = read(in, buffer, sizeof buffer);
    if (size <= 0) return true;
    text.append(buffer, std::size_t(size));
  }
}

}  // namespace demos
