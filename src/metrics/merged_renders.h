#pragma once

#include "image/image.h"

#include <array>

namespace orbs::metrics {

/// Renders of one scene with different seeds as one image, which grows: each counts by the samples that were
/// asked of it. Weights by what a render says of its own variance would pull towards those that have missed
/// bright light, as mean and variance of rare light go together.
///
/// Floats hold it: at 24 renders and a rounding of 2^-24 each, a sum of roundings is below 2e-6 of the value.
struct MergedRenders {
  image::Image mean;                   // every channel; "variance.*" is the variance of this mean
  std::array<image::Image, 2> halves;  // R, G, B of every other render: two images that share no sample
  int renders = 0;
  int samples = 0;              // per pixel, of all of them
  bool states_variance = true;  // the renders have variances; else the scatter of the renders tells
};

/// Adds two renders of `spp` samples each to the image, one to either half.
///
/// Variances that the renders state: V = sum n^2 v / N^2. Else V = M2 / ((m - 1) N) with M2 = sum n (x - X)^2
/// over m renders, as one of n samples has the variance s^2 / n (Welford 1962; Chan, Golub and LeVeque 1983).
/// InputError when sizes or channels differ, and for the first two when they are equal to the bit, as those
/// of a renderer that ignores its seed are.
void add_renders(MergedRenders& merged, const std::array<image::Image, 2>& two, int spp);

/// The halves in one image, to be kept in a file: "first.R" and so on.
image::Image halves_image(const MergedRenders& merged);

/// The halves in such an image. InputError when channels are missing.
std::array<image::Image, 2> halves_of(const image::Image& halves);

/// From such an image and the mean of all. InputError when channels are missing.
MergedRenders merged_renders_of(image::Image mean, const image::Image& halves, int renders, int samples);

}  // namespace orbs::metrics
