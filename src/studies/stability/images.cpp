#include "studies/stability/images.h"

#include "base/error.h"
#include "base/text.h"
#include "run/render.h"
#include "studies/stability/record.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>

namespace orbs::studies {

namespace {

scene::Related unchanged(const scene::Scene& scene, double) {
  return scene::RelatedScenes{scene, scene, scene::SameImage{}};
}

std::vector<StabilityRelation> all_relations() {
  std::vector<StabilityRelation> all;
  for (const auto& relation : scene::relations()) all.push_back({relation, RenderChange::None});
  all.push_back(
      {{"threads", "three threads instead of one", "", {1}, true, unchanged}, RenderChange::Threads});
  all.push_back({{"seed", "other seeds", "", {1}, false, unchanged}, RenderChange::Seed});
  all.push_back({{"two_halves", "the mean of two renders with half the samples", "", {1}, false, unchanged},
                 RenderChange::TwoHalves});
  all.push_back({{kPrecisionRelation, "rays meet triangles in double precision", "", {1}, false, unchanged},
                 RenderChange::Precision});
  return all;
}

}  // namespace

std::vector<StabilityRelation> stability_relations(const std::vector<std::string>& patterns) {
  auto all = all_relations();
  if (patterns.empty()) return all;
  std::set<std::string> names;
  for (const auto& relation : all) names.emplace(relation.of_scenes.name);
  for (const auto& pattern : patterns)
    if (std::none_of(names.begin(), names.end(), [&](const auto& name) { return glob_match(pattern, name); }))
      throw InputError(fmt::format("there is no relation '{}'{}; orbs stability --help lists them", pattern,
                                   closest(pattern, names)));
  std::erase_if(all, [&](const auto& relation) {
    return std::none_of(patterns.begin(), patterns.end(),
                        [&](const auto& pattern) { return glob_match(pattern, relation.of_scenes.name); });
  });
  return all;
}

namespace {

image::Image mean_of(const image::Image& a, const image::Image& b) {
  image::Image out = a;
  for (std::size_t i = 0; i < out.pixels.size(); ++i) out.pixels[i] = 0.5F * (a.pixels[i] + b.pixels[i]);
  return out;
}

}  // namespace

std::optional<std::vector<image::Image>> StabilityImages::render(const scene::Scene& scene,
                                                                 const std::filesystem::path& folder,
                                                                 RenderChange change) const {
  const auto prepared = run::prepare_render(renderer_, plan_, scene, folder);
  const auto one = [&](int spp, int seed) -> std::optional<image::Image> {
    run::RenderSettings settings{
        .spp = spp, .seed = seed, .threads = settings_.threads, .may_be_negative = true};
    if (change == RenderChange::Threads) settings.threads = 3;
    if (change == RenderChange::Precision) settings.more_arguments = renderer_.entry.command.double_precision;
    const auto made = run::render_once(prepared, settings, context_.stop);
    if (!made) return std::nullopt;
    return image::select_rgb(made->image, "");
  };
  // Far from each other, so that a renderer may count passes on from a seed. Of a sequence, the images before
  // a seed are rendered, too, so the next ones are taken: those that are not among the original's samples.
  const bool has_sequence = !renderer_.entry.command.sequence.words.empty();
  const int other_seed = has_sequence ? 2 * settings_.seeds : 1000;
  const bool is_noise_free = renderer_.entry.sampling.is_noise_free;
  std::vector<image::Image> images;
  for (int seed = 1; seed <= (is_noise_free ? 1 : settings_.seeds); ++seed) {
    const bool is_halved = change == RenderChange::TwoHalves;
    const bool is_other = is_halved || change == RenderChange::Seed;
    auto image = one(is_halved ? settings_.spp / 2 : settings_.spp, is_other ? other_seed + seed : seed);
    if (!image) return std::nullopt;
    if (is_halved) {
      const auto second = one(settings_.spp / 2, 2 * other_seed + seed);
      if (!second) return std::nullopt;
      image = mean_of(*image, *second);
    }
    images.push_back(std::move(*image));
  }
  return images;
}

std::optional<std::vector<image::Image>> StabilityImages::original(const scene::Scene& scene,
                                                                   const std::filesystem::path& folder) {
  for (const auto& kept : kept_)
    if (kept.scene == scene) return kept.images;
  auto images = render(scene, folder);
  if (images) kept_.push_back({scene, *images});
  return images;
}

}  // namespace orbs::studies
