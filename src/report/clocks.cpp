#include "report/clocks.h"

#include <optional>

#include <fmt/format.h>

namespace orbs::report {

namespace {

// A start takes a part of each render, and another process may slow it down: only what neither explains.
constexpr double kLeastShare = 0.05;
constexpr double kMostShare = 1.1;
constexpr double kLeastWall_s = 1;

struct Clocks {
  double wall_s = 0;
  double cpu_s = 0;
  std::optional<double> stated_s;  // where every render states it
};

Clocks clocks_of(const results::RunRecord& run, const std::string& renderer) {
  Clocks clocks;
  bool all_state = true;
  double stated_s = 0;
  for (const auto& job : run.jobs) {
    if (job.identity.renderer != renderer || job.cost.started.empty()) continue;
    clocks.wall_s += job.cost.wall_seconds;
    clocks.cpu_s += job.cost.cpu_seconds;
    all_state = all_state && job.cost.render_seconds;
    stated_s += job.cost.render_seconds.value_or(0);
  }
  if (all_state && clocks.wall_s > 0) clocks.stated_s = stated_s;
  return clocks;
}

bool uses_no_cpu(const Clocks& clocks) {
  return clocks.wall_s >= kLeastWall_s && clocks.cpu_s < kLeastShare * clocks.wall_s;
}

}  // namespace

std::string clocks_text(const results::RunRecord& run, const std::string& renderer) {
  const auto clocks = clocks_of(run, renderer);
  if (clocks.wall_s < kLeastWall_s) return {};
  std::string text;
  if (uses_no_cpu(clocks))
    text = fmt::format(
        "its processes ran for {:.2g} s and used {:.2g} s of CPU: it waits, or renders on another device or in a "
        "process that orbs did not start, so its CPU time is not compared",
        clocks.wall_s, clocks.cpu_s);
  if (!clocks.stated_s ||
      (*clocks.stated_s >= kLeastShare * clocks.wall_s && *clocks.stated_s <= kMostShare * clocks.wall_s))
    return text;
  return fmt::format(
      "{}{}it states {:.2g} s of rendering where its processes ran for {:.2g} s, which is what counts", text,
      text.empty() ? "" : "; ", *clocks.stated_s, clocks.wall_s);
}

bool renders_elsewhere(const results::RunRecord& run, const std::string& renderer) {
  return uses_no_cpu(clocks_of(run, renderer));
}

}  // namespace orbs::report
