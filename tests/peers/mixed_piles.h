#pragma once

#include <vector>

#include "delassus/problem.h"

namespace delassus::peers {

/// Square pyramids of 14, 55 and 140 boxes, with 116 to 1652 contacts, all in motion, in body
/// space. Every other layer is 1e3 or 1e6 times as heavy.
std::vector<Problem> mixedPiles();

}  // namespace delassus::peers
