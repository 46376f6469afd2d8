#include "studies/cost/sweep.h"

#include "base/error.h"
#include "studies/cost/schedule.h"
#include "studies/cost/seeds.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>

#include <fmt/format.h>

namespace orbs::studies {

namespace {

constexpr int kMostHalvings = 22;
constexpr int kMostSpp = 1 << kMostHalvings;
constexpr int kFewestPoints = 4;  // that a fit needs
constexpr int kHalvings = static_cast<int>(kPointsOfEach) - 1;

SeedRule seed_rule(const CostPilot& pilot, const CostSettings& settings) {
  return {pilot.sequence_images, pilot.settings.empty() ? SweepOf::Samples : SweepOf::Settings,
          renders_per_setting(pilot, settings), pilot.renderer == 0};
}

SweepSetting sample_setting(int spp) { return {fmt::format("{} spp", spp), spp}; }

double seconds_per_sample(const CostPilot& pilot) {
  // Of a sweep by settings, by the first that was tried.
  if (!pilot.setting_seconds.empty())
    return std::max(0.0, pilot.setting_seconds.front() - pilot.fixed_seconds) / pilot.settings.front().spp;
  return std::max(0.0, pilot.seconds - pilot.fixed_seconds) / pilot.spp;
}

// Of one render of a setting by samples, its fixed cost aside; of a sequence with the images that are
// rendered in vain.
double seconds_of_samples(const CostPilot& pilot,
                          const Sweep& sweep,
                          const CostSettings& settings,
                          std::size_t setting) {
  return seconds_per_sample(pilot) * sweep.settings[setting].spp *
         images_of_setting(seed_rule(pilot, settings), sweep, setting);
}

// Likewise how many images one of the settings that the configuration lists takes: all begin at the first.
double images_of_qualities(const CostPilot& pilot, const CostSettings& settings) {
  const Sweep any{pilot.target, pilot.renderer, pilot.settings, "", ""};
  return images_of_setting(seed_rule(pilot, settings), any, 0);
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

// Whether half the samples would save time that is worth their loss: not where the start takes longer than
// the samples that are left, nor where the whole sweep takes no more than half of an even share of the
// budget. Else the starts of slow renderers would cost quick ones their curves.
bool is_worth_halving(const CostPilot& pilot,
                      const Sweep& sweep,
                      const CostSettings& settings,
                      double share_seconds) {
  const int half = sweep.settings.back().spp / 2;
  return (half >> kHalvings) >= std::max(1, pilot.least_spp) &&
         seconds_per_sample(pilot) * half >= pilot.fixed_seconds &&
         expected_seconds(pilot, sweep, settings) > share_seconds / 2;
}

// The sweep whose samples, its fixed cost aside, take the longest. Nothing when none is worth halving.
std::optional<std::size_t> most_samples(const std::vector<CostPilot>& pilots,
                                        const std::vector<Sweep>& sweeps,
                                        const CostSettings& settings,
                                        double share_seconds) {
  std::optional<std::size_t> slowest;
  double most = 0;
  for (std::size_t i = 0; i < pilots.size(); ++i) {
    if (!pilots[i].settings.empty() || !is_worth_halving(pilots[i], sweeps[i], settings, share_seconds))
      continue;
    const double seconds = seconds_of_samples(pilots[i], sweeps[i], settings, sweeps[i].settings.size() - 1);
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
  return sum * renders_per_setting(pilot, settings) * images_of_qualities(pilot, settings) <= share_seconds;
}

double expected_seconds(const CostPilot& pilot, const Sweep& sweep, const CostSettings& settings) {
  double seconds = settings.seeds * pilot.fixed_seconds;
  if (!pilot.settings.empty())
    return std::accumulate(pilot.setting_seconds.begin(), pilot.setting_seconds.end(), 0.0) *
               renders_per_setting(pilot, settings) * images_of_qualities(pilot, settings) +
           seconds;
  for (std::size_t i = 0; i < sweep.settings.size(); ++i)
    seconds += settings.seeds * (pilot.fixed_seconds + seconds_of_samples(pilot, sweep, settings, i));
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
  // Each turn halves the samples of one sweep, of which none has more than kMostSpp.
  const int most_turns = static_cast<int>(pilots.size()) * kMostHalvings;
  const double share_seconds = budget_seconds / std::max<double>(1, static_cast<double>(pilots.size()));
  for (int turn = 0; turn < most_turns && sum > budget_seconds; ++turn) {
    const auto slowest = most_samples(pilots, sweeps, settings, share_seconds);
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

namespace {

std::vector<SweepSetting> listed_settings(const registry::Renderer& entry) {
  std::vector<SweepSetting> settings;
  for (const auto& quality : entry.timing.cost_sweep) settings.push_back({quality.name, quality.spp});
  return settings;
}

// Renders one setting after the other while the next is expected to fit into the share of the budget.
std::optional<CostPilot> try_settings(const CostMeasurement& study,
                                      CostRender wanted,
                                      double share_seconds,
                                      CostPilot found) {
  while (may_try_next_setting(found, study.record.settings, share_seconds)) {
    const auto& setting = found.settings[found.setting_seconds.size()];
    wanted.setting = setting.name;
    wanted.spp = setting.spp;
    const auto made = measured_render(study, wanted);
    if (!made) return std::nullopt;
    found.setting_seconds.push_back(
        seconds_of_one_image(std::min(made->wall_seconds, made->cpu_seconds),  // as for the fixed cost
                             found.fixed_seconds, made->images));
    study.context.say(fmt::format("pilot  {:<10} {:<18} {:>10}  {:5.2f} dB  {:6.2f} s",
                                  study.plan.renderers[wanted.renderer].entry.name,
                                  study.record.targets[wanted.target].name, setting.name,
                                  made->psnr_srgb8.value_or(0), found.setting_seconds.back()));
  }
  return found;
}

// Every pilot is also the warm-up of its renderer and scene: file caches are filled when the rounds begin.
// Nothing when the user interrupts.
std::optional<CostPilot> pilot(const CostMeasurement& study,
                               std::size_t target,
                               std::size_t renderer,
                               double share_seconds) {
  const auto& entry = study.plan.renderers[renderer].entry;
  CostPilot found{target, renderer, 0, kPilotSpp, 0, 0, 1, listed_settings(entry)};
  found.sequence_images = study.record.renderers[renderer].sequence_images;
  CostRender wanted{.target = target, .renderer = renderer, .purpose = Purpose::FixedCost};
  const auto fixed = measured_render(study, wanted);
  if (!fixed) return std::nullopt;
  // Not its wall clock where that is longer: other work on the machine would count for every render.
  found.fixed_seconds = std::min(fixed->wall_seconds, fixed->cpu_seconds);
  found.is_noise_free = entry.sampling.is_noise_free;
  wanted.purpose = Purpose::Sweep;
  wanted.seed = pilot_seed(seed_rule(found, study.record.settings));
  if (!found.settings.empty()) return try_settings(study, wanted, share_seconds, found);
  wanted.spp = found.spp;
  const auto made = measured_render(study, wanted);
  if (!made) return std::nullopt;
  // Not its wall clock: other work on the machine would count for every sample of every setting.
  found.seconds = found.fixed_seconds + std::max(0.0, made->cpu_seconds - fixed->cpu_seconds) /
                                            study.record.settings.threads / made->images;
  found.psnr_srgb8 = made->psnr_srgb8.value_or(0);
  study.context.say(fmt::format("pilot  {:<10} {:<18} {:>6} spp  {:5.2f} dB  {:6.2f} s", entry.name,
                                study.record.targets[target].name, found.spp, found.psnr_srgb8,
                                found.seconds));
  return found;
}

}  // namespace

bool find_sweeps(CostMeasurement& study, double budget_seconds) {
  std::vector<CostPilot> pilots;
  std::vector<Sweep> unrendered;
  std::set<std::pair<std::size_t, std::size_t>> seen;
  const auto spent_seconds = [begin = std::chrono::steady_clock::now()] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  };
  const double share_seconds =
      budget_seconds / std::max<double>(1, static_cast<double>(study.plan.jobs.size()));
  for (const auto& planned : study.plan.targets) {
    if (planned.jobs.size() != 1) continue;
    const auto& targets = study.record.targets;
    const auto target =
        std::find_if(targets.begin(), targets.end(), [&](const auto& t) { return t.name == planned.target; });
    if (target == targets.end()) continue;
    const auto index = static_cast<std::size_t>(target - targets.begin());
    if (!seen.insert({index, planned.renderer}).second) continue;
    try {
      const auto found = pilot(study, index, planned.renderer, share_seconds);
      if (!found) return false;
      pilots.push_back(*found);
    } catch (const InputError& e) {
      unrendered.push_back({index, planned.renderer, {}, e.what(), ""});
    }
  }
  const auto& settings = study.record.settings;
  const auto say_expected = [&](const char* what, const std::vector<Sweep>& sweeps) {
    double seconds = 0;
    for (std::size_t i = 0; i < pilots.size(); ++i)
      seconds += expected_seconds(pilots[i], sweeps[i], settings);
    study.context.say(fmt::format("{} about {:.0f} s", what, seconds));
  };
  if (study.request.samples.empty()) {
    constexpr double kUnlimited = std::numeric_limits<double>::infinity();
    say_expected(fmt::format("all {} curves to {:g} dB take", pilots.size(), settings.target_db).c_str(),
                 choose_sweeps(pilots, settings, kUnlimited));
    study.record.sweeps = choose_sweeps(pilots, settings, budget_seconds - spent_seconds());
  } else {
    study.record.sweeps = given_sweeps(pilots, study.request.samples);
  }
  for (std::size_t i = 0; i < pilots.size(); ++i)
    study.record.sweeps[i].seconds_per_sample = seconds_per_sample(pilots[i]);
  say_expected(fmt::format("of the budget of {:g} s, {:.0f} s are left; the settings of this study take",
                           budget_seconds, std::max(0.0, budget_seconds - spent_seconds()))
                   .c_str(),
               study.record.sweeps);
  study.record.sweeps.insert(study.record.sweeps.end(), unrendered.begin(), unrendered.end());
  return true;
}

}  // namespace orbs::studies
