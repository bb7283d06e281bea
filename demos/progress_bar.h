#pragma once

#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <string>

namespace demos {

/// A line on a terminal's stderr that shows how far a long job is. Nothing is shown in the first two seconds, nor to a file.
class ProgressBar {
 public:
  explicit ProgressBar(std::string what)
      : what_(std::move(what)), terminal_(isatty(STDERR_FILENO) != 0) {}
  ~ProgressBar() {
    if (shown_) std::fprintf(stderr, "\r\033[K");
  }
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void show(double fraction) {
    using std::chrono::milliseconds;
    const auto now = std::chrono::steady_clock::now();
    if (!terminal_ || now - start_ < milliseconds(2000) || now - last_ < milliseconds(100)) return;
    last_ = now;
    shown_ = true;
    constexpr int width = 40;
    const std::string bar(static_cast<std::size_t>(fraction * width), '#');
    std::fprintf(stderr, "\r%s [%-*s] %3.0f %%", what_.c_str(), width, bar.c_str(), 100 * fraction);
  }

 private:
  std::string what_;
  bool terminal_;
  bool shown_ = false;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now(), last_;
};

}  // namespace demos
