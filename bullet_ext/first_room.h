#pragma once

#include <cstddef>

namespace delassus::bullet {

/// Makes room for `count()` items in lists that have none, those of a first step: its memory is all
/// to be found yet, and lists that grow would go through twice as much of it. Later steps rarely
/// need more than the last did, and do not count.
template <class Count, class List, class... Lists>
void makeFirstRoom(const Count& count, List& list, Lists&... lists) {
  if (list.capacity() > 0) return;
  const auto room = static_cast<std::size_t>(count());
  list.reserve(room);
  (lists.reserve(room), ...);
}

}  // namespace delassus::bullet
