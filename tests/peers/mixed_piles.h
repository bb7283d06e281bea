#pragma once

#include <vector>

#include "delassus/problem.h"

namespace delassus::peers {

/// Square pyramids of 14, 55 and 140 boxes, 116 to 1652 contacts, every other layer 1e3 and 1e6
/// times as heavy, all in motion; in body space.
std::vector<Problem> mixedPiles();

}  // namespace delassus::peers
