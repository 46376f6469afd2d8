#include "studies/bench/numbers.h"

#include <algorithm>
#include <cmath>

namespace orbs::studies {

namespace {

// Of the large render's samples, from the slope between the two renders; nothing when noise of the clock ate
// it.
std::optional<double> sample_seconds(const BenchRound& round, double run::RenderCost::*time) {
  const double seconds = round.large.*time - round.small.*time;
  if (!(seconds > 0)) return std::nullopt;
  return seconds * round.large.spp / (round.large.spp - round.small.spp);
}

std::optional<Spread> spread_of_rounds(const std::vector<BenchRound>& rounds, auto&& number_of) {
  std::vector<double> numbers;
  for (const auto& round : rounds)
    if (const std::optional<double> number = number_of(round)) numbers.push_back(*number);
  return spread_of(numbers);
}

std::optional<double> median_cpu_seconds(const BenchRenderer& renderer) {
  const auto seconds = spread_of_rounds(renderer.rounds, [](const BenchRound& round) {
    return sample_seconds(round, &run::RenderCost::cpu_seconds);
  });
  if (!seconds) return std::nullopt;
  return seconds->median;
}

std::optional<Spread> rate(const BenchRecord& record,
                           const BenchRenderer& renderer,
                           double run::RenderCost::*time) {
  const double pixels = static_cast<double>(record.settings.size_px) * record.settings.size_px;
  return spread_of_rounds(renderer.rounds, [&](const BenchRound& round) -> std::optional<double> {
    const auto seconds = sample_seconds(round, time);
    if (!seconds) return std::nullopt;
    return pixels * round.large.spp / *seconds;
  });
}

}  // namespace

std::vector<std::optional<double>> sample_cpu_seconds(const BenchRenderer& renderer) {
  std::vector<std::optional<double>> seconds;
  for (const auto& round : renderer.rounds)
    seconds.push_back(sample_seconds(round, &run::RenderCost::cpu_seconds));
  return seconds;
}

std::optional<Spread> paths_per_cpu_second(const BenchRecord& record, const BenchRenderer& renderer) {
  return rate(record, renderer, &run::RenderCost::cpu_seconds);
}

std::optional<Spread> paths_per_second(const BenchRecord& record, const BenchRenderer& renderer) {
  return rate(record, renderer, &run::RenderCost::wall_seconds);
}

std::optional<Spread> start_cpu_seconds(const BenchRenderer& renderer) {
  return spread_of_rounds(renderer.rounds, [](const BenchRound& round) -> std::optional<double> {
    const auto samples = sample_seconds(round, &run::RenderCost::cpu_seconds);
    if (!samples) return std::nullopt;
    return round.large.cpu_seconds - *samples;
  });
}

std::optional<Spread> traversal_share(const BenchRenderer& renderer) {
  return spread_of_rounds(renderer.rounds,
                          [](const BenchRound& round) { return round.large.traversal_share; });
}

std::optional<Spread> speed_ratio(const BenchRenderer& one, const BenchRenderer& other) {
  const auto of_one = sample_cpu_seconds(one);
  const auto of_other = sample_cpu_seconds(other);
  std::vector<double> ratios;
  for (std::size_t round = 0; round < of_one.size() && round < of_other.size(); ++round)
    if (of_one[round] && of_other[round]) ratios.push_back(*of_other[round] / *of_one[round]);
  return spread_of(ratios);
}

std::optional<SeedNoise> noise_at(const BenchRenderer& renderer, double cpu_seconds) {
  const auto own = median_cpu_seconds(renderer);
  if (!renderer.noise || !own) return std::nullopt;
  const double factor = *own / cpu_seconds;
  return SeedNoise{renderer.noise->relative_mse * factor,
                   renderer.noise->psnr_srgb8_db - 10 * std::log10(factor)};
}

std::optional<double> equal_cpu_seconds(const BenchRecord& record) {
  if (record.renderers.empty()) return std::nullopt;
  return median_cpu_seconds(record.renderers.front());
}

std::optional<double> overhead_ms(const BenchRecord& record) {
  if (!record.overhead) return std::nullopt;
  return record.overhead->harness_ms.median - record.overhead->bare_ms.median;
}

std::optional<double> watching_share(const BenchRecord& record) {
  std::optional<double> most;
  for (const auto& renderer : record.renderers)
    for (const auto& round : renderer.rounds)
      if (round.large.wall_seconds > 0)
        most = std::max(most.value_or(0), round.large.supervisor_cpu_seconds / round.large.wall_seconds);
  return most;
}

}  // namespace orbs::studies
