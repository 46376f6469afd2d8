#include "studies/cost/pilot.h"

#include "base/error.h"
#include "studies/cost/sweep.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <set>

#include <fmt/format.h>

namespace orbs::studies {

namespace {

std::vector<SweepSetting> listed_settings(const registry::Renderer& entry) {
  std::vector<SweepSetting> settings;
  for (const auto& quality : entry.timing.cost_ladder) settings.push_back({quality.name, quality.spp});
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
        std::min(made->wall_seconds, made->cpu_seconds));  // as for the fixed cost
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
  constexpr int kPilotSpp = 8;  // enough: the error of an image is a mean over all its pixels
  const auto& entry = study.plan.renderers[renderer].entry;
  CostPilot found{target, renderer, 0, kPilotSpp, 0, 0, 1, listed_settings(entry)};
  CostRender wanted{.target = target, .renderer = renderer, .purpose = Purpose::FixedCost};
  const auto fixed = measured_render(study, wanted);
  if (!fixed) return std::nullopt;
  // Not its wall clock where that is longer: other work on the machine would count for every render.
  found.fixed_seconds = std::min(fixed->wall_seconds, fixed->cpu_seconds);
  found.is_noise_free = entry.sampling.is_noise_free;
  constexpr int kPilotSeed = 900;  // of no setting
  wanted.purpose = Purpose::Sweep;
  wanted.seed = kPilotSeed;
  if (!found.settings.empty()) return try_settings(study, wanted, share_seconds, found);
  wanted.spp = found.spp;
  const auto made = measured_render(study, wanted);
  if (!made) return std::nullopt;
  // Not its wall clock: other work on the machine would count for every sample of every setting.
  found.seconds = found.fixed_seconds +
                  std::max(0.0, made->cpu_seconds - fixed->cpu_seconds) / study.record.settings.threads;
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
  const auto begin = std::chrono::steady_clock::now();
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
    study.context.say(fmt::format("{}: about {:.0f} s", what, seconds));
  };
  if (study.request.samples.empty()) {
    constexpr double kUnlimited = std::numeric_limits<double>::infinity();
    say_expected(fmt::format("all {} curves to {:g} dB", pilots.size(), settings.target_db).c_str(),
                 choose_sweeps(pilots, settings, kUnlimited));
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - begin;
    study.record.sweeps = choose_sweeps(pilots, settings, budget_seconds - spent.count());
  } else {
    study.record.sweeps = given_sweeps(pilots, study.request.samples);
  }
  say_expected("the settings of this study", study.record.sweeps);
  study.record.sweeps.insert(study.record.sweeps.end(), unrendered.begin(), unrendered.end());
  return true;
}

}  // namespace orbs::studies
