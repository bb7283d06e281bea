#pragma once

#include <cstddef>

namespace delassus::bullet {

/// Makes room for `count()` items in lists that have none, as in a first step. Lists that grew bit
/// by bit would use twice as much memory on the way. Later steps rarely need more room than the
/// last step did, so for them nothing is counted.
template <class Count, class List, class... Lists>
void makeFirstRoom(const Count& count, List& list, Lists&... lists) {
  if (list.capacity() > 0) return;
  const auto room = static_cast<std::size_t>(count());
  list.reserve(room);
  (lists.reserve(room), ...);
}

}  // namespace delassus::bullet
