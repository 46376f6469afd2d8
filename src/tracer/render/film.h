#pragma once

#include "base/vec.h"
#include "image/image.h"

#include <cstdint>
#include <vector>

namespace orbs::tracer {

/// Sums of the camera paths of one pixel, in double precision and in the order of the samples.
struct PixelSums {
  Vec3d finished;  // sum of the samples of finished pieces
  double finished_count = 0;
  Vec3d current;  // of the piece that has begun
  double current_count = 0;
};

/// Adds a finite sample.
void add_sample(PixelSums& pixel, Vec3d radiance);
/// Of the finished pieces, without light paths.
Vec3d mean_of(const PixelSums& pixel);

/// Samples that were not finite. They are excluded from the image, counted, and reported with the first pixel
/// in scanline order.
struct BadSamples {
  std::uint64_t count = 0;
  int first_x = -1;
  int first_y = -1;
};

void merge(BadSamples& all, const BadSamples& more);

struct CameraPixel {
  int x = 0;
  int y = 0;
};

struct Film {
  int width = 0;
  int height = 0;
  std::vector<CameraPixel> camera_pixels;  // that its pixels stand for; empty: those at the same place
  std::vector<PixelSums> pixels;
  std::vector<Vec3d> splats;           // of the current piece, from light paths; empty unless some are traced
  std::vector<Vec3d> finished_splats;  // of the finished pieces; as many
  std::vector<std::vector<Vec3f>> pieces;        // [piece][pixel], means of camera paths; see passes.h
  std::vector<std::vector<Vec3f>> splat_pieces;  // the same of light paths
  std::vector<std::vector<Vec3d>> class_sums;    // [path class][pixel], empty if the class never occurred
  std::vector<std::vector<Vec3d>> stokes;        // sums of S1 to S3; empty without Stokes output
};

Film make_film(int width, int height);

/// The place of a pixel in film.pixels.
inline std::size_t pixel_index(const Film& film, int x, int y) {
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(film.width) + static_cast<std::size_t>(x);
}

/// The mean of a pixel with what light paths add.
Vec3d mean_of(const Film& film, std::size_t pixel);

/// That pixel `pixel`, at (x, y) of the film, stands for.
inline CameraPixel camera_pixel(const Film& film, std::size_t pixel, int x, int y) {
  return film.camera_pixels.empty() ? CameraPixel{x, y} : film.camera_pixels[pixel];
}

/// Ends the current piece of a pixel, and keeps its mean if it is one of film.pieces.
void end_piece(Film& film, std::size_t pixel, int piece);

/// R, G, B and, if there are variances, variance.R, .G, .B; with class sums also path.<class>.R, .G, .B,
/// which add up to R, G, B; with Stokes parameters S0.R to S3.B, S0 being R, G, B again. `variances`: of the
/// means, one of each pixel, or none at all.
image::Image resolve(const Film& film, const std::vector<Vec3d>& variances);

}  // namespace orbs::tracer
