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

/// The parts of a solver's name: "si:10" is of the family "si", with the argument "10".
struct SolverName {
  std::string family;
  char mark = '\0';  ///< ':' or '/' before the argument; '\0' if there is none
  std::string argument = "";

  std::string text() const;
};
SolverName parseSolverName(const std::string& name);

/// One way to name a solver, and what there is to say of it.
struct SolverForm {
  SolverName name;      ///< with a word for the argument: N, TOL or CFM
  std::string help;     ///< goes on in that of the next form where it ends in a comma or semicolon
  std::string caption;  ///< with {} for the argument
};
/// All there are: what is not of one of these forms is no solver.
const std::vector<SolverForm>& solverForms();
/// "delassus, delassus:TOL, ..."; `last` stands before the last one.
std::string listOfSolverForms(const std::string& last);
/// What a picture calls the solver; nothing if there is none of this name.
std::string solverInWords(const std::string& name);

/// The constraint solver that a name stands for (solverForms), and the settings of the world that
/// go with it.
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

/// "a,b,c" as a list of names; empty ones too, which are no solvers.
std::vector<std::string> splitNames(const std::string& list);

}  // namespace demos
