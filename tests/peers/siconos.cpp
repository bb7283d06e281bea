#include "tests/peers/siconos.h"

#include <Friction_cst.h>
#include <NonSmoothDrivers.h>
#include <SolverOptions.h>
#include <dlfcn.h>

#include <memory>

#include "tests/peers/siconos_problem.h"

namespace delassus::peers {

namespace {

using SiconosOptions = std::unique_ptr<SolverOptions, decltype(&solver_options_delete)>;

struct Named {
  const char* name;
  int solver;
};
constexpr Named solvers[] = {
    {"NSGS", SICONOS_FRICTION_3D_NSGS},     {"NSN_AC", SICONOS_FRICTION_3D_NSN_AC},
    {"NSN_FB", SICONOS_FRICTION_3D_NSN_FB}, {"ADMM", SICONOS_FRICTION_3D_ADMM},
    {"PROX", SICONOS_FRICTION_3D_PROX},     {"FPP", SICONOS_FRICTION_3D_FPP},
    {"VI_EG", SICONOS_FRICTION_3D_VI_EG},
};

/// So many that the time limit decides, except for problems with iterations of microseconds.
constexpr int enoughIterations = 1000000;

SiconosOptions siconosOptions(int solver, double tolerance) {
  SiconosOptions options(solver_options_create(solver), solver_options_delete);
  options->dparam[SICONOS_DPARAM_TOL] = tolerance;
  options->iparam[SICONOS_IPARAM_MAX_ITER] = enoughIterations;
  if (solver == SICONOS_FRICTION_3D_NSGS)
    solver_options_update_internal(options.get(), 0, SICONOS_FRICTION_3D_ONECONTACT_QUARTIC);
  return options;
}

/// What one call of Siconos reads and writes. It is made anew for every call, since solvers keep
/// work in the options, and keep other forms of W beside the one they are given.
struct Call {
  SiconosProblem problem;
  SiconosOptions options;
  VectorXd reactions, velocities;

  bool run() {
    return fc3d_driver(problem.get(), reactions.data(), velocities.data(), options.get()) == 0;
  }
};

Contestant contestant(int solver, Storage storage, double tolerance) {
  return [=](const Problem& problem) {
    const VectorXd rest = VectorXd::Zero(problem.size());
    const auto call = std::make_shared<Call>(
        Call{siconosProblem(problem, storage), siconosOptions(solver, tolerance), rest, rest});
    return Attempt{[call] { return call->run(); }, [call] { return call->reactions; }};
  };
}

/// On the smallest problems, solvers that factorise take a hundred times as long with blocks.
std::vector<std::string> storages(const Problem& problem) {
  constexpr int fewUnknowns = 300;
  if (problem.size() <= fewUnknowns) return {"dense", "blocks"};
  return {"blocks", "dense"};
}

}  // namespace

std::vector<Peer> siconosSolvers() {
  std::vector<Peer> peers;
  for (const Named& named : solvers) {
    const auto with = [named](const std::string& storage, double ownTolerance) {
      return contestant(named.solver, storage == "dense" ? Storage::Dense : Storage::Blocks,
                        ownTolerance);
    };
    peers.push_back({named.name, storages, with});
  }
  return peers;
}

void useOneThread() {
  // Looked up by name: another BLAS that Siconos may be linked with has no threads, and no such
  // call.
  void* const call = dlsym(RTLD_DEFAULT, "openblas_set_num_threads");
  if (call != nullptr) reinterpret_cast<void (*)(int)>(call)(1);
}

}  // namespace delassus::peers
