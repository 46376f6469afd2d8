#include "metrics/noise_numbers.h"

#include <array>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::metrics {

namespace {

constexpr std::array<std::string_view, 3> kRatioNames{"mean_ratio_r", "mean_ratio_g", "mean_ratio_b"};

// Each text says it for both sources, as a definition must not change with the image.
constexpr std::string_view kRatio =
    "mean(result) / mean(reference) - 1 of one channel over all unmasked pixels; linear Rec.709, no "
    "clamp. The interval leaves out a right image in 1 of 9000 (delta method, Student's distribution), "
    "by the variances of both images, by the scatter of neighbouring 8 x 8 px blocks where the result "
    "has none, or by the reference's alone where its renderer has no noise";
constexpr std::string_view kNoise =
    "mean over R, G, B of all unmasked pixels of the variances of both images; by half the squared "
    "difference of the errors of horizontal neighbours where the result has no variance; that of the "
    "reference alone where the result's renderer has no noise; linear Rec.709, no clamp";
constexpr std::string_view kBias =
    "mse - noise_squared: the part of the mean squared error that noise does not explain, below zero by "
    "chance. The interval leaves out a right image in 1 of 3000";
constexpr std::string_view kBlocksOff =
    "how many means of 8 x 8 px blocks, each channel one, differ from the reference by more than noise "
    "and 0.1 % (Student's test, Benjamini and Hochberg's correction; in 1 of 3000 right images it is not "
    "0)";
constexpr std::string_view kBlockScore =
    "the largest |z| of any 8 x 8 px block: difference of the means over its standard deviation; linear "
    "Rec.709, no clamp";
constexpr std::string_view kPixelScore =
    "the largest |z| of any pixel and channel: difference over its standard deviation, which is at least "
    "that of the 8 x 8 px around; linear Rec.709, no clamp. It points at a place and decides nothing";
constexpr std::string_view kPixelsBeyond =
    "share of pixels and channels with |z| above 3; 0.0027 where noise is normally distributed";

std::string percent(double value) { return fmt::format("{:+.3g} %", 100 * value); }

std::string ratios_text(const NoiseTest& test) {
  constexpr std::array kChannels{"R", "G", "B"};
  std::vector<std::string> parts;
  for (std::size_t c = 0; c < 3; ++c)
    if (const auto& ratio = test.mean_ratio.at(c))
      parts.push_back(fmt::format("{} {} ({} to {})", kChannels.at(c), percent(ratio->value),
                                  percent(ratio->low), percent(ratio->high)));
  return fmt::format("{}", fmt::join(parts, ", "));
}

}  // namespace

std::vector<NoiseNumber> noise_numbers(const NoiseTest& test) {
  std::vector<NoiseNumber> numbers;
  for (std::size_t c = 0; c < 3; ++c)
    if (const auto& ratio = test.mean_ratio.at(c))
      numbers.push_back({kRatioNames.at(c), "1", kRatio, true, ratio->value, ratio->low, ratio->high, {}});
  numbers.push_back({"noise_squared", "radiance^2", kNoise, false, test.noise_squared, {}, {}, {}});
  const auto& bias = test.bias_squared;
  numbers.push_back({"bias_squared", "radiance^2", kBias, true, bias.value, bias.low, bias.high, {}});
  if (test.blocks) {
    const auto& blocks = *test.blocks;
    numbers.push_back(
        {"blocks_off", "blocks", kBlocksOff, false, static_cast<double>(blocks.off), {}, {}, {}});
    numbers.push_back({"block_z_max", "1", kBlockScore, false, blocks.largest, {}, {}, blocks.where});
  }
  if (test.pixels) {
    const auto& pixels = *test.pixels;
    numbers.push_back({"pixel_z_max", "1", kPixelScore, false, pixels.largest, {}, {}, pixels.where});
    numbers.push_back({"pixels_beyond_3", "1", kPixelsBeyond, false, pixels.share_beyond_3, {}, {}, {}});
  }
  return numbers;
}

std::string bias_remark(const NoiseTest& test) {
  if (const auto worst = mean_error(test))
    return fmt::format("bias: the mean is {} than that of the reference by more than noise: {}",
                       worst->value > 0 ? "brighter" : "darker", ratios_text(test));
  if (test.blocks && test.blocks->off > 0) {
    const auto& where = test.blocks->where;
    return fmt::format("bias: {} of {} block means differ by more than noise, most in [{},{},{},{}]",
                       test.blocks->off, test.blocks->tested, where.x0, where.y0, where.x1, where.y1);
  }
  return "";
}

std::string bias_message(const NoiseTest& test) {
  if (auto remark = bias_remark(test); !remark.empty()) return remark;
  if (is_square_biased(test))
    return fmt::format(
        "bias: noise explains {:.3g} of the mean squared error, {:.3g} is left ({:.3g} to {:.3g})",
        test.noise_squared, test.bias_squared.value, test.bias_squared.low, test.bias_squared.high);
  return "";
}

}  // namespace orbs::metrics
