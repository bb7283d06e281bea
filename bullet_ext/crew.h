#pragma once

#include <atomic>
#include <condition_variable>
#include <exception>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

namespace delassus::bullet {

/// Threads that go through a list of items together with the caller's. Between lists they are parked: they cost nothing.
///
/// Each hand begins with a part of the list of its own, the same in every call with the same weights, so that it finds in
/// its storage what it left there; who has ended helps the others. Which hand an item falls to is not determined.
class Crew {
 public:
  Crew();
  ~Crew();
  Crew(const Crew&) = delete;
  Crew& operator=(const Crew&) = delete;

  /// One hand is the caller's; each further one is a thread. Throws std::system_error where none is to be had: then the
  /// caller is alone.
  void setHands(int hands);
  int hands() const { return static_cast<int>(threads_.size()) + 1; }

  /// Calls work(hand, item) once for every item below `count`, 0 ≤ hand < hands(), no hand twice at a time. Items with
  /// large weight(item) ≥ 0 count for several. Throws what `work` threw, when all hands have ended.
  template <class Weight, class Work>
  void share(int count, const Weight& weight, const Work& work) {
    double total = 0;
    for (int i = 0; i < count; ++i) total += weight(i);
    double given = 0;
    int item = 0;
    for (int hand = 0; hand < hands(); ++hand) {
      parts_[hand].next = item;
      const double due = total * (hand + 1) / hands();
      // Rounding must leave no item behind.
      while (item < count && (hand + 1 == hands() || given + 0.5 * weight(item) < due))
        given += weight(item++);
      parts_[hand].end = item;
    }
    run([](const void* context, int hand, int i) { (*static_cast<const Work*>(context))(hand, i); },
        &work);
  }

 private:
  using Task = void (*)(const void* context, int hand, int item);
  /// A line of the cache each.
  struct alignas(64) Part {
    std::atomic<int> next{0};
    int end = 0;
    std::exception_ptr error;
  };

  void run(Task task, const void* context);
  void workThrough(int hand);
  void attend(int hand);
  void dismiss();

  std::unique_ptr<Part[]> parts_;  ///< one a hand
  Task task_ = nullptr;
  const void* context_ = nullptr;

  std::vector<std::thread> threads_;
  std::mutex mutex_;  ///< of what follows
  std::condition_variable called_, ended_;
  unsigned calls_ = 0;  ///< lists so far
  int busy_ = 0;        ///< threads that have not ended with the last of them
  bool dismissed_ = false;
};

}  // namespace delassus::bullet
