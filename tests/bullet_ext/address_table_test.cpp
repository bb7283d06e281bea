/// Objects are found by their addresses, however many there are.
#include "bullet_ext/address_table.h"

#include <gtest/gtest.h>

#include <vector>

namespace delassus::bullet {
namespace {

constexpr int count = 1000;

TEST(AddressTable, FindsAllItHasBeenGivenAndNothingElse) {
  // Addresses in steps of many sizes, which share their last digits.
  for (const std::size_t size : {1, 8, 48, 64, 4096}) {
    const std::vector<char> objects(2 * count * size);
    AddressTable table;
    for (int i = 0; i < count; ++i) table.insert(&objects[2 * i * size], i);
    for (int i = 0; i < count; ++i) {
      const int* index = table.find(&objects[2 * i * size]);
      ASSERT_TRUE(index) << size;
      EXPECT_EQ(*index, i);
      EXPECT_FALSE(table.find(&objects[(2 * i + 1) * size]));
    }
  }
}

TEST(AddressTable, TheLastIndexOfAnObjectCounts) {
  const int object = 0, other = 0;
  AddressTable table;
  EXPECT_FALSE(table.find(&object));
  table.insert(&object, 1);
  table.insert(&other, 2);
  table.insert(&object, 3);
  EXPECT_EQ(*table.find(&object), 3);
  EXPECT_EQ(*table.find(&other), 2);
}

TEST(AddressTable, ForgetsAllAndTakesNoNewMemory) {
  const std::vector<int> objects(count);
  AddressTable table;
  for (int i = 0; i < count; ++i) table.insert(&objects[i], i);
  const std::size_t bytes = table.bytes();
  for (int round = 0; round < 3; ++round) {
    table.clear();
    for (const int& object : objects) ASSERT_FALSE(table.find(&object));
    for (int i = 0; i < count; ++i) table.insert(&objects[i], i + round);
    for (int i = 0; i < count; ++i) ASSERT_EQ(*table.find(&objects[i]), i + round);
  }
  EXPECT_EQ(table.bytes(), bytes);
}

}  // namespace
}  // namespace delassus::bullet
