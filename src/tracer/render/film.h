#pragma once

#include "base/vec.h"
#include "image/image.h"

#include <cstdint>
#include <vector>

namespace orbs::tracer {

/// Sums of one pixel, in double precision and in the order of the samples. The variance is estimated from
/// replicates, which are independently scrambled blocks of samples: the points within one block are
/// stratified, and their own scatter would overestimate the noise of the mean by up to a factor of ten.
struct PixelSums {
  Vec3d finished;          // sum of the samples of finished replicates
  Vec3d weighted_squares;  // sum over finished replicates of (sum of its samples)^2 / its count
  double finished_count = 0;
  double replicates = 0;
  Vec3d current;
  double current_count = 0;
};

/// Adds a finite sample.
void add_sample(PixelSums& pixel, Vec3d radiance);
/// Ends the current replicate; does nothing if it has no samples.
void end_replicate(PixelSums& pixel);
Vec3d mean_of(const PixelSums& pixel);
/// Variance of the mean, estimated from the means of the replicates weighted by their counts; zero with less
/// than two replicates.
Vec3d variance_of_mean(const PixelSums& pixel);

/// Samples that were not finite. They are excluded from the image, counted, and reported with the first pixel
/// in scanline order.
struct BadSamples {
  std::uint64_t count = 0;
  int first_x = -1;
  int first_y = -1;
};

void merge(BadSamples& all, const BadSamples& more);

struct Film {
  int width = 0;
  int height = 0;
  std::vector<PixelSums> pixels;
  std::vector<std::vector<Vec3d>> class_sums;  // [path class][pixel], empty if the class never occurred
  std::vector<std::vector<Vec3d>> stokes;      // sums of S1 to S3; empty without Stokes output
  bool has_variance = true;  // its samples form more than one replicate, and float can hold the variances
};

Film make_film(int width, int height);

/// Whether the largest variance of the pixels is a normal float with room for the digits of smaller ones:
/// radiances from about 1e19 on, or of 1e-16 at most, have squares that no float holds. Noise
/// below the rounding of the colours needs no holding.
bool float_holds_variances(const Film& film);

/// R, G, B and, where the film has it, variance.R, .G, .B; with class sums also path.<class>.R, .G, .B, which
/// add up to R, G, B; with Stokes parameters S0.R to S3.B, S0 being R, G, B again.
image::Image resolve(const Film& film);

}  // namespace orbs::tracer
