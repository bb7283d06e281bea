#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace delassus {

/// A list that keeps, when it is cleared, the storage that its entries own: filled again with the
/// like it takes no memory.
template <class Entry>
class KeptList {
 public:
  /// One entry more at the end, as the last one in its place was left.
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
  /// Of the storage, with what each entry owns itself: `owned(entry)`.
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
