/// Which islands count as heaps, and which as piles.
#include "delassus/pile_kind.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/random_piles.h"
#include "tests/support/sphere_heaps.h"
#include "tests/support/turning_piles.h"

namespace delassus {
namespace {

using namespace delassus::test;

TEST(PileKind, SpheresAreAHeapUnlessJointsPrevail) {
  Random random(77);
  Pile heap = makeSphereHeap(400, 6, 0.5, 0.1, random);
  const PileIsland spheres(heap);
  EXPECT_TRUE(isHeap(spheres.problem));
  EXPECT_TRUE(isLargeHeap(spheres.problem));
  EXPECT_FALSE(isLargeButNoHeap(spheres.problem));
  Row joint;
  const Contact& touching = heap.contacts[spheres.island.frictional[0]];
  joint.a = std::max(touching.a, touching.b);  // one of them may be the world
  joint.jacobianA << 1, 0, 0, 0, 0, 0;
  for (int k = 0; k <= spheres.problem.contacts(); ++k) heap.rows.push_back(joint);
  const PileIsland jointed(heap);
  ASSERT_GT(jointed.problem.rows(), jointed.problem.contacts());
  EXPECT_FALSE(isHeap(jointed.problem));
  EXPECT_TRUE(isLargeButNoHeap(jointed.problem));
}

TEST(PileKind, FewSpheresAreASmallHeap) {
  Random random(77);
  const PileIsland spheres(makeSphereHeap(150, 4.7, 0.5, 0.1, random));
  EXPECT_GT(spheres.problem.contacts(), 200);
  EXPECT_TRUE(isHeap(spheres.problem));
  EXPECT_FALSE(isLargeHeap(spheres.problem));
}

// Disks are no joints. But they make sweeps dear: only large heaps are still heaps with them.
TEST(PileKind, SpheresThatResistRollingAreALargeHeap) {
  Random random(77);
  for (const int spheres : {150, 400}) {
    Pile heap = makeSphereHeap(spheres, spheres < 200 ? 4.7 : 6, 0.5, 0.1, random);
    for (int i = 0; i < static_cast<int>(heap.contacts.size()); ++i)
      addRows(aboutTangents(heap.contacts[i], 0.1, 0.1), heap.contacts[i], i, heap.rows);
    const PileIsland turning(heap);
    ASSERT_GT(turning.problem.rows(), turning.problem.contacts());
    const bool isLarge = turning.problem.contacts() > 600;
    EXPECT_EQ(isLarge, spheres == 400);
    EXPECT_EQ(isHeap(turning.problem), isLarge);
    EXPECT_EQ(isLargeHeap(turning.problem), isLarge);
    EXPECT_EQ(isLargeButNoHeap(turning.problem), !isLarge);
  }
}

// Four contacts for each box make a pile.
TEST(PileKind, BoxesAtRestAreAPile) {
  Random random(78);
  const PileIsland tower(makeTower(randomMasses(60, 10, random), 0, 0.3, random));
  EXPECT_FALSE(isHeap(tower.problem));
  EXPECT_TRUE(isLargeButNoHeap(tower.problem));
}

}  // namespace
}  // namespace delassus
