#pragma once

#include <string>

namespace orbs {

/// Now in local time, in the format of strftime: by default ISO 8601, "2026-11-21T14:03:00".
std::string local_time_now(const char* format = "%Y-%m-%dT%H:%M:%S");

}  // namespace orbs
