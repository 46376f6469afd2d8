#include "studies/cost/seeds.h"

#include "studies/cost/curve.h"

#include <algorithm>
#include <vector>

namespace orbs::studies {

namespace {

constexpr int kSeedsOfSetting = 1000;

int divided_up(int number, int by) { return (number + by - 1) / by; }

// Of one render, whose images share them.
int samples_of(const SeedRule& rule, const SweepSetting& setting) {
  return rule.sequence_images * divided_up(setting.spp, rule.sequence_images);
}

int seed_before_of_sequence(const SeedRule& rule, const Sweep& sweep, std::size_t setting) {
  if (rule.varies == SweepOf::Settings) return 0;
  int samples = rule.sequence_images * divided_up(kPilotSpp, rule.sequence_images);
  for (std::size_t i = 0;; ++i) {
    const int of_render = samples_of(rule, sweep.settings[i]);
    const int before = divided_up(samples, of_render);
    if (i == setting) return before;
    const bool is_again = rule.is_again && i == setting_of_again(sweep);
    samples = (before + (is_again ? 2 : 1) * rule.seeds) * of_render;
  }
}

}  // namespace

SeedRule seed_rule(const CostRecord& record, const Sweep& sweep) {
  const auto& renderer = record.renderers.at(sweep.renderer);
  return {renderer.sequence_images, renderer.sweep, record.settings.seeds, sweep.renderer == 0};
}

std::size_t setting_of_again(const Sweep& sweep) {
  return std::min(kPointsOfEach, sweep.settings.size()) - 1;
}

int pilot_seed(const SeedRule& rule) {
  constexpr int kOfNoSetting = 900;
  return rule.sequence_images > 0 ? 1 : kOfNoSetting;
}

int seed_before(const SeedRule& rule, const Sweep& sweep, std::size_t setting) {
  return rule.sequence_images > 0 ? seed_before_of_sequence(rule, sweep, setting)
                                  : kSeedsOfSetting * (1 + static_cast<int>(setting));
}

int seed_before_again(const SeedRule& rule, const Sweep& sweep) {
  const int before = seed_before(rule, sweep, setting_of_again(sweep));
  return before +
         (rule.sequence_images > 0 ? rule.seeds : kSeedsOfSetting * static_cast<int>(sweep.settings.size()));
}

double images_of_setting(const SeedRule& rule, const Sweep& sweep, std::size_t setting) {
  if (rule.sequence_images == 0) return 1;
  // The render with seed s has the images r (s - 1) + 1 to r s, each of them the last of a process.
  const double before = seed_before(rule, sweep, setting) + 0.5 * (rule.seeds - 1);
  return rule.sequence_images * before + 0.5 * (rule.sequence_images + 1);
}

double seconds_of_one_image(double seconds, double fixed_seconds, double images) {
  return fixed_seconds + (seconds - fixed_seconds) / images;
}

CostRecord with_times_of_one_image(CostRecord record) {
  if (std::all_of(record.renderers.begin(), record.renderers.end(),
                  [](const CostRenderer& renderer) { return renderer.sequence_images == 0; }))
    return record;
  const auto measured = record;
  std::erase_if(record.renders, [&](CostRender& render) {
    if (render.purpose == Purpose::FixedCost || render.images == 1) return false;
    const Sweep sweep{render.target, render.renderer, {}, "", ""};
    const auto fixed = renders_of(measured, sweep, Purpose::FixedCost);
    if (fixed.empty()) return true;
    const auto in_place = [&](double CostRender::*seconds) {
      std::vector<double> of_fixed;
      for (const auto* one : fixed) of_fixed.push_back(one->*seconds);
      render.*seconds = seconds_of_one_image(render.*seconds, median_interval(of_fixed).value, render.images);
    };
    in_place(&CostRender::cpu_seconds);
    in_place(&CostRender::wall_seconds);
    return false;
  });
  return record;
}

}  // namespace orbs::studies
