#pragma once

#include <cmath>
#include <string>

#include <fmt/format.h>

namespace orbs {

/// A number of at least 0 by its first two digits, without an exponent: "2.8", "28", "27000". For estimates.
inline std::string two_digits(double number) {
  if (!(number >= 99.5) || !std::isfinite(number)) return fmt::format("{:.2g}", number);
  const double unit = std::pow(10, std::floor(std::log10(number)) - 1);
  return fmt::format("{:.0f}", std::round(number / unit) * unit);
}

}  // namespace orbs
