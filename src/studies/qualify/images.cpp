#include "studies/qualify/images.h"

#include "base/error.h"
#include "base/files.h"
#include "base/nth.h"
#include "image/image_io.h"
#include "metrics/merged_renders.h"
#include "run/render.h"
#include "scene/render_fault.h"
#include "scene/scene.h"

#include <algorithm>
#include <variant>

#include <fmt/format.h>

namespace orbs::studies {

namespace {

constexpr int kSeed = 2;  // any that no reference has, as the next one

bool glows(const scene::Scene& scene) {
  const auto visible = scene::visible_materials(scene);
  return std::any_of(visible.begin(), visible.end(), [&](int material) {
    return std::holds_alternative<scene::Emission>(nth(scene.materials, material).model);
  });
}

}  // namespace

image::Image control_image(const results::RunRecord& run,
                           const std::string& renderer,
                           const std::string& case_name,
                           const std::string& target) {
  for (const auto& one : run.targets) {
    if (one.renderer != renderer || one.case_name != case_name || one.target != target) continue;
    if (one.image.empty())
      throw InputError(fmt::format("{} has no image in {}: {}", renderer, run.folder, one.reason));
    return image::read_image(std::filesystem::path(run.folder) / one.image);
  }
  throw InputError(fmt::format("{} holds no image of it by {}", run.folder, renderer));
}

std::string why_no_light_can_miss(const scene::Scene& scene) {
  if (scene.lights.empty()) return "it has no light that could be missing";
  const bool has_more = scene.lights.size() > 1 || glows(scene) || shines(scene.environment);
  return has_more ? "" : "its only light: without it the image is black";
}

namespace {

// Negative values are for the gates to judge: those of a colour outside of the gamut are right.
run::RenderSettings settings_of_mutants(const run::Plan& plan, int spp, int seed = kSeed) {
  return {.spp = spp, .seed = seed, .threads = plan.threads, .may_be_negative = true};
}

}  // namespace

std::optional<std::vector<RenderedMutant>> without_each_light(const run::Plan& plan,
                                                              const run::PlannedScene& scene,
                                                              int spp,
                                                              const std::filesystem::path& scratch,
                                                              const std::atomic<bool>* stop) {
  std::vector<RenderedMutant> images;
  for (std::size_t i = 0; i < scene.scene->lights.size(); ++i) {
    auto dark = *scene.scene;
    const auto name = "without " + scene::display_name("light", dark.lights[i].name, i);
    dark.lights.erase(dark.lights.begin() + static_cast<std::ptrdiff_t>(i));
    const auto folder = scratch / fmt::format("{}-{}", scene.name, i);
    const auto subject = run::prepare_render(plan.renderers.front(), plan, dark, folder);
    auto made = run::render_once(subject, settings_of_mutants(plan, spp), stop);
    if (!made) return std::nullopt;
    images.push_back({name, std::move(made->image)});
    remove_tree(folder);
  }
  return images;
}

bool makes_faults(const run::ChosenRenderer& renderer) {
  return renderer.executable.filename() == "orbs-tracer";
}

RenderedMutant mutant_of_renders(std::string name, FaultBySamples by_samples, int spp) {
  auto image = by_samples.faulty[0];
  // Those of a scene without noise are equal.
  if (!image::has_same_colours(image, by_samples.faulty[1])) {
    metrics::MergedRenders merged;
    metrics::add_renders(merged, by_samples.faulty, spp);
    image = std::move(merged.mean);
  }
  return {std::move(name), std::move(image), std::move(by_samples)};
}

std::optional<std::vector<RenderedMutant>> with_each_fault(const run::Plan& plan,
                                                           const run::PlannedScene& scene,
                                                           int spp,
                                                           const std::filesystem::path& scratch,
                                                           const std::atomic<bool>* stop) {
  std::vector<RenderedMutant> images;
  if (!makes_faults(plan.renderers.front())) return images;
  const int half_spp = (spp + 1) / 2;
  const auto rendered =
      [&](const std::vector<std::string>& more) -> std::optional<std::array<image::Image, 2>> {
    auto renderer = plan.renderers.front();
    auto& words = renderer.entry.command.words;
    words.insert(words.end(), more.begin(), more.end());
    const auto folder = scratch / fmt::format("{}-{}", scene.name, more.empty() ? "right" : more.back());
    const auto subject = run::prepare_render(renderer, plan, *scene.scene, folder);
    std::array<image::Image, 2> two;
    for (int i = 0; i < 2; ++i) {
      auto made = run::render_once(subject, settings_of_mutants(plan, half_spp, kSeed + i), stop);
      if (!made) return std::nullopt;
      two.at(static_cast<std::size_t>(i)) = std::move(made->image);
    }
    remove_tree(folder);
    return two;
  };
  auto right = rendered({});
  if (!right) return std::nullopt;
  const auto shared = std::make_shared<const std::array<image::Image, 2>>(std::move(*right));
  for (const auto& fault : scene::kRenderFaults) {
    if (!scene::why_fault_changes_nothing(*scene.scene, fault.fault).empty()) continue;
    auto made = rendered({"--fault", std::string(fault.name)});
    if (!made) return std::nullopt;
    images.push_back(mutant_of_renders(std::string(fault.name), {std::move(*made), shared}, half_spp));
  }
  return images;
}

}  // namespace orbs::studies
