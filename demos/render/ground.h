#pragma once

#include "demos/render/film.h"
#include "demos/render/view.h"

namespace demos::render {

/// Gives the endless planes of `film` a finite slab each: as far as the other planes and the
/// surroundings of `stage` let them go, or, for a level plane alone, so far that its end is out of
/// sight.
void layPlanes(Film& film, const Box& stage);

}  // namespace demos::render
