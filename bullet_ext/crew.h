#pragma once

#include <atomic>
#include <cfenv>
#include <condition_variable>
#include <exception>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "delassus/hands.h"

namespace delassus::bullet {

/// Threads that go through a list of items together with the caller's thread, or all work on one
/// job. Between calls they are parked and cost nothing. They calculate as the caller does: with its
/// rounding and its treatment of tiny numbers.
///
/// Each hand begins with its own part of the list. With the same weights that part is the same in
/// every call, so that a hand finds in its storage what it left there. A hand that has finished
/// helps the others. Which hand takes an item is not determined.
class Crew final : public Hands {
 public:
  Crew();
  ~Crew() override;
  Crew(const Crew&) = delete;
  Crew& operator=(const Crew&) = delete;

  /// Sets the number of hands: one is the caller's, each further one is a thread. Throws
  /// std::system_error where no thread is to be had: then the caller is alone.
  void setHands(int hands);
  int count() const override { return static_cast<int>(threads_.size()) + 1; }

  /// Calls work(hand, item) once for every item below `items`, 0 ≤ hand < count(), and no hand
  /// twice at a time. An item with a large weight(item) ≥ 0 counts for several. If `work` throws,
  /// throws the same once all hands have ended.
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
  using Hands::together;
  void together(void (*work)(const void* context, int hand), const void* context) override {
    job_ = {context, nullptr, work};
    run();
  }

 private:
  struct Job {
    const void* context = nullptr;
    void (*onItem)(const void* context, int hand, int item) = nullptr;
    void (*together)(const void* context, int hand) = nullptr;  ///< in place of items, once a hand
  };
  /// Each on a cache line of its own.
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
  std::fenv_t arithmetic_ = {};  ///< of the caller

  std::vector<std::thread> threads_;
  std::mutex mutex_;  ///< guards the members below
  std::condition_variable called_, ended_;
  unsigned calls_ = 0;  ///< jobs so far
  int busy_ = 0;        ///< threads that have not yet ended the last job
  bool dismissed_ = false;
};

}  // namespace delassus::bullet
