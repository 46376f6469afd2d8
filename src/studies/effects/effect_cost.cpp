#include "studies/effects/effect_cost.h"

#include "base/error.h"
#include "base/files.h"
#include "base/local_time.h"
#include "registry/cases.h"
#include "run/execute.h"
#include "run/host.h"
#include "run/machine_time.h"
#include "run/plan/choose_renderers.h"
#include "run/render.h"
#include "scene/effects/effects.h"
#include "scene/load/load_scene.h"
#include "studies/cost/other_load.h"
#include "studies/effects/paired_interval.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>

namespace orbs::studies {

namespace {

// The scene with one transport, or without one effect, and its renders of all rounds.
struct Variant {
  std::string name;
  run::PreparedRender subject;
  std::vector<std::string> arguments;
  bool is_enough = false;  // carries all that the scene calls for
  bool is_again = false;   // the same as the first variant
  std::vector<double> cpu_seconds{};
  std::vector<image::Image> images{};
};

scene::Scene scaled_scene(const registry::CaseScene& one, const registry::Suite& suite, int size_px) {
  auto scene = scene::load_scene(one.file, suite.data, one.camera);
  auto& camera = scene.camera;
  const double scale = static_cast<double>(size_px) / std::max(camera.width_px, camera.height_px);
  if (scale < 1) {
    camera.width_px = std::max(1, static_cast<int>(camera.width_px * scale));
    camera.height_px = std::max(1, static_cast<int>(camera.height_px * scale));
  }
  return scene;
}

// The first variant is the scene as it is, with the transport that it calls for.
std::vector<Variant> variants_of(const scene::Scene& scene,
                                 const run::Plan& plan,
                                 const std::filesystem::path& scratch) {
  const auto& renderer = plan.renderers.front();
  const auto found = scene::effects(scene);
  const auto needed = scene::transport(found);
  std::vector<Variant> variants;
  const auto subject = run::prepare_render(renderer, plan, scene, scratch / "scene");
  variants.push_back({std::string(transport_name(needed)), subject, {}, true});
  variants.push_back({"again", subject, {}, true, true});
  // Light that two coloured surfaces scatter is the product of their spectra, whose colour is not the product
  // of their colours: a transport of wavelengths shows another image.
  const bool keeps_colours = needed != scene::LightTransport::Rgb || !scene::has_coloured_surface(scene);
  for (const auto transport : scene::kTransports) {
    if (transport == needed) continue;
    const std::string name(transport_name(transport));
    variants.push_back(
        {name, subject, {"--transport", name, "--lossy"}, scene::covers(transport, needed) && keeps_colours});
  }
  std::set<scene::Effect> effects;
  for (const auto& finding : found.called_for) effects.insert(finding.effect);
  for (const auto effect : effects) {
    auto without = scene;
    if (!scene::leave_out(effect, without)) continue;
    const auto name = fmt::format("without {}", effect_name(effect));
    // The transport stays the same, or its saving of time would be taken for that of the effect.
    variants.push_back({name,
                        run::prepare_render(renderer, plan, without, scratch / name),
                        {"--transport", std::string(transport_name(needed))},
                        false});
  }
  return variants;
}

// Renders again while others take so much of the machine that the time is not that of the renderer alone, but
// not for ever. Nothing if the user interrupts.
std::optional<run::RenderedImage> render_alone(const run::PreparedRender& subject,
                                               const run::RenderSettings& settings,
                                               const StudyContext& context,
                                               EffectCostLoad& load) {
  ++load.renders;
  for (int repeats = 0;; ++repeats) {
    const auto before = run::machine_time();
    auto made = run::render_once(subject, settings, context.stop);
    const auto after = run::machine_time();
    if (!made) return std::nullopt;
    const auto share = before && after
                           ? run::share_of_others(*before, *after,
                                                  made->cost.cpu_seconds + made->cost.supervisor_cpu_seconds)
                           : std::nullopt;
    const bool is_disturbed = share.value_or(0) > kMostOtherShare;
    if (is_disturbed && repeats < kMostRepeats) {
      ++load.repeats;
      continue;
    }
    load.disturbed += is_disturbed ? 1 : 0;
    load.unknown += share ? 0 : 1;
    return made;
  }
}

// False if the user interrupts.
bool render_rounds(std::vector<Variant>& variants,
                   const EffectCostSettings& settings,
                   const StudyContext& context,
                   EffectCostLoad& load) {
  for (int round = 0; round < settings.rounds; ++round)
    for (std::size_t turn = 0; turn < variants.size(); ++turn) {
      // Every other round runs backwards, so that no variant always comes first.
      auto& variant = variants[round % 2 == 0 ? turn : variants.size() - 1 - turn];
      auto made =
          render_alone(variant.subject, {settings.spp, round + 1, 1, variant.arguments, true}, context, load);
      if (!made) return false;
      variant.cpu_seconds.push_back(made->cost.samples_cpu_seconds.value_or(made->cost.cpu_seconds));
      variant.images.push_back(std::move(made->image));
    }
  return true;
}

Alternative compared(const Variant& usual, const Variant& other) {
  Alternative out{other.name, other.is_enough, {}, 0, change_between(usual.images, other.images)};
  std::vector<double> ratios;
  for (std::size_t i = 0; i < usual.cpu_seconds.size(); ++i)
    ratios.push_back(other.cpu_seconds[i] / usual.cpu_seconds[i]);
  out.time_ratio = *spread_of(ratios);
  out.time_interval = paired_interval(ratios);
  const double variance = mean_variance(usual.images);
  if (variance > 0 && out.change.is_comparable)
    out.error_ratio = out.time_ratio.median * mean_variance(other.images) / variance;
  return out;
}

SceneEffectCosts effect_costs_of(const std::string& name,
                                 const std::vector<Variant>& variants,
                                 const EffectCostSettings& settings) {
  const Variant& usual = variants.front();
  SceneEffectCosts effect_costs{name, usual.name, {}, 0, {}};
  const auto paths = static_cast<double>(usual.images.front().pixel_count()) * settings.spp;
  effect_costs.paths_per_cpu_second = paths / spread_of(usual.cpu_seconds)->median;
  for (const auto& finding : scene::effects(usual.subject.scene).called_for) {
    const std::string effect(effect_name(finding.effect));
    if (effect_costs.effects.empty() || effect_costs.effects.back() != effect)
      effect_costs.effects.push_back(effect);
  }
  for (std::size_t i = 1; i < variants.size(); ++i) {
    auto alternative = compared(usual, variants[i]);
    if (variants[i].is_again)
      effect_costs.again = std::move(alternative);
    else
      effect_costs.alternatives.push_back(std::move(alternative));
  }
  return effect_costs;
}

}  // namespace

std::optional<EffectCosts> measure_effect_costs(const registry::Configuration& configuration,
                                                const std::string& suite,
                                                const std::string& scenes,
                                                const EffectCostSettings& settings,
                                                const StudyContext& context) {
  run::Plan plan;
  plan.root = configuration.root;
  plan.build = context.build;
  plan.settings.renderers = "orbs";
  plan.settings.sandbox = context.sandbox;
  run::choose_renderers(configuration, plan);
  EffectCosts list{
      settings, context.orbs_version, suite, local_time_now(), run::this_host(), run::load_average(), {}, 0,
      {}};
  const auto& chosen_suite = registry::find_suite(configuration, suite);
  const auto chosen = registry::scenes_of(chosen_suite, scenes);
  for (const auto& one : chosen) {
    const ScratchFolder scratch("orbs-effects");
    const auto scene = with_note(fmt::format("reading scene '{}'", one.name),
                                 [&] { return scaled_scene(one, chosen_suite, settings.size_px); });
    auto variants = variants_of(scene, plan, scratch.path());
    if (!render_rounds(variants, settings, context, list.other_load)) return std::nullopt;
    list.scenes.push_back(effect_costs_of(one.name, variants, settings));
    context.say(fmt::format("[{}/{}] {}", list.scenes.size(), chosen.size(), one.name));
  }
  list.load_end = run::load_average();
  return list;
}

bool all_agree(const EffectCosts& list) {
  return std::all_of(list.scenes.begin(), list.scenes.end(), [](const SceneEffectCosts& scene) {
    return std::all_of(scene.alternatives.begin(), scene.alternatives.end(),
                       [](const Alternative& alternative) {
                         return !alternative.is_enough || !alternative.change.is_comparable ||
                                alternative.change.bias.empty();
                       });
  });
}

}  // namespace orbs::studies
