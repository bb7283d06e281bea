#pragma once

#include <cstdint>
#include <vector>

#include "demos/render/film.h"
#include "demos/render/view.h"

namespace demos::render {

/// One copy of a mesh, laid out as the vertex shader reads it.
struct Instance {
  float matrix[16];      ///< column by column
  float tint[4];         ///< linear colour; alpha below 1 is glass
  std::uint32_t tag[2];  ///< number of the thing; 1 for terrain
};

/// All copies of one mesh, one after the other.
struct Batch {
  int mesh;
  std::size_t first, count;
};
struct Batches {
  std::vector<Batch> solid, glass;
  std::vector<Instance> instances;
};

/// The instances of a frame, sorted by mesh. Colours tell the kinds of things: movable ones take
/// turns in four calm tones, heavy ones are dark, fixed ones grey. A plane seen from behind is
/// glass.
Batches batchesOf(const Film& film, const Frame& frame, const View& view, const Box& stage);

/// The mass from which on a thing counts as heavy, kg: ten times the median of the movable things,
/// and not much less than the heaviest.
double heavyFrom(const Film& film);

}  // namespace demos::render
