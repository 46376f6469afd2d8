#pragma once

#include <string>

namespace orbs {

/// The local time in the format of strftime. The default is ISO 8601: "2026-11-21T14:03:00".
std::string local_time_now(const char* format = "%Y-%m-%dT%H:%M:%S");

}  // namespace orbs
