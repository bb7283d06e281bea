#pragma once

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "bullet_ext/crew.h"
#include "delassus/articulation.h"
#include "delassus/bytes.h"
#include "delassus/contact.h"
#include "delassus/island.h"
#include "delassus/island_check.h"
#include "delassus/row.h"
#include "delassus/solution.h"
#include "delassus/solver.h"

namespace delassus::bullet {

/// All that one thread needs to answer one island after the other. Nothing that is left on it from
/// the last island shows in the next one's answer.
struct Bench {
  explicit Bench(const Options& options) : solver(options), check(options) {}

  Solver solver;
  IslandCheck check;
  Assembler assembler;
  Coupling coupling;
  VectorXd guess;
  Solution solution;
  std::vector<Contact> softContacts;
  std::vector<Row> softRows;

  std::size_t bytes() const {
    return solver.bytes() + check.bytes() + assembler.bytes() + coupling.bytes() +
           solution.bytes() + bytesOf(guess, softContacts, softRows);
  }

  /// What was done here since the last Workshop::takeCounts().
  struct Counts : WorkDone {
    int unsolved = 0;
    void add(const Solution& solved) {
      unsolved += solved.status != Status::Solved;
      addWork(solved);
    }
    void add(const Counts& other) {
      unsolved += other.unsolved;
      addWork(other);
    }
  } counts;
};

/// Has a solver search for a shorter while than it may, as long as this lives.
class ShortSearch {
 public:
  explicit ShortSearch(Solver& solver) : solver_(solver), usual_(solver.options()) {
    Options options = usual_;
    options.newtonBudget = std::min(options.newtonBudget, 200);
    options.pathBudget = 0;
    solver_.setOptions(options);
  }
  ~ShortSearch() { solver_.setOptions(usual_); }
  ShortSearch(const ShortSearch&) = delete;
  ShortSearch& operator=(const ShortSearch&) = delete;

  /// And for less: for bodies that are taken softer than they are, nobody knows by how much. What
  /// tells a jam from what is none leaves room for an error of 1e-4 (answerJam), not of 1e-3.
  void takeAnyNear() {
    Options options = solver_.options();
    options.tolerance = std::max(options.tolerance, 1e-4);
    options.sweepBudget = std::min(options.sweepBudget, 2000);
    solver_.setOptions(options);
  }

 private:
  Solver& solver_;
  Options usual_;
};

/// Where islands are answered: by the caller alone, or by a crew side by side. They share no body
/// that moves, no contact and no row, so that each has the same answer, bit for bit, whoever else
/// is at work.
class Workshop {
 public:
  explicit Workshop(const Options& options) : options_(options) { clear(); }

  void setThreads(int threads) {
    crew_.setHands(std::max(threads, 1));
    clear();
  }
  int threads() const { return crew_.count(); }
  const Options& options() const { return options_; }

  /// Empty benches.
  void clear() {
    benches_.clear();
    for (int i = 0; i < crew_.count(); ++i) benches_.push_back(std::make_unique<Bench>(options_));
  }

  /// Calls work(bench, i) for all i < count. Others than the caller take part if there is enough
  /// for them to do: by the sum of weight(i), in unknowns, not by the clock.
  template <class Weight, class Work>
  void share(int count, int worthwhile, const Weight& weight, const Work& work) {
    int total = 0;
    if (crew_.count() > 1 && count > 1)
      for (int i = 0; i < count; ++i) total += weight(i);
    if (total > worthwhile) {
      crew_.share(count, weight, [&](int hand, int i) { work(*benches_[hand], i); });
    } else {
      for (int i = 0; i < count; ++i) work(*benches_[0], i);
    }
  }

  /// The same where a bench's solver is at work. What weighs three times as much as all else would
  /// keep one hand busy while the others wait: it comes first, with all of them.
  template <class Weight, class Work>
  void shareSolving(int count, const Weight& weight, const Work& work) {
    // Unknowns whose solution takes longer than it takes to call another thread.
    constexpr int worthwhile = 100;
    const int heaviest = crew_.count() > 1 ? predominant(count, weight) : -1;
    if (heaviest >= 0) {
      const Lent lent(benches_[0]->solver, crew_);
      work(*benches_[0], heaviest);
    }
    share(
        count, worthwhile, [&](int i) { return i == heaviest ? 0 : weight(i); },
        [&](Bench& bench, int i) {
          if (i != heaviest) work(bench, i);
        });
  }

  std::size_t bytes() const {
    std::size_t sum = 0;
    for (const auto& bench : benches_) sum += bench->bytes();
    return sum;
  }

  /// What was done on all benches since the last call.
  Bench::Counts takeCounts() {
    Bench::Counts sum;
    for (const auto& bench : benches_) sum.add(std::exchange(bench->counts, {}));
    return sum;
  }

 private:
  /// Hands that a solver has for a while.
  struct Lent {
    Lent(Solver& to, Hands& hands) : solver(to) { solver.setHands(&hands); }
    ~Lent() { solver.setHands(nullptr); }
    Lent(const Lent&) = delete;
    Lent& operator=(const Lent&) = delete;
    Solver& solver;
  };

  template <class Weight>
  static int predominant(int count, const Weight& weight) {
    constexpr int times = 3;
    int total = 0, heaviest = -1, most = 0;
    for (int i = 0; i < count; ++i) {
      total += weight(i);
      if (weight(i) > most) most = weight(heaviest = i);
    }
    return most >= times * (total - most) ? heaviest : -1;
  }

  Options options_;
  Crew crew_;
  std::vector<std::unique_ptr<Bench>> benches_;  ///< one a hand
};

}  // namespace delassus::bullet
