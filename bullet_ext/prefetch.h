#pragma once

#include <cstddef>

namespace delassus::bullet {

/// Asks for all of an object that is read soon. Bullet's pools put manifolds and bodies where no processor expects them, and
/// where there are thousands it waits for each. Changes no result.
template <class Object>
void prefetch([[maybe_unused]] const Object* object) {
#if defined(__GNUC__)
  constexpr std::size_t line = 64;  // bytes
  const char* begin = reinterpret_cast<const char*>(object);
  for (std::size_t at = 0; at < sizeof(Object); at += line) __builtin_prefetch(begin + at);
#endif
}

}  // namespace delassus::bullet
