#pragma once

#include <cstddef>

namespace delassus::bullet {

/// Asks for memory that is read soon, from `begin` up to `end`. Bullet's pools put manifolds and
/// bodies where no processor expects them, and where there are thousands it waits for each. Changes
/// no result.
inline void prefetch([[maybe_unused]] const void* begin, [[maybe_unused]] const void* end) {
#if defined(__GNUC__)
  constexpr std::size_t line = 64;  // bytes
  for (auto at = static_cast<const char*>(begin); at < end; at += line) __builtin_prefetch(at);
#endif
}

}  // namespace delassus::bullet
