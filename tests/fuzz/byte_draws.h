#pragma once
/// Random numbers drawn from the bytes of an input: to change a byte is to change a choice.

#include <cstdint>
#include <random>
#include <string>

#include "tests/fuzz/fuzz.h"

namespace delassus::test {

class ByteDraws {
 public:
  explicit ByteDraws(std::string bytes) : bytes_(std::move(bytes)) {}

  /// The next byte; past the end those of a generator that always begins alike.
  std::uint8_t byte() {
    if (at_ < bytes_.size()) return static_cast<std::uint8_t>(bytes_[at_++]);
    return static_cast<std::uint8_t>(pastEnd_() >> 8);
  }

 private:
  std::string bytes_;
  std::size_t at_ = 0;
  std::minstd_rand pastEnd_;
};

inline double uniform(ByteDraws& draws, double from, double to) {
  std::uint32_t number = 0;
  for (int i = 0; i < 4; ++i) number = number << 8 | draws.byte();
  return from + (to - from) * (number / 4294967296.0);
}
/// From at most 256 numbers.
inline int pick(ByteDraws& draws, int from, int to) {
  return from + draws.byte() % (to - from + 1);
}
inline bool chance(ByteDraws& draws, double p) { return draws.byte() < 256 * p; }
/// 10^x, x uniform.
inline double decades(ByteDraws& draws, double from, double to) {
  return std::pow(10.0, uniform(draws, from, to));
}

}  // namespace delassus::test
