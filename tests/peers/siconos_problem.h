#pragma once

#include <FrictionContactProblem.h>

#include <memory>

#include "delassus/problem.h"

namespace delassus::peers {

/// How W is stored for Siconos: only the 3x3 blocks that are not zero, or all of it. Its third
/// form, compressed columns, was slower than one of these wherever it was tried.
enum class Storage { Blocks, Dense };

using SiconosProblem =
    std::unique_ptr<FrictionContactProblem, decltype(&frictionContactProblem_free)>;

/// `problem` as Siconos states it: the same letters, signs and order of unknowns. Contacts only.
SiconosProblem siconosProblem(const Problem& problem, Storage storage);

}  // namespace delassus::peers
