#include "bullet_ext/crew.h"

#include <utility>

#include "delassus/quiet_arithmetic.h"

namespace delassus::bullet {

Crew::Crew() : parts_(std::make_unique<Part[]>(1)) {}

Crew::~Crew() { dismiss(); }

void Crew::dismiss() {
  {
    const std::lock_guard lock(mutex_);
    dismissed_ = true;
  }
  called_.notify_all();
  for (std::thread& thread : threads_) thread.join();
  threads_.clear();
  dismissed_ = false;
  calls_ = 0;
}

void Crew::setHands(int hands) {
  dismiss();
  parts_ = std::make_unique<Part[]>(hands);
  threads_.reserve(hands - 1);
  try {
    for (int hand = 1; hand < hands; ++hand) threads_.emplace_back([this, hand] { attend(hand); });
  } catch (...) {
    dismiss();
    throw;
  }
}

void Crew::attend(int hand) {
  unsigned seen = 0;
  while (true) {
    {
      std::unique_lock lock(mutex_);
      called_.wait(lock, [&] { return dismissed_ || calls_ != seen; });
      if (dismissed_) return;
      seen = calls_;
    }
    std::fesetenv(&arithmetic_);
    const QuietArithmetic quiet;
    takePart(hand);
    const std::lock_guard lock(mutex_);
    if (--busy_ == 0) ended_.notify_one();
  }
}

void Crew::takePart(int hand) {
  try {
    if (job_.together)
      job_.together(job_.context, hand);
    else
      workThrough(hand);
  } catch (...) {
    parts_[hand].error = std::current_exception();
  }
}

void Crew::workThrough(int hand) {
  for (int k = 0; k < count(); ++k) {
    Part& part = parts_[(hand + k) % count()];
    for (int item = part.next++; item < part.end; item = part.next++)
      job_.onItem(job_.context, hand, item);
  }
}

void Crew::run() {
  std::fegetenv(&arithmetic_);
  {
    const std::lock_guard lock(mutex_);
    ++calls_;
    busy_ = count() - 1;
  }
  called_.notify_all();
  takePart(0);
  {
    std::unique_lock lock(mutex_);
    ended_.wait(lock, [this] { return busy_ == 0; });
  }
  std::exception_ptr error;
  for (int hand = count() - 1; hand >= 0; --hand)
    if (std::exception_ptr own = std::exchange(parts_[hand].error, nullptr)) error = own;
  if (error) std::rethrow_exception(error);
}

}  // namespace delassus::bullet
