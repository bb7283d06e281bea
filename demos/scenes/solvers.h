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

/// A solver name that does not exist; the message lists those that do.
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

/// One way to name a solver, with its help and its caption.
struct SolverForm {
  SolverName name;      ///< with a word for the argument: N, TOL or CFM
  std::string help;     ///< goes on in the next form's help if it ends in a comma or semicolon
  std::string caption;  ///< with {} for the argument
};
/// All forms: a name that has none of them is no solver.
const std::vector<SolverForm>& solverForms();
/// "delassus, delassus:TOL, ..."; the word `last` stands before the last one.
std::string listOfSolverForms(const std::string& last);
/// The solver's name in pictures; empty if there is no such solver.
std::string solverInWords(const std::string& name);

/// The constraint solver that a name stands for (solverForms), and the settings of the world that
/// go with it.
class NamedSolver {
 public:
  /// Throws UnknownSolver.
  explicit NamedSolver(const std::string& name);
  /// Our solver with options that a name cannot express.
  NamedSolver(const std::string& name, const delassus::Options& options);
  ~NamedSolver();
  NamedSolver(NamedSolver&&) noexcept;
  NamedSolver& operator=(NamedSolver&&) noexcept;

  const std::string& name() const { return name_; }
  btConstraintSolver& solver() { return *solver_; }
  /// Sets the sweeps, the friction directions and the CFM of the name in `info`.
  void configure(btContactSolverInfo& info) const;

  /// Lets our solver use this many threads; Bullet's solvers have one.
  void setThreads(int threads);
  /// Lets our solver slow bodies that turn too fast for the step; Bullet's solvers cannot.
  void setGeometricStiffness(bool on);

  /// The solver itself if it is ours, else null.
  const btDelassusConstraintSolver* delassus() const { return delassus_; }
  /// Groups that an MLCP solver gave up, and that sequential impulses solved instead.
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
