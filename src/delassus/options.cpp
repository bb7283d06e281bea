#include "delassus/options.h"

#include <cmath>
#include <stdexcept>
#include <string>

namespace delassus {

void check(const Options& options) {
  const auto refuse = [](const char* what, double number) {
    throw std::invalid_argument("delassus::Options: " + std::string(what) + ", not " +
                                std::to_string(number));
  };
  if (!(options.tolerance > 0 && std::isfinite(options.tolerance)))
    refuse("tolerance must be a number > 0", options.tolerance);
  if (!(options.guessShare > 0 && options.guessShare <= 1))
    refuse("guessShare must be > 0 and no more than 1", options.guessShare);
}

}  // namespace delassus
