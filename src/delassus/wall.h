#pragma once

#include "delassus/types.h"

namespace delassus {

/// Walls of the regions on a straight line z + t d, z being what the law makes reactions of
/// (`reactionTo`): where a mode changes. Each tells the first t > `after` of one, infinite if there
/// is none.

/// Of a contact: z_n = 0, or ‖z_t‖ = μ z_n > 0.
double nextWall(const Vec3& z, const Vec3& d, double mu, double after);
/// Of a row: z at one of its bounds.
double nextWall(double z, double d, double lower, double upper, double after);

}  // namespace delassus
