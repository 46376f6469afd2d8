#pragma once

#include <chrono>
#include <map>
#include <optional>
#include <string>

namespace orbs::cli {

/// How long the renders of a run will still take: by what was expected of each, corrected by what those of
/// the same renderer have taken so far.
class TimeLeft {
 public:
  using Clock = std::chrono::steady_clock;

  /// A render that has not ended. `seconds`: that it is expected to take, if anything is.
  void add(const std::string& id, const std::string& renderer, std::optional<double> seconds);
  void started(const std::string& id, Clock::time_point now);
  void ended(const std::string& id, double seconds);
  bool is_over() const { return waiting_.empty(); }

  /// Nothing where nothing is known of a render. `at_once`: so many are rendered at a time.
  std::optional<double> seconds(Clock::time_point now, int at_once) const;

 private:
  struct Render {
    std::string renderer;
    std::optional<double> seconds;
    std::optional<Clock::time_point> since;  // that it runs
  };
  // What the renders of one renderer took, and were expected to take.
  struct Seen {
    double seconds = 0;
    double expected_seconds = 0;
    double unexpected_seconds = 0;  // of those of which nothing was expected
    int unexpected = 0;
  };

  std::optional<double> expected_seconds(const Render& render) const;

  std::map<std::string, Render> waiting_;  // by id
  std::map<std::string, Seen> seen_;       // by renderer
};

}  // namespace orbs::cli
