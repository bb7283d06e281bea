#pragma once

#include <thread>
#include <vector>

#include "delassus/hands.h"

namespace delassus::test {

/// Hands that are new threads for each task.
class HiredHands final : public Hands {
 public:
  explicit HiredHands(int count) : count_(count) {}
  int count() const override { return count_; }
  using Hands::together;
  void together(void (*work)(const void* context, int hand), const void* context) override {
    ++tasks;
    std::vector<std::thread> others;
    for (int hand = 1; hand < count_; ++hand) others.emplace_back(work, context, hand);
    work(context, 0);
    for (std::thread& other : others) other.join();
  }

  int tasks = 0;

 private:
  int count_;
};

}  // namespace delassus::test
