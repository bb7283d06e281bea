#pragma once

#include <random>

#include "delassus/types.h"

namespace delassus {

using Random = std::mt19937_64;

double uniform(Random& random, double from, double to);
VectorXd normalVector(int n, Random& random);
MatrixXd normalMatrix(int rows, int columns, Random& random);

/// Symmetric positive definite, with random axes. The eigenvalues are log-uniform over
/// [1/condition, 1], with both ends taken.
MatrixXd randomDelassus(int n, double condition, Random& random);

/// W = J Jᵀ of n contacts that a system with `freedoms` degrees of freedom and unit masses feels;
/// singular if n > freedoms.
MatrixXd randomJacobian(int n, int freedoms, Random& random);

/// W = J M⁻¹ Jᵀ of a stack of `boxes` unit cubes resting on the ground, normals only, four corners
/// a face: rank 3 a face. `massRatio` is the mass of each box over the mass of the box below it.
MatrixXd boxStackJacobian(int boxes, double massRatio = 1);

/// Bounds of rows of all kinds: contacts [0, ∞), motors [−m, m], joints, limits (−∞, 0].
void randomBounds(int n, Random& random, VectorXd& lower, VectorXd& upper);

}  // namespace delassus
