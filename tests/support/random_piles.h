#pragma once
/// Islands of boxes on which solvers are tried, and what Newton's laws say of an answer.

#include <vector>

#include "delassus/island.h"
#include "delassus/residual.h"
#include "delassus/solution.h"
#include "tests/support/box_piles.h"
#include "tests/support/random_problems.h"

namespace delassus::test {

/// A pile that is one island, its problem in body space, and the targets in the order of q.
struct PileIsland {
  Pile pile;
  Island island;
  Problem problem;
  VectorXd target;

  explicit PileIsland(Pile p);

  std::vector<Body> after(const VectorXd& r) const;
};

/// Masses whose quotients are log-uniform in [1/ratio, ratio].
std::vector<double> randomMasses(int n, double ratio, Random& random);

/// Gives every contact its own friction in [0, largest]; one in ten has none.
void mixFriction(Pile& pile, double largest, Random& random);

/// The same step without friction.
Pile withoutFriction(Pile pile);

/// The same pile of contacts with lengths times 2^lengths and masses times 2^masses. If `masses` is
/// even, roots of masses are exact, too.
Pile inOtherUnits(Pile pile, int lengths, int masses);

/// Explicit storage of the same problem.
Problem withEntries(const Problem& problem);

/// Kinetic energy of movable bodies with full inverse inertias, J.
double kineticEnergy(const std::vector<Body>& bodies);

/// How far two motions of the same bodies are apart: √(Δv·M Δv / v·M v), v the free motion.
double motionDistance(const PileIsland& pile, const VectorXd& r, const VectorXd& s);

/// A solution that is yet to be improved: reactions r, with their residuals.
Solution startFrom(const Problem& problem, const NaturalMap& map, const VectorXd& r);

/// Largest distance of a reaction to its cone, bounds or disk, N·s (N·m·s).
double infeasibility(const Problem& problem, const VectorXd& r);

/// Reactions drawn from the cones and bounds, of the size `scale`.
VectorXd randomReactions(const Problem& problem, double scale, Random& random);

}  // namespace delassus::test
