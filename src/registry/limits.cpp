#include "registry/limits.h"

#include <fmt/format.h>

namespace orbs::registry {

namespace {

constexpr double kMostMegabytes = 1 << 30;
constexpr double kLeastMegabytes = 1;
constexpr double kLeastSeconds = 0.01;

std::size_t bytes_of(json::ObjectReader& in, const char* key) {
  constexpr double kMegabyte = 1 << 20;
  return static_cast<std::size_t>(in.number(key, {0, kMostMegabytes}) * kMegabyte);
}

// A limit below which the fault would be the limit's, whatever is rendered.
void refuse_below(json::ObjectReader& in, const char* key, double least) {
  if (in.has(key) && in.number(key) < least)
    in.fail(key,
            fmt::format("must be at least {}, or no render ends well; leave it out for no limit of its own",
                        least));
}

}  // namespace

void read_limits(json::ObjectReader in, ProcessLimits& limits) {
  for (const char* key : {"wall_seconds", "cpu_seconds"}) refuse_below(in, key, kLeastSeconds);
  for (const char* key : {"memory_megabytes", "output_megabytes"}) refuse_below(in, key, kLeastMegabytes);
  limits.wall_seconds = in.number_or("wall_seconds", limits.wall_seconds, json::kPositive);
  limits.grace_seconds = in.number_or("grace_seconds", limits.grace_seconds, json::kNotNegative);
  if (in.has("cpu_seconds")) limits.cpu_seconds = in.number("cpu_seconds", json::kPositive);
  if (in.has("memory_megabytes")) limits.memory_bytes = bytes_of(in, "memory_megabytes");
  if (in.has("output_megabytes")) limits.output_bytes = bytes_of(in, "output_megabytes");
  if (in.has("log_megabytes")) limits.log_bytes = bytes_of(in, "log_megabytes");
  in.finish();
}

}  // namespace orbs::registry
