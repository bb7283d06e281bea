#pragma once

#include <array>
#include <memory>

#include "demos/scenes/world.h"

namespace demos {

/// A table of 20 kg on four round feet, and a load of 100 kg without friction that glides along it
/// at constant speed. They are the first and the second movable body.
std::unique_ptr<World> buildForcePlate();

/// Forces under the feet, N, in the order of their numbers: bit 0 is set for +x, bit 1 for +z of
/// the table.
using FootForces = std::array<double, 4>;

/// As written by the solver into the contact points of the last step, of `timeStep` s. `table` is
/// the first body.
FootForces measuredFootForces(const World& world, double timeStep);

/// What statics tells about the feet: the force that they carry together, and its moments about the
/// middle of the table. Feet are at (x_i, z_i); weights G_k were at (x_k, z_k) when the last step
/// began:
///
///     Σ N_i = Σ G_k,   Σ N_i x_i = Σ G_k x_k,   Σ N_i z_i = Σ G_k z_k
///
/// Statics leaves one number of the four open, the self-stress N_0 − N_1 − N_2 + N_3.
struct FootStatics {
  double force, momentX, momentZ;  ///< N, N·m
};
FootStatics staticsOf(const FootForces& forces);
FootStatics staticsOfWeights(const World& world, double timeStep);

/// The largest error of the measured force, and of its moments over the distance of the feet from
/// the middle, as a share of the weight.
double footForceError(const World& world, double timeStep);

}  // namespace demos
