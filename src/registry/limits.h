#pragma once

#include "base/process_limits.h"
#include "json/fields.h"

#include <optional>

namespace orbs::registry {

/// Limits as configuration.json states them, for the whole file or in the entry of a renderer. What is not
/// stated there stays as it is.
struct LimitSettings {
  std::optional<double> wall_seconds;
  std::optional<double> cpu_seconds;
  std::optional<double> memory_megabytes;  // 2^20 bytes each
  std::optional<double> output_megabytes;
  std::optional<double> log_megabytes;
  std::optional<double> grace_seconds;
};

template <class Visitor, json::RecordOf<LimitSettings> Limits>
void fields(Visitor& visit, Limits& limits) {
  // Below these the fault would be the limit's, whatever is rendered.
  constexpr json::Range kSeconds{0.01, json::kPositive.max};
  constexpr json::Range kMegabytes{1, 1 << 30};
  constexpr std::string_view kAdvice = "or no render ends well; leave it out for that of all renderers";
  visit("wall_seconds", limits.wall_seconds,
        {.help = "Wall-clock time; then SIGTERM", .range = kSeconds, .advice = kAdvice, .unset = "600"});
  visit("cpu_seconds", limits.cpu_seconds,
        {.help = "User and system time of all processes",
         .range = kSeconds,
         .advice = kAdvice,
         .unset = "none"});
  visit(
      "memory_megabytes", limits.memory_megabytes,
      {.help = "Memory of all processes that no file on a disk backs, shared pages and files in memory once; "
               "2^20 bytes each",
       .range = kMegabytes,
       .advice = kAdvice,
       .unset = "none"});
  visit("output_megabytes", limits.output_megabytes,
        {.help = "All files in the folder of the render, and any single file",
         .range = kMegabytes,
         .advice = kAdvice,
         .unset = "none"});
  visit("log_megabytes", limits.log_megabytes,
        {.help = "What is kept of its output; the middle of a longer log is left out",
         .range = {0, kMegabytes.max},
         .unset = "1"});
  visit("grace_seconds", limits.grace_seconds,
        {.help = "From SIGTERM to SIGKILL", .range = json::kNotNegative, .unset = "2"});
}

/// Takes what is stated over into `limits`; the rest stays as it is.
void apply(const LimitSettings& stated, ProcessLimits& limits);

}  // namespace orbs::registry
