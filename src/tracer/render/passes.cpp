#include "tracer/render/passes.h"

#include "tracer/sampling/sampler.h"

#include <algorithm>
#include <bit>

namespace orbs::tracer {

namespace {

constexpr int kTile = 16;            // pixels a side
constexpr int kSamplesPerPass = 32;  // between two checks of the stop flag

int tiles_across(int length) { return (length + kTile - 1) / kTile; }

}  // namespace

std::vector<Pass> plan_passes(int samples_per_pixel, int replicates) {
  const auto wanted = static_cast<std::uint32_t>(samples_per_pixel);
  const std::uint32_t share = wanted / static_cast<std::uint32_t>(replicates);
  const std::uint32_t length = std::clamp(replicates == 1 ? share : std::bit_floor(share), 1U, kBlock);
  std::vector<Pass> passes;
  for (std::uint32_t start = 0; start < wanted; start += length) {
    const std::uint32_t end = std::min(length, wanted - start);
    for (std::uint32_t first = 0; first < end; first += kSamplesPerPass) {
      const std::uint32_t count = std::min<std::uint32_t>(kSamplesPerPass, end - first);
      passes.push_back({start / length, first, count, end, first + count == end});
    }
  }
  return passes;
}

int tile_count(const Film& film) { return tiles_across(film.width) * tiles_across(film.height); }

Tile tile_at(const Film& film, int index) {
  const int columns = tiles_across(film.width);
  const int x0 = index % columns * kTile;
  const int y0 = index / columns * kTile;
  return {x0, y0, std::min(x0 + kTile, film.width), std::min(y0 + kTile, film.height)};
}

}  // namespace orbs::tracer
