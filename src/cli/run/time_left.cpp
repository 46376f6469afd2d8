#include "cli/run/time_left.h"

#include <algorithm>

namespace orbs::cli {

void TimeLeft::add(const std::string& id, const std::string& renderer, std::optional<double> seconds) {
  waiting_[id] = {renderer, seconds, {}};
}

void TimeLeft::started(const std::string& id, Clock::time_point now) { waiting_[id].since = now; }

void TimeLeft::ended(const std::string& id, double seconds) {
  const auto found = waiting_.find(id);
  if (found == waiting_.end()) return;
  auto& seen = seen_[found->second.renderer];
  if (const auto expected = found->second.seconds) {
    seen.seconds += seconds;
    seen.expected_seconds += *expected;
  } else {
    seen.unexpected_seconds += seconds;
    ++seen.unexpected;
  }
  waiting_.erase(found);
}

// An estimate may be of another machine, of another size, or of an idle one.
std::optional<double> TimeLeft::expected_seconds(const Render& render) const {
  const auto found = seen_.find(render.renderer);
  if (found == seen_.end()) return render.seconds;
  const auto& seen = found->second;
  // So that the first renders, which take a fraction of a second, do not decide for hours.
  constexpr double kDoubt_seconds = 1;
  if (render.seconds)
    return *render.seconds * (seen.seconds + kDoubt_seconds) / (seen.expected_seconds + kDoubt_seconds);
  if (seen.unexpected > 0) return seen.unexpected_seconds / seen.unexpected;
  return std::nullopt;
}

std::optional<double> TimeLeft::seconds(Clock::time_point now, int at_once) const {
  double sum = 0;
  for (const auto& [id, render] : waiting_) {
    auto left = expected_seconds(render);
    if (!left) return std::nullopt;
    if (render.since) {
      // One that has taken longer than expected is expected to take a quarter more than it has.
      constexpr double kMore = 1.25;
      const double so_far = std::chrono::duration<double>(now - *render.since).count();
      left = std::max(*left, kMore * so_far) - so_far;
    }
    sum += *left;
  }
  return sum / at_once;
}

}  // namespace orbs::cli
