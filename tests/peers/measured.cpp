#include "tests/peers/measured.h"

#include <algorithm>
#include <ctime>

#include "delassus/residual.h"

namespace delassus::peers {

namespace {

using demos::Ending;

/// Counts the processor time of this process: other work on the machine interrupts long solves more
/// often than short ones.
class Stopwatch {
 public:
  double seconds() const { return now() - start_; }

 private:
  static double now() {
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
  }

  double start_ = now();
};

/// Seconds of one solve: the mean of a few that are made ready first and then run one after the
/// other. Asking for the time takes as long as the shortest of them.
double timeBatch(const Problem& problem, const Contestant& contestant, int count) {
  std::vector<Attempt> attempts;
  attempts.reserve(std::size_t(count));
  for (int i = 0; i < count; ++i) attempts.push_back(contestant(problem));
  const Stopwatch watch;
  for (const Attempt& attempt : attempts) attempt.run();
  return watch.seconds() / count;
}

std::vector<double> timeRepeats(const Problem& problem, const Contestant& contestant,
                                double repeatFor) {
  constexpr double batchSeconds = 1e-4;
  constexpr int largestBatch = 50;
  const Stopwatch watch;
  // The first solve after the judged one may still wait for code to be loaded.
  timeBatch(problem, contestant, 1);
  const double once = timeBatch(problem, contestant, 1);
  const int count =
      once * largestBatch > batchSeconds ? 1 + int(batchSeconds / once) : largestBatch;
  std::vector<double> seconds;
  do seconds.push_back(timeBatch(problem, contestant, count));
  while (watch.seconds() < repeatFor);
  return seconds;
}

}  // namespace

bool Measured::meets(double tolerance) const {
  return ending == Ending::Done && rel <= tolerance && vel <= tolerance;
}

double median(std::vector<double> numbers) {
  std::sort(numbers.begin(), numbers.end());
  const std::size_t middle = numbers.size() / 2;
  return numbers.size() % 2 != 0 ? numbers[middle] : 0.5 * (numbers[middle - 1] + numbers[middle]);
}

Measured measure(const Problem& problem, const Contestant& contestant, double secondsLimit,
                 double repeatFor) {
  // rel, vel, satisfied, then the times.
  constexpr std::size_t head = 3;
  const auto work = [&] {
    const Attempt judged = contestant(problem);
    const Stopwatch watch;
    const bool satisfied = judged.run();
    const double first = watch.seconds();
    const FclibMeasures measures = fclibMeasures(problem, judged.reactions());
    std::vector<double> numbers{measures.rel, measures.vel, satisfied ? 1.0 : 0.0};
    std::vector<double> seconds{first};
    if (first < repeatFor) seconds = timeRepeats(problem, contestant, repeatFor);
    numbers.insert(numbers.end(), seconds.begin(), seconds.end());
    return numbers;
  };
  const auto result = demos::runApart(work, {secondsLimit + repeatFor});

  Measured measured;
  measured.secondsInAll = result.seconds;
  // A solver that ends the process with a good exit status has not answered either.
  if (result.ending == Ending::Done && result.numbers.size() <= head) return measured;
  measured.ending = result.ending;
  if (result.ending != Ending::Done) return measured;
  measured.rel = result.numbers[0];
  measured.vel = result.numbers[1];
  measured.satisfied = result.numbers[2] != 0;
  measured.seconds.assign(result.numbers.begin() + head, result.numbers.end());
  return measured;
}

}  // namespace delassus::peers
