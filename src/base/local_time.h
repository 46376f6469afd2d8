#pragma once

#include <array>
#include <ctime>
#include <string>

namespace orbs {

/// The local time in the format of strftime. The default is ISO 8601: "2026-11-21T14:03:00".
inline std::string local_time_now(const char* format = "%Y-%m-%dT%H:%M:%S") {
  const std::time_t now = std::time(nullptr);
  std::tm local{};
  ::localtime_r(&now, &local);
  std::array<char, 64> text{};
  std::strftime(text.data(), text.size(), format, &local);
  return text.data();
}

}  // namespace orbs
