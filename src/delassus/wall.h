#pragma once

#include "delassus/types.h"

namespace delassus {

/// Walls of the regions on a straight line z + t d, where a mode changes; the law turns z into
/// reactions (`reactionTo`). Each function returns the t of the first wall with t > `after`,
/// infinite if there is none.

/// For a contact: z_n = 0, or ‖z_t‖ = μ z_n > 0.
double nextWall(const Vec3& z, const Vec3& d, double mu, double after);
/// For a row: z at one of its bounds.
double nextWall(double z, double d, double lower, double upper, double after);

}  // namespace delassus
