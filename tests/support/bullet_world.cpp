#include "tests/support/bullet_world.h"

namespace delassus::test {

Options optionsOfPrecision() {
  Options options;
  options.tolerance = tolerance(1e-8, 1e-5);
  return options;
}

DelassusWorld::DelassusWorld(const Options& options)
    : BulletWorld(std::make_unique<btDelassusConstraintSolver>(options)) {}

StockWorld::StockWorld(int sweeps)
    : BulletWorld(std::make_unique<btSequentialImpulseConstraintSolver>()) {
  info().m_numIterations = sweeps;
  info().m_leastSquaresResidualThreshold = 0;
}

}  // namespace delassus::test
