#pragma once

#include <LinearMath/btScalar.h>
#include <gtest/gtest.h>

#include <cstring>
#include <vector>

namespace delassus::test {

/// Expects the same numbers, not just equal ones: 0 and −0 differ.
inline void expectSameBits(const std::vector<btScalar>& a, const std::vector<btScalar>& b) {
  ASSERT_EQ(a.size(), b.size());
  EXPECT_EQ(std::memcmp(a.data(), b.data(), a.size() * sizeof(btScalar)), 0);
}

}  // namespace delassus::test
