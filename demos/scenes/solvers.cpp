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
#include <limits>

#include "bullet_ext/btDelassusConstraintSolver.h"

namespace demos {

namespace {

/// Null if there is no such form.
const SolverForm* formOf(const SolverName& name) {
  for (const SolverForm& form : solverForms())
    if (form.name.family == name.family && form.name.mark == name.mark) return &form;
  return nullptr;
}

[[noreturn]] void refuse(const std::string& name) {
  throw UnknownSolver(
      (name.empty() ? "a solver's name is empty" : "there is no solver '" + name + "'") +
      "; there are " + listOfSolverForms(" and "));
}

[[noreturn]] void refuse(const SolverName& name, const std::string& expected) {
  throw UnknownSolver("there is no solver '" + name.text() + "': " + formOf(name)->name.text() +
                      " takes " + expected);
}

/// The name's part after the mark, as a count of at least 1.
int countIn(const SolverName& name) {
  int count = 0;
  const std::string& argument = name.argument;
  const char* end = argument.data() + argument.size();
  const auto [stop, error] = std::from_chars(argument.data(), end, count);
  if (error != std::errc() || stop != end || count < 1)
    refuse(name, "a whole number from 1 to " + std::to_string(std::numeric_limits<int>::max()));
  return count;
}

/// The name's part after the mark, as a number greater than zero and below `end`.
double numberIn(const SolverName& name, double end) {
  char* stop = nullptr;
  const std::string& argument = name.argument;
  const double number = std::strtod(argument.c_str(), &stop);
  if (argument.empty() || *stop != '\0' || !(number > 0 && number < end))
    refuse(name,
           std::isfinite(end) ? "a number greater than 0 and below 1" : "a number greater than 0");
  return number;
}

}  // namespace

std::string SolverName::text() const { return mark == '\0' ? family : family + mark + argument; }

SolverName parseSolverName(const std::string& name) {
  const std::size_t mark = name.find_first_of(":/");
  if (mark == std::string::npos) return {name};
  return {name.substr(0, mark), name[mark], name.substr(mark + 1)};
}

const std::vector<SolverForm>& solverForms() {
  static const std::vector<SolverForm> forms{
      {{"delassus"}, "this solver, to its default tolerance,", "Delassus' regions"},
      {{"delassus", ':', "TOL"},
       "or to TOL, relative to the largest demand",
       "Delassus' regions to {}"},
      {{"delassus", '/', "N"},
       "at most N sweeps an island, and a region for every twenty, at least one",
       "Delassus' regions, budget of {} sweeps an island"},
      {{"si", ':', "N"},
       "Bullet's sequential impulses, N sweeps",
       "stock Bullet, sequential impulses, {} sweeps"},
      {{"si2", ':', "N"},
       "the same with two friction directions",
       "stock Bullet, sequential impulses, two friction directions, {} sweeps"},
      {{"nncg", ':', "N"},
       "Bullet's nonsmooth nonlinear conjugate gradient",
       "stock Bullet, NNCG, {} sweeps"},
      {{"dantzig"}, "Bullet's MLCP solver, Dantzig's method,", "stock Bullet, MLCP by Dantzig"},
      {{"dantzig", ':', "CFM"}, "with a global CFM", "stock Bullet, MLCP by Dantzig, CFM {}"},
      {{"lemke"}, "the same, Lemke's method;", "stock Bullet, MLCP by Lemke"},
      {{"pgs", ':', "N"},
       "projected Gauss-Seidel, N sweeps",
       "stock Bullet, projected Gauss-Seidel, {} sweeps"}};
  return forms;
}

std::string listOfSolverForms(const std::string& last) {
  std::string list;
  const std::vector<SolverForm>& forms = solverForms();
  for (std::size_t i = 0; i < forms.size(); ++i)
    list += (i == 0 ? "" : i + 1 < forms.size() ? ", " : last) + forms[i].name.text();
  return list;
}

std::string solverInWords(const std::string& name) {
  const SolverName parsed = parseSolverName(name);
  const SolverForm* form = formOf(parsed);
  if (form == nullptr) return "";
  std::string words = form->caption;
  const std::string place = "{}";
  if (const std::size_t at = words.find(place); at != std::string::npos)
    words.replace(at, place.size(), parsed.argument);
  return words;
}

NamedSolver::NamedSolver(const std::string& name) : name_(name) {
  const SolverName parsed = parseSolverName(name);
  if (formOf(parsed) == nullptr) refuse(name);
  const std::string& family = parsed.family;
  const char mark = parsed.mark;

  if (family == "delassus") {
    delassus::Options options;
    if (mark == '/') {
      options = delassus::Options::bounded(countIn(parsed));
    } else if (mark == ':') {
      options.tolerance = numberIn(parsed, 1);
    }
    auto solver = std::make_unique<btDelassusConstraintSolver>(options);
    delassus_ = solver.get();
    solver_ = std::move(solver);
  } else if (family == "si" || family == "si2") {
    sweeps_ = countIn(parsed);
    twoFrictionDirections_ = family == "si2";
    solver_ = std::make_unique<btSequentialImpulseConstraintSolver>();
  } else if (family == "nncg") {
    sweeps_ = countIn(parsed);
    solver_ = std::make_unique<btNNCGConstraintSolver>();
  } else if (family == "dantzig") {
    if (mark == ':') cfm_ = numberIn(parsed, std::numeric_limits<double>::infinity());
    method_ = std::make_unique<btDantzigSolver>();
  } else if (family == "lemke") {
    method_ = std::make_unique<btLemkeSolver>();
  } else if (family == "pgs") {
    sweeps_ = countIn(parsed);
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
    names.push_back(list.substr(begin, comma - begin));
    begin = comma + 1;
  }
  return names;
}

}  // namespace demos
