#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace delassus {

/// A list whose entries keep their own storage when the list is cleared: to fill it again with
/// similar entries takes no memory.
template <class Entry>
class KeptList {
 public:
  /// Adds an entry at the end. It still has the contents of an earlier one in its place.
  Entry& add() {
    if (size_ == entries_.size()) entries_.emplace_back();
    return entries_[size_++];
  }
  void push_back(Entry entry) { add() = std::move(entry); }
  void clear() { size_ = 0; }
  void pop_back() { --size_; }

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  Entry& operator[](std::size_t i) { return entries_[i]; }
  const Entry& operator[](std::size_t i) const { return entries_[i]; }
  const Entry* data() const { return entries_.data(); }
  const Entry* begin() const { return data(); }
  const Entry* end() const { return begin() + size_; }
  /// Size of the storage, with that of each entry, `owned(entry)`.
  template <class Owned>
  std::size_t bytes(Owned owned) const {
    std::size_t sum = entries_.capacity() * sizeof(Entry);
    for (const Entry& entry : entries_) sum += owned(entry);
    return sum;
  }

 private:
  std::vector<Entry> entries_;
  std::size_t size_ = 0;
};

}  // namespace delassus
