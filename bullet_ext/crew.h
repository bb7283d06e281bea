#pragma once

#include <atomic>
#include <condition_variable>
#include <exception>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "delassus/hands.h"

namespace delassus::bullet {

/// Threads that go through a list of items together with the caller's, or work all at one. Between
/// calls they are parked: they cost nothing.
///
/// Each hand begins with a part of the list of its own, the same in every call with the same
/// weights, so that it finds in its storage what it left there; who has ended helps the others.
/// Which hand an item falls to is not determined.
class Crew final : public Hands {
 public:
  Crew();
  ~Crew() override;
  Crew(const Crew&) = delete;
  Crew& operator=(const Crew&) = delete;

  /// One hand is the caller's; each further one is a thread. Throws std::system_error where none is
  /// to be had: then the caller is alone.
  void setHands(int hands);
  int count() const override { return static_cast<int>(threads_.size()) + 1; }

  /// Calls work(hand, item) once for every item below `items`, 0 ≤ hand < count(), no hand twice at
  /// a time. Items with large weight(item) ≥ 0 count for several. Throws what `work` threw, when
  /// all hands have ended.
  template <class Weight, class Work>
  void share(int items, const Weight& weight, const Work& work) {
    double total = 0;
    for (int i = 0; i < items; ++i) total += weight(i);
    double given = 0;
    int item = 0;
    for (int hand = 0; hand < count(); ++hand) {
      parts_[hand].next = item;
      const double due = total * (hand + 1) / count();
      // Rounding must leave no item behind.
      while (item < items && (hand + 1 == count() || given + 0.5 * weight(item) < due))
        given += weight(item++);
      parts_[hand].end = item;
    }
    job_ = {&work, [](const void* context, int hand, int i) {
              (*static_cast<const Work*>(context))(hand, i);
            }};
    run();
  }
  void together(void (*work)(const void* context, int hand), const void* context) override {
    job_ = {context, nullptr, work};
    run();
  }

 private:
  struct Job {
    const void* context = nullptr;
    void (*onItem)(const void* context, int hand, int item) = nullptr;
    void (*together)(const void* context, int hand) = nullptr;  ///< instead of items, once a hand
  };
  /// A line of the cache each.
  struct alignas(64) Part {
    std::atomic<int> next{0};
    int end = 0;
    std::exception_ptr error;
  };

  void run();
  void takePart(int hand);
  void workThrough(int hand);
  void attend(int hand);
  void dismiss();

  std::unique_ptr<Part[]> parts_;  ///< one a hand
  Job job_;

  std::vector<std::thread> threads_;
  std::mutex mutex_;  ///< of what follows
  std::condition_variable called_, ended_;
  unsigned calls_ = 0;  ///< jobs so far
  int busy_ = 0;        ///< threads that have not ended with the last of them
  bool dismissed_ = false;
};

}  // namespace delassus::bullet
