/// Threads share a list with their caller.
#include "bullet_ext/crew.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cfenv>
#include <chrono>
#include <future>
#include <stdexcept>
#include <vector>

namespace delassus::bullet {
namespace {

const auto alike = [](int) { return 1; };

// The numbers of hands and items vary, so that some hands find nothing to do.
TEST(Crew, DoesEveryItemOnceAndNoHandTwoAtATime) {
  Crew crew;
  EXPECT_EQ(crew.count(), 1);
  for (int hands : {1, 4, 2, 3, 1, 2}) {
    crew.setHands(hands);
    EXPECT_EQ(crew.count(), hands);
    for (int count : {0, 1, 2, 3, 5, 200}) {
      std::vector<int> done(count, 0);
      std::vector<std::atomic<int>> busy(hands);
      const auto weight = [](int i) { return i % 7 == 3 ? 100 : 0; };
      crew.share(count, weight, [&](int hand, int i) {
        EXPECT_EQ(busy[hand]++, 0);
        ++done[i];
        --busy[hand];
      });
      EXPECT_EQ(std::count(done.begin(), done.end(), 1), count) << hands << " hands";
    }
  }
}

// Each of four items waits until all have begun: no fewer than four hands get past them.
TEST(Crew, AllHandsWorkAtTheSameTime) {
  constexpr int hands = 4;
  Crew crew;
  crew.setHands(hands);
  std::atomic<int> begun{0};
  std::promise<void> all;
  const std::shared_future<void> allBegun = all.get_future().share();
  crew.share(hands, alike, [&](int, int) {
    if (++begun == hands) all.set_value();
    EXPECT_EQ(allBegun.wait_for(std::chrono::seconds(20)), std::future_status::ready);
  });
}

// The caller may change its arithmetic after the hands have come.
TEST(Crew, CalculatesAsTheCallerDoes) {
  Crew crew;
  crew.setHands(3);
  const int before = std::fegetround();
  for (const int rounding : {FE_UPWARD, FE_DOWNWARD, before}) {
    std::fesetround(rounding);
    std::atomic<int> same{0};
    crew.together([&](int) { same += std::fegetround() == rounding; });
    EXPECT_EQ(same, 3);
  }
  std::fesetround(before);
}

// In each round every share is done once, by whichever hand takes it. That hand sees what was done
// in the round before.
TEST(Crew, AllHandsTakePartInRounds) {
  constexpr int last = 2000, shares = 5;
  Crew crew;
  for (int hands : {1, 2, 4}) {
    crew.setHands(hands);
    Rounds rounds;
    std::vector<int> done(shares, 0);
    // A hand that does a share twice, or has not seen the last round, makes the count wrong.
    const auto work = [&](int, int share) { ++done[share]; };
    const auto task = [&](int hand) {
      if (hand > 0) return rounds.help(work);
      for (int round = 0; round < last; ++round) {
        rounds.lead(round, shares, work);
        EXPECT_EQ(done, std::vector<int>(shares, round + 1));
      }
      rounds.end();
    };
    crew.together(task);
  }
}

// One item is as heavy as all the others together. It is the part of one hand, and the other hand
// does not wait for it.
TEST(Crew, BeginsWithPartsOfTheSameWeight) {
  constexpr int light = 9;
  Crew crew;
  crew.setHands(2);
  std::promise<void> rest;
  std::atomic<int> left{light};
  const auto weight = [](int i) { return i == light ? light : 1; };
  crew.share(light + 1, weight, [&](int, int i) {
    if (i == light)
      EXPECT_EQ(rest.get_future().wait_for(std::chrono::seconds(20)), std::future_status::ready);
    else if (--left == 0)
      rest.set_value();
  });
}

TEST(Crew, WhatIsThrownReachesTheCallerAndTheNextListIsDone) {
  Crew crew;
  for (int hands : {1, 2, 4}) {
    crew.setHands(hands);
    for (int bad : {0, 7, 19}) {
      const auto fail = [&](int, int i) {
        if (i == bad) throw std::runtime_error("item " + std::to_string(i));
      };
      try {
        crew.share(20, alike, fail);
        ADD_FAILURE() << "nothing was thrown";
      } catch (const std::runtime_error& error) {
        EXPECT_EQ(error.what(), "item " + std::to_string(bad));
      }
      std::atomic<int> done{0};
      crew.share(20, alike, [&](int, int) { ++done; });
      EXPECT_EQ(done, 20);
    }
  }
}

}  // namespace
}  // namespace delassus::bullet
