#include "studies/stability/images.h"

#include "run/render_once.h"

namespace orbs::studies {

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
  // Far from each other, so that a renderer may count passes on from a seed.
  constexpr int kOther = 1000;
  const bool is_noise_free = renderer_.entry.sampling.is_noise_free;
  std::vector<image::Image> images;
  for (int seed = 1; seed <= (is_noise_free ? 1 : settings_.seeds); ++seed) {
    const bool is_halved = change == RenderChange::TwoHalves;
    const bool is_other = is_halved || change == RenderChange::Seed;
    auto image = one(is_halved ? settings_.spp / 2 : settings_.spp, is_other ? kOther + seed : seed);
    if (!image) return std::nullopt;
    if (is_halved) {
      const auto second = one(settings_.spp / 2, 2 * kOther + seed);
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
