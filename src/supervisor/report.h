#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace orbs::supervisor {

/// Why the supervisor ended a command; Nothing when it ended by itself.
enum class Cause { Nothing, WallTime, CpuTime, Memory, Output, Stopped };

/// How a command ended and which resources it used.
struct Report {
  std::string start_error;  // why it could not be started; "" when it was
  Cause cause = Cause::Nothing;
  int exit_code = 0;  // when no signal ended it
  int signal = 0;     // that ended it; 0 for none
  bool core_dumped = false;
  double wall_seconds = 0;            // from its start to the end of the command itself
  double user_seconds = 0;            // of it and all its descendants
  double system_seconds = 0;          // likewise
  std::size_t peak_rss_bytes = 0;     // of the largest process (the kernel's count), or of all together with
                                      // their files in memory when seen larger; shared pages count once
  int left_behind = 0;                // processes that outlived the command
  double supervisor_cpu_seconds = 0;  // of the supervisor itself
};

/// One "key value" a line, for the pipe between the supervisor and whoever started it.
std::string report_text(const Report& report);

/// Reads report_text; nothing when the text is cut off or no report.
std::optional<Report> parse_report(std::string_view text);

}  // namespace orbs::supervisor
