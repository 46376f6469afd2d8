#pragma once

#include <algorithm>
#include <string>

#include <fmt/format.h>

namespace orbs {

/// "45 s", "12 min", "5.2 h"; at least a second.
inline std::string duration_text(double seconds) {
  constexpr double kMinute = 60;
  constexpr double kHour = 3600;
  if (seconds < 1.5 * kMinute) return fmt::format("{:.0f} s", std::max(seconds, 1.0));
  if (seconds < 1.5 * kHour) return fmt::format("{:.0f} min", seconds / kMinute);
  return fmt::format("{:.1f} h", seconds / kHour);
}

}  // namespace orbs
