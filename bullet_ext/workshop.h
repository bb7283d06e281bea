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

/// All that one thread needs to solve one island after the other. Nothing that the last island left
/// here affects the answer of the next one.
struct Bench {
  explicit Bench(const Options& options) : solver(options), check(options) {}

  Solver solver;
  IslandCheck check;
  Assembler assembler;
  Coupling coupling;
  VectorXd guess;
  Solution solution;
  /// Of easier problems (soft_answer.h): what they are made of, and an answer beside `solution`.
  std::vector<Body> softBodies;
  std::vector<Contact> softContacts;
  std::vector<Row> softRows;
  Solution trial;
  std::vector<Body> trialBodies;

  /// Copies the island's contacts to softContacts and calls change(copy) for each. Those of other
  /// islands are not to be read.
  template <class Change>
  void changeContacts(const std::vector<Contact>& contacts, const Island& island,
                      const Change& change) {
    softContacts.resize(contacts.size());
    island.eachContact([&](int i) { change(softContacts[i] = contacts[i]); });
  }
  /// The same for its rows, with change(copy, row).
  template <class Change>
  void changeRows(const std::vector<Row>& rows, const Island& island, const Change& change) {
    softRows.resize(rows.size());
    for (const int i : island.rows) change(softRows[i] = rows[i], i);
  }

  std::size_t bytes() const {
    return solver.bytes() + check.bytes() + assembler.bytes() + coupling.bytes() +
           solution.bytes() + trial.bytes() +
           bytesOf(guess, softBodies, trialBodies, softContacts, softRows);
  }

  /// The work done here since the last Workshop::takeCounts().
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

/// Shortens a solver's budgets for its lifetime.
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

  /// Loosens the tolerance, relative to the largest demand.
  void loosen(double tolerance) {
    Options options = solver_.options();
    options.tolerance = std::max(options.tolerance, tolerance);
    solver_.setOptions(options);
  }

  /// Loosens the tolerance and shortens the sweeps, too, for bodies that are taken softer than they
  /// are by an amount that nobody knows. The test for a jam (answerJam) has room for an error of
  /// 1e-4, not of 1e-3.
  void takeAnyNear() {
    loosen(1e-4);
    sweepLess();
  }

  void sweepLess() {
    Options options = solver_.options();
    options.sweepBudget = std::min(options.sweepBudget, 2000);
    solver_.setOptions(options);
  }

 private:
  Solver& solver_;
  Options usual_;
};

/// Where islands are solved: by the caller alone, or side by side by a crew. Islands share no body
/// that moves, no contact and no row. So each has the same answer, bit for bit, whoever else is at
/// work.
class Workshop {
 public:
  explicit Workshop(const Options& options) : options_(options) { clear(); }

  /// Throws std::system_error or std::bad_alloc where threads or their benches are not to be had:
  /// then the caller works alone.
  void setThreads(int threads) {
    crew_.setHands(1);
    benches_.resize(1);
    Benches benches = makeBenches(std::max(threads, 1));
    crew_.setHands(static_cast<int>(benches.size()));
    benches_.swap(benches);
  }
  int threads() const { return crew_.count(); }
  const Options& options() const { return options_; }

  /// Makes new benches.
  void clear() { benches_ = makeBenches(crew_.count()); }

  /// Calls work(bench, i) for all i < count. Other threads than the caller's take part if there is
  /// enough to do, by the sum of weight(i), in unknowns, not by the clock.
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

  /// The same where the benches' solvers work. An item of at least three times the weight of all
  /// others would keep one hand busy while the others wait: it comes first, and all hands work on
  /// it.
  template <class Weight, class Work>
  void shareSolving(int count, const Weight& weight, const Work& work) {
    // Above this many unknowns a solution takes longer than calling another thread.
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

  /// The work done on all benches since the last call.
  Bench::Counts takeCounts() {
    Bench::Counts sum;
    for (const auto& bench : benches_) sum.add(std::exchange(bench->counts, {}));
    return sum;
  }

 private:
  using Benches = std::vector<std::unique_ptr<Bench>>;  ///< one a hand

  Benches makeBenches(int count) const {
    Benches benches;
    for (int i = 0; i < count; ++i) benches.push_back(std::make_unique<Bench>(options_));
    return benches;
  }

  /// Lends hands to a solver for its lifetime.
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
  Benches benches_;
};

}  // namespace delassus::bullet
