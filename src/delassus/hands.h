#pragma once

#include <atomic>
#include <cstdint>
#include <thread>

namespace delassus {

/// Threads that a host lends, the caller's among them: for one thing on which all work at once.
class Hands {
 public:
  virtual ~Hands() = default;
  virtual int count() const = 0;
  /// Calls work(context, hand) on every hand, 0 ≤ hand < count(), side by side as far as there are
  /// processors for them, hand 0 in the caller's thread. Returns when all have ended. `work` must
  /// not throw.
  virtual void together(void (*work)(const void* context, int hand), const void* context) = 0;
};

/// One round after the other of shares that hands take. One of them leads: it begins with the first
/// share, the others with the last, so that each finds in its cache what it left there. The leader
/// waits for nobody but those who are at work on a share: who has no processor is not missed. What
/// was written in one round, all read in the next.
class Rounds {
 public:
  /// Calls work(round, share) for all shares, some of them on other hands, and returns when all
  /// have ended. For the leader.
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
    wait([&] { return own + done_.load(std::memory_order_acquire) == shares; });
  }

  /// Takes shares of whatever round there is until the leader ends it.
  template <class Work>
  void help(const Work& work) {
    for (;;) {
      Left left;
      wait([&] {
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

  /// For the leader: sends the others home.
  void end() { left_.store(Left{over, 0, 0}, std::memory_order_release); }

 private:
  static constexpr std::uint32_t over = ~std::uint32_t(0);
  struct alignas(8) Left {
    std::uint32_t round = 0;
    std::uint16_t begin = 0, end = 0;  ///< of the shares that nobody has taken
  };

  template <class IsOver>
  static void wait(const IsOver& isOver) {
    // What is waited for takes some microseconds, unless it has no processor.
    constexpr int patience = 2000;
    for (int looks = 0; !isOver(); ++looks)
      if (looks > patience) std::this_thread::yield();
  }

  alignas(64) std::atomic<Left> left_{Left{}};
  alignas(64) std::atomic<int> done_{0};
};

}  // namespace delassus
