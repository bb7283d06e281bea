#pragma once

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <string>

namespace demos {

/// "what [####      ]  40 %", in less than `columns`: a longer line would wrap, and could not be
/// written over.
inline std::string progressLine(std::string what, double fraction, std::size_t columns) {
  constexpr std::size_t around = 10, widest = 40, least = 8;  // of the bar
  const std::size_t room = std::max(columns, std::size_t(1)) - 1;
  const std::size_t beside = what.size() + around;
  std::size_t width = room > beside + least ? std::min(widest, room - beside) : least;
  if (room < around + least) width = 0;  // no bar, just the name
  const std::size_t forName = width > 0 ? room - width - around : room;
  if (what.size() > forName) {
    std::size_t end = forName;
    while (end > 0 && (what[end] & 0xc0) == 0x80) --end;  // do not cut a letter
    what.resize(end);
  }
  if (width == 0) return what;
  std::string bar(static_cast<std::size_t>(std::clamp(fraction, 0.0, 1.0) * double(width)), '#');
  bar.resize(width, ' ');
  char percent[8];
  std::snprintf(percent, sizeof percent, "%3.0f %%", 100 * std::clamp(fraction, 0.0, 1.0));
  return what + " [" + bar + "] " + percent;
}

/// A line on a terminal's stderr that shows how far a long job is. Nothing is shown in the first
/// two seconds, nor to a file.
class ProgressBar {
 public:
  explicit ProgressBar(std::string what)
      : what_(std::move(what)), terminal_(isatty(STDERR_FILENO) != 0) {}
  ~ProgressBar() { clear(); }
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void show(double fraction) {
    using std::chrono::milliseconds;
    const auto now = std::chrono::steady_clock::now();
    if (!terminal_ || now - start_ < milliseconds(2000) || now - last_ < milliseconds(100)) return;
    last_ = now;
    shown_ = true;
    std::fprintf(stderr, "\r%s", progressLine(what_, fraction, columns()).c_str());
  }

  /// Removes the line; call it before anything is printed while the bar lives.
  void clear() {
    if (shown_) std::fprintf(stderr, "\r\033[K");
    shown_ = false;
  }

 private:
  /// The width of the terminal, which may change while the job runs.
  static std::size_t columns() {
    constexpr std::size_t usual = 80;
    winsize size{};
    const bool known = ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
    return known ? size.ws_col : usual;
  }

  std::string what_;
  bool terminal_;
  bool shown_ = false;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now(), last_;
};

}  // namespace demos
