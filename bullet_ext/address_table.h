#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace delassus::bullet {

/// Look-up of the index that each object (a body of a group, a manifold, a joint) was given.
/// Nothing depends on the order of addresses.
///
/// Bullet keeps a scratch number in each object, but threads share that of a kinematic body, so it
/// cannot hold the index. Open addressing; allocates only when it grows.
class AddressTable {
 public:
  /// Forgets all objects.
  void clear() {
    ++generation_;
    count_ = 0;
  }

  /// The index of `object`, or null if it has none.
  const int* find(const void* object) const {
    if (slots_.empty()) return nullptr;
    const Slot& slot = slots_[place(object)];
    return slot.generation == generation_ ? &slot.index : nullptr;
  }

  /// Gives an index to an object, and replaces the one that it may have.
  void insert(const void* object, int index) {
    makeRoom(count_ + 1);
    Slot& slot = slots_[place(object)];
    count_ += slot.generation != generation_;
    slot = {object, generation_, index};
  }

  /// Takes the memory that this many objects need.
  void makeRoom(std::size_t objects) {
    if (2 * objects <= slots_.size()) return;
    std::size_t size = 16;
    while (size < 2 * objects) size *= 2;
    std::vector<Slot> old(size);
    old.swap(slots_);
    for (const Slot& slot : old)
      if (slot.generation == generation_) slots_[place(slot.object)] = slot;
  }

  std::size_t bytes() const { return slots_.capacity() * sizeof(Slot); }

 private:
  struct Slot {
    const void* object = nullptr;
    std::uint64_t generation = 0;  ///< the slot is taken if this is the table's own
    int index = 0;
  };

  /// The object's slot, or the free slot where it would be. At least half of the slots are free.
  std::size_t place(const void* object) const {
    const std::size_t mask = slots_.size() - 1;
    // Fibonacci hashing: the golden ratio spreads addresses that differ by multiples of a size.
    std::size_t i = (reinterpret_cast<std::uintptr_t>(object) * 0x9E3779B97F4A7C15u >> 32) & mask;
    while (slots_[i].generation == generation_ && slots_[i].object != object) i = (i + 1) & mask;
    return i;
  }

  std::vector<Slot> slots_;  ///< their number is a power of two
  std::size_t count_ = 0;
  std::uint64_t generation_ = 1;
};

}  // namespace delassus::bullet
