#pragma once

#include <vector>

#include "delassus/one_contact.h"
#include "delassus/options.h"
#include "delassus/residual.h"
#include "delassus/solution.h"
#include "delassus/split_problem.h"

namespace delassus {

/// The answer to a problem with explicit W that is small, or whose contacts feel little of each
/// other. A few sweeps and a few regions then take less time than to make a Solver, or to take W
/// apart. Contacts that do not approach are skipped.
class QuickAnswer {
 public:
  /// Keeps references. The problem must be fit (unfitParts), with entries, contacts and neither
  /// rows nor disks.
  QuickAnswer(const Problem& problem, const Options& options);

  /// True if it keeps the law to within the tolerance; only then `answer` is written.
  bool find(Solution& answer);

  /// If not: whether best() keeps the law in one part.
  bool answers(const ProblemParts& parts, int part) const;
  /// The best reactions found.
  const Solution& best() const { return best_; }
  /// The mode of a contact in best().
  Mode modeOf(int contact) const;
  double residualOf(int contact) const { return contacts_[contact].residual; }  ///< m/s

 private:
  struct Contact {
    int place = -1;              ///< in approaching_; -1: not in it
    bool isAlone = false;        ///< no other reaction moves it
    double residual = infinity;  ///< m/s
  };
  /// Data of a contact that approaches, or has a region.
  struct Approaching {
    explicit Approaching(const Mat3& W) : block(W), squaredNorm(W.squaredNorm()) {}

    OneContact block;
    double squaredNorm;  ///< of the entries of W_aa, (1/kg)²
    double size = 0;     ///< ‖W_aa‖, 1/kg; 0: not computed yet
  };

  bool isReached() const { return best_.residual <= tolerance_; }
  bool isSmall() const;
  bool isAlone(int contact) const;
  /// Whether a contact needs nothing: it does not approach, and no other reaction moves it.
  bool staysApart(int contact) const {
    const Contact& c = contacts_[contact];
    return c.isAlone && c.place < 0 && problem_.q[3 * contact] >= 0;
  }
  Vec3 velocityOf(int contact) const;
  Mat3 blockOf(int contact) const;
  const Approaching& approaching(int contact);
  double sizeOf(int contact);
  void sweep();
  bool isRocking(int contact, double normalVelocity) const;
  double sweepOnce();
  void measure();
  bool walk();

  const Problem& problem_;
  const Options& options_;
  double friction_;          ///< the largest μ
  double tolerance_;         ///< m/s
  bool isFull_;              ///< all of W is stored
  double felt_ = 0;          ///< most that a contact felt of others in the first sweep, m/s
  bool firstGains_ = false;  ///< the first sweep removed most of the residual
  std::vector<Contact> contacts_;
  std::vector<Approaching> approaching_;  ///< in the order in which they were found
  Solution best_;
};

}  // namespace delassus
