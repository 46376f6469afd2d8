#include "metrics/bias_message.h"

#include <array>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::metrics {

namespace {

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

std::string bias_remark(const NoiseTest& test) {
  if (const auto worst = mean_error(test))
    return fmt::format("bias: the mean is {} than that of the reference by more than noise: {}",
                       worst->value > 0 ? "brighter" : "darker", ratios_text(test));
  if (test.blocks && test.blocks->off > 0) {
    const auto& where = test.blocks->where;
    return fmt::format("bias: {} of {} block means differ by more than noise, most in {}", test.blocks->off,
                       test.blocks->tested, rectangle_text(where));
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
