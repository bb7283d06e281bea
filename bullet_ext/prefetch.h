#pragma once

#include <cstddef>

namespace delassus::bullet {

/// Prefetches the memory from `begin` up to `end`, which is read soon. Bullet's pools scatter
/// manifolds and bodies so that no processor predicts their places, and among thousands it would
/// wait for each. Changes no result.
inline void prefetch([[maybe_unused]] const void* begin, [[maybe_unused]] const void* end) {
#if defined(__GNUC__)
  constexpr std::size_t line = 64;  // bytes
  for (auto at = static_cast<const char*>(begin); at < end; at += line) __builtin_prefetch(at);
#endif
}

}  // namespace delassus::bullet
