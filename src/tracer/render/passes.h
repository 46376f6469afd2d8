#pragma once

#include "tracer/render/film.h"

#include <cstdint>
#include <optional>
#include <vector>

/// Passes and tiles, the units of work of a rendering.
namespace orbs::tracer {

/// The samples of a pixel are one sequence, of which every aligned run of 2^k points is stratified and, with
/// the run beside it, part of one twice as long that is, too (Owen 1995: scrambled nets in base 2). The first
/// samples form pieces of equal length, which is a power of two like their number; see variance.h.
struct Pieces {
  int count = 1;   // 1, 2, 4 or 8
  int length = 1;  // samples
  /// A pass may hold several whole pieces, which makes fuller batches. Not where light paths are traced: what
  /// they add to a pass belongs to one piece.
  bool share_passes = false;
};

Pieces pieces_of(int samples_per_pixel);

/// Samples [first, first + count) of block `block` of every pixel: blocks are the parts of a sequence that is
/// longer than the table of its points.
struct Pass {
  std::uint32_t block = 0;
  std::uint32_t first = 0;
  std::uint32_t count = 0;
  std::uint32_t length = 0;  // of the whole block
  int piece = 0;             // of the first sample; the first beyond the last for those after all pieces
  std::uint32_t ended_pieces = 0;  // of equal length, where it is more than one
};

/// The piece whose last sample is this one of the pass; nothing if it is inside of one.
inline std::optional<int> piece_ended_by(const Pass& pass, std::uint32_t index) {
  if (pass.ended_pieces == 0) return std::nullopt;
  const std::uint32_t length = pass.count / pass.ended_pieces;
  const std::uint32_t done = index - pass.first + 1;
  if (done % length != 0) return std::nullopt;
  return pass.piece + static_cast<int>(done / length) - 1;
}

struct NumberedPass {
  std::uint32_t number = 0;  // of the pass within the rendering
  Pass pass;
};

/// Passes of at most 32 samples of one piece, or of some whole pieces.
std::vector<Pass> plan_passes(int samples_per_pixel, Pieces pieces);

struct Tile {
  int x0 = 0;
  int y0 = 0;
  int x1 = 0;
  int y1 = 0;
};

int tile_count(const Film& film);
Tile tile_at(const Film& film, int index);

}  // namespace orbs::tracer
