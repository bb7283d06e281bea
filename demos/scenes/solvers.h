#pragma once

#include <btBulletDynamicsCommon.h>

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "delassus/options.h"

class btDelassusConstraintSolver;
class btMLCPSolver;
class btMLCPSolverInterface;

namespace demos {

/// A solver name that is not one; the message says what exists.
class UnknownSolver : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The constraint solver that a name stands for, and the settings of the world that go with it:
///
///     delassus, delassus:TOL    region selection, to its default tolerance or to TOL
///     delassus/N                the same, an island with N sweeps and a region for every twenty of
///                               them, but at least one
///     si:N, si2:N, nncg:N       Bullet's sequential impulses, the same with two friction
///                               directions, and NNCG; N sweeps
///     dantzig, dantzig:CFM      Bullet's MLCP solver on Dantzig's method, with the global CFM
///     lemke, pgs:N              the same on Lemke's method, and on N projected Gauss-Seidel sweeps
class NamedSolver {
 public:
  /// Throws UnknownSolver.
  explicit NamedSolver(const std::string& name);
  /// Ours with other options than a name can tell.
  NamedSolver(const std::string& name, const delassus::Options& options);
  ~NamedSolver();
  NamedSolver(NamedSolver&&) noexcept;
  NamedSolver& operator=(NamedSolver&&) noexcept;

  const std::string& name() const { return name_; }
  btConstraintSolver& solver() { return *solver_; }
  /// Makes `info` ask for the sweeps, the friction directions and the CFM that the name stands for.
  void configure(btContactSolverInfo& info) const;

  /// Has our solver use so many threads; Bullet's have one.
  void setThreads(int threads);
  /// Has our solver slow what turns too fast for the step; Bullet's cannot.
  void setGeometricStiffness(bool on);

  /// The solver itself if it is ours, else null.
  const btDelassusConstraintSolver* delassus() const { return delassus_; }
  /// Groups that an MLCP solver gave up and left to sequential impulses.
  int fallbacks() const;

 private:
  std::string name_;
  int sweeps_ = 0;  ///< 0: as the world says
  bool twoFrictionDirections_ = false;
  double cfm_ = 0;
  std::unique_ptr<btMLCPSolverInterface> method_;
  std::unique_ptr<btConstraintSolver> solver_;
  btDelassusConstraintSolver* delassus_ = nullptr;
  const btMLCPSolver* mlcp_ = nullptr;
};

/// "a,b,c" as a list of names, none of them empty.
std::vector<std::string> splitNames(const std::string& list);

}  // namespace demos
