#pragma once

#include <atomic>
#include <cstdint>
#include <thread>

#include "delassus/quiet_arithmetic.h"

namespace delassus {

/// Threads that a host lends, the caller's among them, to work on one task together.
class Hands {
 public:
  virtual ~Hands() = default;
  virtual int count() const = 0;
  /// Calls work(context, hand) on every hand, 0 ≤ hand < count(), at the same time as far as there
  /// are processors, hand 0 in the caller's thread. Returns when all have ended. `work` must not
  /// throw.
  virtual void together(void (*work)(const void* context, int hand), const void* context) = 0;
  /// The same for work(hand), with no arithmetic that traps, whatever the host's threads do.
  template <class Work>
  void together(const Work& work) {
    together(
        [](const void* of, int hand) {
          const QuietArithmetic quiet;
          (*static_cast<const Work*>(of))(hand);
        },
        &work);
  }
};

/// Waits for what another thread is at work on: not for long, unless it has no processor.
template <class IsOver>
void waitUntil(const IsOver& isOver) {
  constexpr int patience = 2000;
  int looks = 0;
  while (!isOver())
    if (++looks > patience) {
      looks = patience;
      std::this_thread::yield();
    }
}

/// Rounds of shares, one round after the other; hands take the shares. The leader takes shares from
/// the first on, the others from the last on, so that each finds its own data in its cache. The
/// leader waits only for hands that are at work on a share, never for a hand without a processor.
/// All hands can read in one round what any has written in the round before.
class Rounds {
 public:
  /// For the leader: calls work(round, share) for all shares, some of them on other hands, and
  /// returns when all have ended.
  template <class Work>
  void lead(std::uint32_t round, std::uint16_t shares, const Work& work) {
    done_.store(0, std::memory_order_relaxed);
    left_.store(Left{round, 0, shares}, std::memory_order_release);
    int own = 0;
    for (Left left = left_.load(std::memory_order_relaxed); left.begin < left.end;) {
      if (!left_.compare_exchange_weak(left, {round, std::uint16_t(left.begin + 1), left.end},
                                       std::memory_order_acq_rel))
        continue;
      work(round, left.begin);
      ++own;
      left = left_.load(std::memory_order_relaxed);
    }
    waitUntil([&] { return own + done_.load(std::memory_order_acquire) == shares; });
  }

  /// For the others: takes shares of the current round, and of all that follow, until the leader
  /// calls `end`.
  template <class Work>
  void help(const Work& work) {
    for (;;) {
      Left left;
      waitUntil([&] {
        left = left_.load(std::memory_order_acquire);
        return left.begin < left.end || left.round == over;
      });
      if (left.round == over) return;
      if (!left_.compare_exchange_weak(left, {left.round, left.begin, std::uint16_t(left.end - 1)},
                                       std::memory_order_acq_rel))
        continue;
      work(left.round, left.end - 1);
      done_.fetch_add(1, std::memory_order_acq_rel);
    }
  }

  /// For the leader: lets the others return.
  void end() { left_.store(Left{over, 0, 0}, std::memory_order_release); }

 private:
  static constexpr std::uint32_t over = ~std::uint32_t(0);
  struct alignas(8) Left {
    std::uint32_t round = 0;
    std::uint16_t begin = 0, end = 0;  ///< shares that nobody has taken
  };

  alignas(64) std::atomic<Left> left_{Left{}};
  alignas(64) std::atomic<int> done_{0};
};

}  // namespace delassus
