#pragma once

#include <cstddef>
#include <vector>

#include "delassus/types.h"

namespace delassus {

/// Storage behind the given lists and vectors, in bytes. Storage that their entries own is not
/// counted.
inline std::size_t bytesOf(const VectorXd& vector) { return vector.bytes(); }
inline std::size_t bytesOf(const MatrixXd& matrix) {
  return sizeof(double) * static_cast<std::size_t>(matrix.size());
}
template <class Entry>
std::size_t bytesOf(const std::vector<Entry>& list) {
  return list.capacity() * sizeof(Entry);
}
template <class First, class Second, class... More>
std::size_t bytesOf(const First& first, const Second& second, const More&... more) {
  return bytesOf(first) + bytesOf(second, more...);
}

}  // namespace delassus
