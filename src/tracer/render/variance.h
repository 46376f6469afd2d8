#pragma once

#include "base/vec.h"
#include "tracer/render/film.h"

#include <cstdint>
#include <vector>

/// The variance of pixels whose samples are one sequence.
///
/// The points of a scrambled sequence are so even that what they scatter by says little of the error of their
/// mean: it may be a fiftieth of what independent points would have, or as large. So some pixels are rendered
/// a second time with another scrambling (replicates, as of randomised quasi-Monte Carlo; Owen 1995). Half
/// the squared difference of a pixel and its replicate is the variance, without bias. Over many of them it
/// says how large the variance is beside the scatter of the pieces within a sequence, and that holds for
/// pixels of like scatter and brightness, too.
///
/// A few pixels at the edges of a lamp can have more variance than all others together. So the pixels form
/// groups of like scatter, as large as suits both the sum over the image and the single pixel, and each has
/// as many replicates.
namespace orbs::tracer {

/// Like pixels.
struct LikePixels {
  std::vector<std::uint32_t> pixels;  // in the order of a hash
  std::size_t replicates = 0;         // so many of them, the first ones, are rendered a second time
};

/// One pixel of 16, at least 512, at most all.
std::size_t replicate_count(std::size_t pixels);

/// The mean squared distance of the first `count` pieces of each pixel from their mean. `pieces`: film.pieces
/// or film.splat_pieces.
std::vector<Vec3d> scatter_of(const std::vector<std::vector<Vec3f>>& pieces, int count);

/// Groups with replicate_count() replicates or somewhat fewer in all. `scatter`: of film.pieces. `seed`: with
/// another one, other pixels have replicates.
std::vector<LikePixels> like_pixels(const Film& film, const std::vector<Vec3d>& scatter, std::uint64_t seed);

/// An empty film of all replicates, group after group, with as many pieces as `film` and without light paths.
Film film_of_replicates(const Film& film, const std::vector<LikePixels>& groups);

/// How many pieces of a film are whole, 2, 4 or 8, and which share of all samples they hold, in (0, 1].
struct WholePieces {
  int count = 0;
  double share = 1;
};

/// Variances of the pixels' means. `scatter`: of film.pieces. What light paths add is independent from piece
/// to piece.
std::vector<Vec3d> variances_of_means(const Film& film,
                                      const std::vector<Vec3d>& scatter,
                                      const std::vector<LikePixels>& groups,
                                      const Film& replicates,
                                      WholePieces pieces);

/// Whether the largest variance is a normal float with room for the digits of smaller ones: radiances from
/// about 1e19 on, or of 1e-16 at most, have squares that no float holds. Noise below the rounding of the
/// colours needs no holding.
bool float_holds_variances(const Film& film, const std::vector<Vec3d>& variances);

}  // namespace orbs::tracer
