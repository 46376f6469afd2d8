#include "history/time_changes.h"

#include "base/statistics.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include <fmt/format.h>

namespace orbs::history {

namespace {

struct TimedRender {
  const JobPair* jobs;
  double log_ratio;
};

using Renders = std::map<std::string, std::vector<TimedRender>>;  // by renderer

struct Sample {
  double mean = 0;
  double deviation = 0;  // of one value
  double count = 0;
};

Sample sample_of(const std::vector<TimedRender>& renders, const TimedRender* left_out) {
  Sample sample;
  for (const auto& render : renders)
    if (&render != left_out) {
      sample.mean += render.log_ratio;
      ++sample.count;
    }
  sample.mean /= sample.count;
  double squares = 0;
  for (const auto& render : renders)
    if (&render != left_out) squares += (render.log_ratio - sample.mean) * (render.log_ratio - sample.mean);
  sample.deviation = std::sqrt(squares / (sample.count - 1));
  return sample;
}

// Of a change by more than kLeastTime in either direction.
double probability_of(double log_change, double error, double degrees) {
  const double beyond = std::fabs(log_change) - std::log1p(kLeastTime);
  if (!(beyond > 0)) return 1;
  return student_tail(beyond / error, degrees);
}

void describe(double before_seconds, double after_seconds, Change& change) {
  change.quantity = Quantity::Time;
  change.direction = after_seconds > before_seconds ? Direction::Worse : Direction::Better;
  change.before = fmt::format("{:.2f} s", before_seconds);
  change.after =
      fmt::format("{:.2f} s ({:+.1f} %)", after_seconds, 100 * (after_seconds / before_seconds - 1));
  change.size = std::fabs(std::log(after_seconds / before_seconds));
}

// The renders of all other renderers, by which a machine that is slower as a whole shows.
std::vector<TimedRender> other_renders(const Renders& all, const std::string& renderer) {
  std::vector<TimedRender> others;
  for (const auto& [name, renders] : all)
    if (name != renderer) others.insert(others.end(), renders.begin(), renders.end());
  return others;
}

void test_renderer(const Renders& all, const std::string& renderer, std::vector<Candidate>& candidates) {
  constexpr std::size_t kFewest = 3;
  constexpr std::size_t kFewestOthers = 6;
  const auto& renders = all.at(renderer);
  if (renders.size() < kFewest) return;
  const auto sample = sample_of(renders, nullptr);
  double change = sample.mean;
  bool others_moved_more = false;
  double variance = sample.deviation * sample.deviation / sample.count;
  if (const auto others = other_renders(all, renderer); others.size() >= kFewestOthers) {
    const auto rest = sample_of(others, nullptr);
    change -= rest.mean;
    // Of two renderers that have moved apart, the one that moved is named.
    others_moved_more = std::fabs(rest.mean) > std::fabs(sample.mean);
    variance += rest.deviation * rest.deviation / rest.count;
  }
  double before = 0;
  for (const auto& render : renders) before += render.jobs->before->cost.cpu_seconds;
  Candidate candidate;
  candidate.change.renderer = renderer;
  // The mean ratio, which the longest render does not rule.
  describe(before, before * std::exp(change), candidate.change);
  candidate.probability =
      others_moved_more ? 1 : probability_of(change, std::sqrt(variance), sample.count - 1);
  candidates.push_back(std::move(candidate));
}

void test_renders(const std::vector<TimedRender>& renders, std::vector<Candidate>& candidates) {
  constexpr std::size_t kFewest = 6;
  constexpr double kMostDegrees = 8;
  if (renders.size() < kFewest) return;
  for (const auto& render : renders) {
    const auto others = sample_of(renders, &render);
    const auto& identity = render.jobs->after->identity;
    Candidate candidate;
    candidate.change.renderer = identity.renderer;
    candidate.change.target = identity.scene;
    describe(render.jobs->before->cost.cpu_seconds, render.jobs->after->cost.cpu_seconds, candidate.change);
    candidate.probability =
        probability_of(render.log_ratio - others.mean, others.deviation * std::sqrt(1 + 1 / others.count),
                       std::min(others.count - 1, kMostDegrees));
    candidates.push_back(std::move(candidate));
  }
}

}  // namespace

std::vector<Candidate> time_candidates(const RunPair& pair) {
  Renders renderers;
  for (const auto& jobs : pair.jobs) {
    const double before = jobs.before->cost.cpu_seconds;
    const double after = jobs.after->cost.cpu_seconds;
    if (jobs.not_compared.empty() && std::min(before, after) >= kLeastSeconds)
      renderers[jobs.after->identity.renderer].push_back({&jobs, std::log(after / before)});
  }
  std::vector<Candidate> candidates;
  for (const auto& [renderer, renders] : renderers) {
    test_renderer(renderers, renderer, candidates);
    test_renders(renders, candidates);
  }
  return candidates;
}

}  // namespace orbs::history
