#include "delassus/options.h"

#include <stdexcept>
#include <string>

namespace delassus {

void check(const Options& options) {
  const auto refuse = [](const char* what, double number) {
    throw std::invalid_argument("delassus::Options: " + std::string(what) + ", not " +
                                std::to_string(number));
  };
  if (!(options.tolerance > 0 && options.tolerance < 1))
    refuse("tolerance must be > 0 and < 1", options.tolerance);
  if (!(options.guessShare > 0 && options.guessShare <= 1))
    refuse("guessShare must be > 0 and no more than 1", options.guessShare);
}

}  // namespace delassus
