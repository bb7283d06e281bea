#include "demos/scenes/solvers.h"

#include <BulletDynamics/ConstraintSolver/btNNCGConstraintSolver.h>
#include <BulletDynamics/MLCPSolvers/btDantzigSolver.h>
#include <BulletDynamics/MLCPSolvers/btLemkeSolver.h>
#include <BulletDynamics/MLCPSolvers/btMLCPSolver.h>
#include <BulletDynamics/MLCPSolvers/btSolveProjectedGaussSeidel.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>

#include "bullet_ext/btDelassusConstraintSolver.h"

namespace demos {

namespace {

[[noreturn]] void refuse(const std::string& name) {
  throw UnknownSolver("there is no solver '" + name +
                      "'; there are delassus, delassus:TOL, delassus/N, si:N, si2:N, "
                      "nncg:N, dantzig, dantzig:CFM, lemke and pgs:N");
}

/// The name's part after the mark, as a count of at least one.
int countIn(const std::string& name, const std::string& argument) {
  int count = 0;
  const char* end = argument.data() + argument.size();
  const auto [stop, error] = std::from_chars(argument.data(), end, count);
  if (error != std::errc() || stop != end || count < 1) refuse(name);
  return count;
}

/// The name's part after the mark, as a number greater than zero.
double numberIn(const std::string& name, const std::string& argument) {
  char* stop = nullptr;
  const double number = std::strtod(argument.c_str(), &stop);
  if (argument.empty() || *stop != '\0' || !std::isfinite(number) || number <= 0) refuse(name);
  return number;
}

}  // namespace

NamedSolver::NamedSolver(const std::string& name) : name_(name) {
  const std::size_t mark = name.find_first_of(":/");
  const bool hasArgument = mark != std::string::npos;
  const bool hasBudget = hasArgument && name[mark] == '/';
  const std::string kind = name.substr(0, mark);
  const std::string argument = hasArgument ? name.substr(mark + 1) : "";
  if (hasBudget && kind != "delassus") refuse(name);

  if (kind == "delassus") {
    constexpr int sweepsOfRegion = 20;  // what a region costs in small piles; more in large ones
    delassus::Options options;
    if (hasBudget) {
      options.sweepBudget = countIn(name, argument);
      options.newtonBudget = std::max(1, options.sweepBudget / sweepsOfRegion);
    } else if (hasArgument) {
      options.tolerance = numberIn(name, argument);
    }
    auto solver = std::make_unique<btDelassusConstraintSolver>(options);
    delassus_ = solver.get();
    solver_ = std::move(solver);
  } else if ((kind == "si" || kind == "si2") && hasArgument) {
    sweeps_ = countIn(name, argument);
    twoFrictionDirections_ = kind == "si2";
    solver_ = std::make_unique<btSequentialImpulseConstraintSolver>();
  } else if (kind == "nncg" && hasArgument) {
    sweeps_ = countIn(name, argument);
    solver_ = std::make_unique<btNNCGConstraintSolver>();
  } else if (kind == "dantzig") {
    if (hasArgument) cfm_ = numberIn(name, argument);
    method_ = std::make_unique<btDantzigSolver>();
  } else if (kind == "lemke" && !hasArgument) {
    method_ = std::make_unique<btLemkeSolver>();
  } else if (kind == "pgs" && hasArgument) {
    sweeps_ = countIn(name, argument);
    method_ = std::make_unique<btSolveProjectedGaussSeidel>();
  } else {
    refuse(name);
  }

  if (method_ != nullptr) {
    auto solver = std::make_unique<btMLCPSolver>(method_.get());
    mlcp_ = solver.get();
    solver_ = std::move(solver);
  }
}

NamedSolver::NamedSolver(const std::string& name, const delassus::Options& options) : name_(name) {
  auto solver = std::make_unique<btDelassusConstraintSolver>(options);
  delassus_ = solver.get();
  solver_ = std::move(solver);
}

NamedSolver::~NamedSolver() = default;
NamedSolver::NamedSolver(NamedSolver&&) noexcept = default;
NamedSolver& NamedSolver::operator=(NamedSolver&&) noexcept = default;

void NamedSolver::configure(btContactSolverInfo& info) const {
  if (sweeps_ > 0) {
    info.m_numIterations = sweeps_;
    info.m_leastSquaresResidualThreshold = 0;  // all sweeps that were asked for
  }
  if (twoFrictionDirections_) info.m_solverMode |= SOLVER_USE_2_FRICTION_DIRECTIONS;
  if (cfm_ > 0) info.m_globalCfm = btScalar(cfm_);
}

void NamedSolver::setThreads(int threads) {
  if (delassus_ != nullptr) delassus_->setThreads(threads);
}

void NamedSolver::setGeometricStiffness(bool on) {
  if (delassus_ != nullptr) delassus_->setGeometricStiffness(on);
}

int NamedSolver::fallbacks() const { return mlcp_ != nullptr ? mlcp_->getNumFallbacks() : 0; }

std::vector<std::string> splitNames(const std::string& list) {
  std::vector<std::string> names;
  std::size_t begin = 0;
  while (begin <= list.size()) {
    const std::size_t comma = std::min(list.find(',', begin), list.size());
    if (comma > begin) names.push_back(list.substr(begin, comma - begin));
    begin = comma + 1;
  }
  return names;
}

}  // namespace demos
