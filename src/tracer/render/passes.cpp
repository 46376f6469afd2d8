#include "tracer/render/passes.h"

#include "tracer/sampling/sampler.h"

#include <algorithm>
#include <bit>

namespace orbs::tracer {

namespace {

constexpr int kTile = 16;                      // pixels a side
constexpr std::uint32_t kSamplesPerPass = 32;  // between two checks of the stop flag

int tiles_across(int length) { return (length + kTile - 1) / kTile; }

}  // namespace

Pieces pieces_of(int samples_per_pixel) {
  constexpr std::uint32_t kMostPieces = 8;
  const auto samples = std::bit_floor(static_cast<std::uint32_t>(samples_per_pixel));
  const std::uint32_t count = std::min(samples, kMostPieces);
  return {.count = static_cast<int>(count), .length = static_cast<int>(samples / count)};
}

std::vector<Pass> plan_passes(int samples_per_pixel, Pieces pieces) {
  const auto wanted = static_cast<std::uint32_t>(samples_per_pixel);
  const auto length = static_cast<std::uint32_t>(pieces.length);
  const std::uint32_t in_pieces = static_cast<std::uint32_t>(pieces.count) * length;
  const std::uint32_t together = pieces.share_passes ? std::max(1U, kSamplesPerPass / length) : 1;
  std::vector<Pass> passes;
  for (std::uint32_t sample = 0; sample < wanted;) {
    const std::uint32_t block = sample / kBlock;
    const std::uint32_t block_end = std::min(wanted, (block + 1) * kBlock);
    const bool is_in_piece = sample < in_pieces;
    const std::uint32_t pieces_end =
        is_in_piece ? std::min(in_pieces, (sample / length + together) * length) : wanted;
    const std::uint32_t end = std::min({sample + kSamplesPerPass, block_end, pieces_end});
    const std::uint32_t ended = is_in_piece ? end / length - sample / length : end == wanted ? 1 : 0;
    passes.push_back({block, sample - block * kBlock, end - sample, block_end - block * kBlock,
                      static_cast<int>(std::min(sample, in_pieces) / length), ended});
    sample = end;
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
