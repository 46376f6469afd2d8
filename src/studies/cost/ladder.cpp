#include "studies/cost/ladder.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

namespace orbs::studies {

namespace {

constexpr int kMostSpp = 1 << 22;
constexpr int kFewestRungs = 4;  // that a fit needs

CostRung sample_rung(int spp) { return {fmt::format("{} spp", spp), spp}; }

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

void set_rungs(CostLadder& ladder, const CostPilot& pilot, int last_spp, int count) {
  ladder.rungs.clear();
  for (int i = count - 1; i >= 0; --i)
    if (const int spp = last_spp >> i; spp >= std::max(1, pilot.least_spp))
      ladder.rungs.push_back(sample_rung(spp));
  if (ladder.rungs.empty()) ladder.rungs.push_back(sample_rung(std::max(1, pilot.least_spp)));
}

CostLadder settings_ladder(const CostPilot& pilot) {
  CostLadder ladder{pilot.target, pilot.renderer, pilot.settings, "", ""};
  const auto tried = pilot.setting_seconds.size();
  if (tried == 0 || tried == pilot.settings.size()) return ladder;
  ladder.rungs.resize(tried);
  ladder.note =
      fmt::format("the budget ends at '{}', {:.3g} s a render; '{}' would take longer",
                  ladder.rungs.back().name, pilot.setting_seconds.back(), pilot.settings[tried].name);
  return ladder;
}

// Sets so many rungs at every ladder by samples; the seconds of all together.
double refill(const std::vector<CostPilot>& pilots,
              const CostSettings& settings,
              int rungs,
              std::vector<CostLadder>& ladders) {
  double sum = 0;
  for (std::size_t i = 0; i < pilots.size(); ++i) {
    if (pilots[i].settings.empty())
      set_rungs(ladders[i], pilots[i], power_of_two_from(wanted_samples(pilots[i], settings)), rungs);
    sum += expected_seconds(pilots[i], ladders[i], settings);
  }
  return sum;
}

// The ladder whose samples, its fixed cost aside, take the longest. Nothing when no ladder can get shorter.
std::optional<std::size_t> most_samples(const std::vector<CostPilot>& pilots,
                                        const std::vector<CostLadder>& ladders) {
  std::optional<std::size_t> dearest;
  double most = 0;
  for (std::size_t i = 0; i < pilots.size(); ++i) {
    if (!pilots[i].settings.empty() || ladders[i].rungs.back().spp <= pilots[i].least_spp) continue;
    const double seconds = seconds_per_sample(pilots[i]) * ladders[i].rungs.back().spp;
    if (seconds <= most) continue;
    most = seconds;
    dearest = i;
  }
  return dearest;
}

}  // namespace

int renders_per_rung(const CostPilot& pilot, const CostSettings& settings) {
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
  return sum * renders_per_rung(pilot, settings) <= share_seconds;
}

double expected_seconds(const CostPilot& pilot, const CostLadder& ladder, const CostSettings& settings) {
  double seconds = settings.seeds * pilot.fixed_seconds;
  if (!pilot.settings.empty())
    return std::accumulate(pilot.setting_seconds.begin(), pilot.setting_seconds.end(), 0.0) *
               renders_per_rung(pilot, settings) +
           seconds;
  for (const auto& rung : ladder.rungs)
    seconds += settings.seeds * (pilot.fixed_seconds + seconds_per_sample(pilot) * rung.spp);
  return seconds;
}

std::vector<CostLadder> choose_ladders(const std::vector<CostPilot>& pilots,
                                       const CostSettings& settings,
                                       double budget_seconds) {
  std::vector<CostLadder> ladders;
  for (const auto& pilot : pilots) ladders.push_back(settings_ladder(pilot));
  double sum = refill(pilots, settings, settings.rungs, ladders);
  // First fewer rungs everywhere: the start of a renderer counts for each of them. Then fewer samples.
  for (int rungs = settings.rungs - 1; sum > budget_seconds && rungs >= kFewestRungs; --rungs)
    sum = refill(pilots, settings, rungs, ladders);
  const int rungs = std::min(settings.rungs, kFewestRungs);
  while (sum > budget_seconds) {
    const auto dearest = most_samples(pilots, ladders);
    if (!dearest) break;  // nothing is left to be saved
    const auto& pilot = pilots[*dearest];
    auto& ladder = ladders[*dearest];
    sum -= expected_seconds(pilot, ladder, settings);
    set_rungs(ladder, pilot, ladder.rungs.back().spp / 2, rungs);
    sum += expected_seconds(pilot, ladder, settings);
    const double wanted = wanted_samples(pilot, settings);
    if (ladder.rungs.back().spp < wanted)
      ladder.note = fmt::format("the budget ends at {} spp; {:g} dB may need {:.0f} spp, {:.3g} s a render",
                                ladder.rungs.back().spp, settings.target_db, wanted,
                                pilot.fixed_seconds + seconds_per_sample(pilot) * wanted);
  }
  return ladders;
}

std::vector<CostLadder> given_ladders(const std::vector<CostPilot>& pilots, const std::vector<int>& samples) {
  auto sorted = samples;
  std::sort(sorted.begin(), sorted.end());
  sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
  std::vector<CostLadder> ladders;
  for (const auto& pilot : pilots) {
    ladders.push_back(settings_ladder(pilot));
    if (pilot.settings.empty())
      for (const int spp : sorted) ladders.back().rungs.push_back(sample_rung(spp));
  }
  return ladders;
}

}  // namespace orbs::studies
