#pragma once

#include "delassus/problem.h"

namespace delassus {

/// The same problem without rows, for formats and solvers that know only contacts. First come its
/// contacts, with the same r and u, then one more contact for each row with a finite bound.
///
///     equations (no bound):  r_e = −W_ee⁺ (W_ec r_c + q_e) is substituted:
///                            W_cc − W_ce W_ee⁺ W_ec,  q_c − W_ce W_ee⁺ q_e
///     one bound:             a contact of μ = 0 whose r_n is the distance from the bound
///     two bounds:            the first tangent of a contact that is pressed with r_n = 1 by
///                            nothing else (W_nn = 1, q_n = −1);
///                            μ is half their distance, r_t1 the distance from the middle
///
/// W must be symmetric: W_ce is taken from W_ec. Unused unknowns are uncoupled and have q = 0:
/// their reactions are zero. Throws std::invalid_argument for rolling and spinning friction, for
/// equations that no reactions meet, and for entries with |W_ij − W_ji| > 1e-9 √|W_ii W_jj|.
Problem contactForm(const Problem& problem);

}  // namespace delassus
