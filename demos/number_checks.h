#pragma once

#include <cmath>
#include <cstdlib>
#include <string>

namespace demos {

/// The number that the whole of `text` spells; NaN if it spells none.
inline double numberIn(const std::string& text) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  return !text.empty() && *end == '\0' ? value : std::nan("");
}

/// Checks of values on the command line, for CLI11: an empty answer means that the text is good.
inline std::string finiteNumber(const std::string& text) {
  return std::isfinite(numberIn(text)) ? "" : "'" + text + "' is not a finite number";
}
inline std::string finiteFrom(const std::string& text, bool zeroToo) {
  const double value = numberIn(text);
  const bool good = std::isfinite(value) && (zeroToo ? value >= 0 : value > 0);
  return good ? ""
              : "'" + text + "' is not a number " + (zeroToo ? "of at least" : "greater than") +
                    " 0";
}
inline std::string greaterThanZero(const std::string& text) { return finiteFrom(text, false); }
inline std::string atLeastZero(const std::string& text) { return finiteFrom(text, true); }

/// The same for names of files and folders.
inline std::string notEmpty(const std::string& text) { return text.empty() ? "it is empty" : ""; }

}  // namespace demos
