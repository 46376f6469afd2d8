#pragma once

#include "image/image.h"
#include "metrics/pair_samples.h"

#include <array>
#include <vector>

namespace orbs::metrics {

/// Noise that pixels have in common: a filter that splats samples over its neighbours, random numbers that
/// are repeated from tile to tile, or a part of each render that all of its pixels share. The variances of
/// single pixels do not hold it, but the two renders of each look show it, as they differ by nothing but
/// noise.
///
/// - Over areas: the squares of the sums of the difference over blocks are, on the mean over the blocks, as
/// many
///   times the sums of its variances as the sum over such an area is noisier than its pixels say.
/// - Over the image: the difference of the two means is one number per look. n samples in both renders give
/// it
///   the variance 4 s^2 / n, where s^2 is that of one sample of the mean, so L looks tell s^2 with L degrees
///   of freedom, whatever the pixels have in common.

/// How the two renders of one look differ.
struct RendersApart {
  int spp = 0;                    // of both together
  std::array<double, 3> means{};  // mean of the first render less that of the second, linear R, G, B
};

RendersApart renders_apart(const image::Image& first, const image::Image& second, int spp_of_both);

/// One look says little: an error of the mean that is to be certain is no smaller than the reach of Student's
/// distribution with this probability outside. At ten looks that leaves out a right image in 1 of 500 at most
/// if all pixels have all of their noise in common, and next to none else.
constexpr double kOutsideCommon = 2e-4;

/// From the looks of an image: the standard error of its mean in each channel, and its degrees of freedom.
CommonNoise common_noise_of(const std::vector<RendersApart>& looks);

/// How many times the variance that its pixels state the sum over an area has, by the blocks of 8 and 16 px
/// of the two halves of the samples; without the difference of their means. 1 where it is not more than
/// chance makes it.
AreaNoise area_noise(const PairSamples& samples, const std::array<image::Image, 2>& halves);

/// How far noise that all pixels have in common may move the mean of the image in this channel; 0 where
/// nothing is known of it.
double common_reach(const PairSamples& samples, std::size_t channel);

/// The same as a share of the mean of the reference.
double common_share(const PairSamples& samples, std::size_t channel);

}  // namespace orbs::metrics
