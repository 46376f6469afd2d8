#include "studies/cost/sweep.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

namespace orbs::studies {

namespace {

constexpr int kMostSpp = 1 << 22;
constexpr int kFewestPoints = 4;  // that a fit needs

SweepSetting sample_setting(int spp) { return {fmt::format("{} spp", spp), spp}; }

double seconds_per_sample(const CostPilot& pilot) {
  return std::max(0.0, pilot.seconds - pilot.fixed_seconds) / pilot.spp;
}

// Powers of two, at which low-discrepancy samples are best.
int power_of_two_from(double samples) {
  int spp = 1;
  while (spp < samples && spp < kMostSpp) spp *= 2;
  return spp;
}

// The samples that reach the target, by the pilot, with half as many again, since its error is noisy.
double wanted_samples(const CostPilot& pilot, const CostSettings& settings) {
  constexpr double kMargin = 1.5;
  return kMargin * pilot.spp * std::pow(10, (settings.target_db - pilot.psnr_srgb8) / 10);
}

void set_samples(Sweep& sweep, const CostPilot& pilot, int last_spp, int count) {
  sweep.settings.clear();
  for (int i = count - 1; i >= 0; --i)
    if (const int spp = last_spp >> i; spp >= std::max(1, pilot.least_spp))
      sweep.settings.push_back(sample_setting(spp));
  if (sweep.settings.empty()) sweep.settings.push_back(sample_setting(std::max(1, pilot.least_spp)));
}

Sweep settings_sweep(const CostPilot& pilot) {
  Sweep sweep{pilot.target, pilot.renderer, pilot.settings, "", ""};
  const auto tried = pilot.setting_seconds.size();
  if (tried == 0 || tried == pilot.settings.size()) return sweep;
  sweep.settings.resize(tried);
  sweep.note =
      fmt::format("the budget ends at '{}', {:.3g} s a render; '{}' would take longer",
                  sweep.settings.back().name, pilot.setting_seconds.back(), pilot.settings[tried].name);
  return sweep;
}

// Gives every sweep by samples so many points; the seconds of all together.
double refill(const std::vector<CostPilot>& pilots,
              const CostSettings& settings,
              int points,
              std::vector<Sweep>& sweeps) {
  double sum = 0;
  for (std::size_t i = 0; i < pilots.size(); ++i) {
    if (pilots[i].settings.empty())
      set_samples(sweeps[i], pilots[i], power_of_two_from(wanted_samples(pilots[i], settings)), points);
    sum += expected_seconds(pilots[i], sweeps[i], settings);
  }
  return sum;
}

// The sweep whose samples, its fixed cost aside, take the longest. Nothing when no sweep can get shorter.
std::optional<std::size_t> most_samples(const std::vector<CostPilot>& pilots,
                                        const std::vector<Sweep>& sweeps) {
  std::optional<std::size_t> slowest;
  double most = 0;
  for (std::size_t i = 0; i < pilots.size(); ++i) {
    if (!pilots[i].settings.empty() || sweeps[i].settings.back().spp <= pilots[i].least_spp) continue;
    const double seconds = seconds_per_sample(pilots[i]) * sweeps[i].settings.back().spp;
    if (seconds <= most) continue;
    most = seconds;
    slowest = i;
  }
  return slowest;
}

}  // namespace

int renders_per_setting(const CostPilot& pilot, const CostSettings& settings) {
  return pilot.is_noise_free ? std::min(settings.seeds, 2) : settings.seeds;
}

bool may_try_next_setting(const CostPilot& pilot, const CostSettings& settings, double share_seconds) {
  const auto& tried = pilot.setting_seconds;
  if (tried.empty()) return !pilot.settings.empty();
  if (tried.size() == pilot.settings.size()) return false;
  constexpr double kUsualGrowth = 2;
  const double growth =
      tried.size() == 1 ? kUsualGrowth : std::max(1.0, tried.back() / tried[tried.size() - 2]);
  const double sum = std::accumulate(tried.begin(), tried.end(), tried.back() * growth);
  return sum * renders_per_setting(pilot, settings) <= share_seconds;
}

double expected_seconds(const CostPilot& pilot, const Sweep& sweep, const CostSettings& settings) {
  double seconds = settings.seeds * pilot.fixed_seconds;
  if (!pilot.settings.empty())
    return std::accumulate(pilot.setting_seconds.begin(), pilot.setting_seconds.end(), 0.0) *
               renders_per_setting(pilot, settings) +
           seconds;
  for (const auto& setting : sweep.settings)
    seconds += settings.seeds * (pilot.fixed_seconds + seconds_per_sample(pilot) * setting.spp);
  return seconds;
}

std::vector<Sweep> choose_sweeps(const std::vector<CostPilot>& pilots,
                                 const CostSettings& settings,
                                 double budget_seconds) {
  std::vector<Sweep> sweeps;
  for (const auto& pilot : pilots) sweeps.push_back(settings_sweep(pilot));
  double sum = refill(pilots, settings, settings.points, sweeps);
  // First fewer points everywhere: the start of a renderer counts for each of them. Then fewer samples.
  for (int points = settings.points - 1; sum > budget_seconds && points >= kFewestPoints; --points)
    sum = refill(pilots, settings, points, sweeps);
  const int points = std::min(settings.points, kFewestPoints);
  while (sum > budget_seconds) {
    const auto slowest = most_samples(pilots, sweeps);
    if (!slowest) break;  // nothing is left to be saved
    const auto& pilot = pilots[*slowest];
    auto& sweep = sweeps[*slowest];
    sum -= expected_seconds(pilot, sweep, settings);
    set_samples(sweep, pilot, sweep.settings.back().spp / 2, points);
    sum += expected_seconds(pilot, sweep, settings);
    const double wanted = wanted_samples(pilot, settings);
    if (sweep.settings.back().spp < wanted)
      sweep.note = fmt::format("the budget ends at {} spp; {:g} dB may need {:.0f} spp, {:.3g} s a render",
                               sweep.settings.back().spp, settings.target_db, wanted,
                               pilot.fixed_seconds + seconds_per_sample(pilot) * wanted);
  }
  return sweeps;
}

std::vector<Sweep> given_sweeps(const std::vector<CostPilot>& pilots, const std::vector<int>& samples) {
  auto sorted = samples;
  std::sort(sorted.begin(), sorted.end());
  sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
  std::vector<Sweep> sweeps;
  for (const auto& pilot : pilots) {
    sweeps.push_back(settings_sweep(pilot));
    if (pilot.settings.empty())
      for (const int spp : sorted) sweeps.back().settings.push_back(sample_setting(spp));
  }
  return sweeps;
}

}  // namespace orbs::studies
