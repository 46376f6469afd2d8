#include "judge/psnr_bias.h"

#include "judge/noise.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace orbs::judge {

namespace {

struct BlockProduct {
  double sum = 0;
  double pixels = 0;
};

// The scatter of the blocks is known by as many numbers as there are blocks, so small images have smaller
// ones.
constexpr std::size_t kLeastBlocks = 16;

std::vector<Rectangle> enough_blocks(const metrics::PairSamples& samples) {
  int side = metrics::kBlock_px;
  auto blocks = metrics::blocks_of(samples, side);
  while (blocks.size() < kLeastBlocks && side > 1) blocks = metrics::blocks_of(samples, side /= 2);
  return blocks;
}

// Over the counted pixels of each block: the products of the two halves' errors, and in `squares` the sum of
// the squared errors of the whole image.
std::vector<BlockProduct> products_of(const metrics::ImagePair& pair, double& squares) {
  constexpr double kSteps = 255;
  const auto error = [&](const std::vector<float>& display, std::size_t i) {
    return kSteps * (static_cast<double>(display[i]) - static_cast<double>(pair.reference_display[i]));
  };
  std::vector<BlockProduct> blocks;
  for (const Rectangle& where : enough_blocks(pair)) {
    BlockProduct block;
    metrics::for_each_block_pixel(pair, where, [&](std::size_t pixel) {
      for (std::size_t i = 3 * pixel; i < 3 * pixel + 3; ++i) {
        block.sum += error(pair.half_display[0], i) * error(pair.half_display[1], i);
        squares += error(pair.result_display, i) * error(pair.result_display, i);
      }
      block.pixels += 1;
    });
    if (block.pixels > 0) blocks.push_back(block);
  }
  return blocks;
}

// The noise that the reference's variances make with the result's number of samples.
double expected_noise_of(const metrics::ImagePair& pair, double of_reference) {
  auto variances = pair.reference_variance;
  for (std::size_t i = 0; i < variances.size(); ++i)
    variances[i] *= static_cast<float>(pair.variance_ratio.at(i % 3));
  return of_reference + noise_mse_srgb8(variances, pair.reference, pair.included).value_or(0);
}

}  // namespace

std::optional<PsnrBias> psnr_bias(const metrics::ImagePair& pair) {
  if (pair.half_display[0].empty()) return std::nullopt;
  double squares = 0;
  const auto blocks = products_of(pair, squares);
  double sum = 0;
  double pixels = 0;
  for (const auto& block : blocks) {
    sum += block.sum;
    pixels += block.pixels;
  }
  metrics::PooledVariance scatter;
  for (const auto& block : blocks) {
    const double rest = block.sum - sum / pixels * block.pixels;
    scatter.add(rest * rest);
  }
  PsnrBias bias;
  bias.reference_noise = noise_mse_srgb8(pair.reference_variance, pair.reference, pair.included).value_or(0);
  bias.squared = sum / (3 * pixels) - bias.reference_noise;
  // Their scatter about their own mean is too small by the one degree that the mean takes; a single block has
  // none, and is sure of nothing.
  const auto count = static_cast<double>(blocks.size());
  bias.standard_error = count > 1 ? std::sqrt(scatter.sum * count / (count - 1)) / (3 * pixels)
                                  : std::numeric_limits<double>::infinity();
  bias.degrees = std::min(scatter.degrees(), std::max(count - 1, 1.0));
  bias.noise = std::max(0.0, squares / (3 * pixels) - std::max(bias.squared, 0.0));
  bias.expected_noise = std::max(bias.noise, expected_noise_of(pair, bias.reference_noise));
  return bias;
}

}  // namespace orbs::judge
