#pragma once

#include "metrics/metric.h"

namespace orbs::metrics {

// The numbers of the noise test beside the mean ratios. Each definition holds for all noise sources, as it
// must not change with the image.

inline MetricResult compute_noise_squared(const ImagePair& pair) { return {pair.noise.noise_squared}; }

inline MetricResult compute_bias_squared(const ImagePair& pair) {
  const auto& bias = pair.noise.bias_squared;
  return {.value = bias.value, .low = bias.low, .high = bias.high};
}

inline MetricResult compute_shared_noise(const ImagePair& pair) {
  const auto& shared = pair.noise.shared_noise;
  if (!shared) return {std::nullopt};
  return {.value = shared->value, .low = shared->low, .high = shared->high};
}

inline MetricResult compute_blocks_off(const ImagePair& pair) {
  return {static_cast<double>(pair.noise.blocks.off)};
}

inline MetricResult compute_block_z_max(const ImagePair& pair) {
  return {.value = pair.noise.blocks.largest, .where = pair.noise.blocks.where};
}

// The index is that of kTestedBlocks_px.
template <std::size_t Scale>
MetricResult compute_smallest_error(const ImagePair& pair) {
  return {std::get<Scale>(pair.noise.blocks.scales).smallest_error};
}

inline MetricResult compute_pixel_z_max(const ImagePair& pair) {
  if (!pair.noise.pixels) return {std::nullopt};
  return {.value = pair.noise.pixels->largest, .where = pair.noise.pixels->where};
}

inline MetricResult compute_pixels_beyond_3(const ImagePair& pair) {
  if (!pair.noise.pixels) return {std::nullopt};
  return {pair.noise.pixels->share_beyond_3};
}

inline constexpr MetricInfo kNoiseSquared{
    "noise_squared",
    "radiance^2",
    Better::Lower,
    "mean over R, G, B of all unmasked pixels of the variances of both images; by half the squared "
    "difference of the errors of horizontal neighbours where the result has no variance; that of the "
    "reference alone where the result's renderer has no noise; linear Rec.709, no clamp",
    kNoMap,
    compute_noise_squared};

inline constexpr MetricInfo kBiasSquared{
    "bias_squared",
    "radiance^2",
    Better::NearZero,
    "mse - noise_squared: the part of the mean squared error that noise does not explain, below zero by "
    "chance; over R, G, B of all unmasked pixels; linear Rec.709, no clamp. The interval leaves out a right "
    "image in 1 of 7000",
    kNoMap,
    compute_bias_squared};

inline constexpr MetricInfo kSharedNoise{
    "shared_noise",
    "1",
    Better::NearZero,
    "share of the reference's own noise that the result holds: 1 + mean over blocks of 8 x 8 px without detail, by "
    "their smooth unmasked pixels, of the sum of (reference less the mean of its four neighbours) times (the same of "
    "the difference), over the variance of the former, that as stated or, where it is less, scaled to the mean of its "
    "squares; linear Rec.709, no clamp. 0 for an independent image, 1 for a copy; no value where the reference states no noise",
    kNoMap,
    compute_shared_noise};

inline constexpr MetricInfo kBlocksOff{
    "blocks_off",
    "blocks",
    Better::Lower,
    "how many means of the unmasked pixels of blocks of 8, 16, 32 and 64 px, each channel one, differ from the "
    "reference by more than noise and 0.1 % (Student's test, Benjamini and Hochberg's correction; in 1 of 7000 "
    "right images it is not 0); linear Rec.709, no clamp. By the variances of both images, or by the scatter of "
    "neighbouring pixels where the result has none",
    kNoMap,
    compute_blocks_off};

inline constexpr MetricInfo kBlockZMax{
    "block_z_max",
    "1",
    Better::Lower,
    "the largest |z| of any block of 8, 16, 32 or 64 px: difference of the means of its unmasked pixels over its "
    "standard deviation; linear Rec.709, no clamp",
    kNoMap,
    compute_block_z_max};

inline constexpr MetricInfo kSmallestError16{
    "smallest_error_16px",
    "1",
    Better::Lower,
    "the relative error of the mean of the unmasked pixels of a block of 16 x 16 px that the block test would find "
    "in nine of ten blocks; noise hides smaller ones; linear Rec.709, no clamp",
    kNoMap,
    compute_smallest_error<1>};

inline constexpr MetricInfo kSmallestError64{
    "smallest_error_64px",
    "1",
    Better::Lower,
    "the relative error of the mean of the unmasked pixels of a block of 64 x 64 px that the block test would find "
    "in nine of ten blocks; noise hides smaller ones; linear Rec.709, no clamp",
    kNoMap,
    compute_smallest_error<3>};

inline constexpr MetricInfo kPixelZMax{
    "pixel_z_max",
    "1",
    Better::Lower,
    "the largest |z| of any unmasked pixel and channel: difference over its standard deviation, which is at "
    "least that of the 8 x 8 px around; linear Rec.709, no clamp. It points at a place and decides nothing. "
    "No value where the result has no variance",
    kNoMap,
    compute_pixel_z_max};

inline constexpr MetricInfo kPixelsBeyond3{
    "pixels_beyond_3",
    "1",
    Better::Lower,
    "share of unmasked pixels and channels with |z| above 3; 0.0027 where noise is normally distributed; "
    "linear Rec.709, no clamp. No value where the result has no variance",
    kNoMap,
    compute_pixels_beyond_3};

}  // namespace orbs::metrics
