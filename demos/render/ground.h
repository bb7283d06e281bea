#pragma once

#include "demos/render/film.h"
#include "demos/render/view.h"

namespace demos::render {

/// Gives each endless plane of `film` a finite slab. It extends as far as the other planes and the
/// surroundings of `stage` allow; a level plane that is alone extends until its end is out of
/// sight.
void layPlanes(Film& film, const Box& stage);

}  // namespace demos::render
