#pragma once

#include "tracer/render/film.h"

#include <cstdint>
#include <vector>

/// Passes and tiles, the units of work of a rendering.
namespace orbs::tracer {

/// Samples [first, first + count) of replicate `replicate` of every pixel.
struct Pass {
  std::uint32_t replicate = 0;
  std::uint32_t first = 0;
  std::uint32_t count = 0;
  std::uint32_t length = 0;  // of the whole replicate
  bool ends_replicate = false;
};

struct NumberedPass {
  std::uint32_t number = 0;  // of the pass within the rendering
  Pass pass;
};

/// Passes of at most 32 samples. The length of a replicate is a power of two, for which the points are
/// stratified, chosen so that there are at least `replicates` of them, or as many as samples if those are
/// fewer. A single replicate has all samples, up to kBlock.
std::vector<Pass> plan_passes(int samples_per_pixel, int replicates);

struct Tile {
  int x0 = 0;
  int y0 = 0;
  int x1 = 0;
  int y1 = 0;
};

int tile_count(const Film& film);
Tile tile_at(const Film& film, int index);

}  // namespace orbs::tracer
