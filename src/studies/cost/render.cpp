#include "studies/cost/render.h"

#include "base/files.h"
#include "image/colour.h"
#include "image/image_io.h"
#include "metrics/compare.h"
#include "run/host.h"
#include "run/job_folder.h"
#include "run/render_once.h"
#include "studies/cost/curve.h"

namespace orbs::studies {

namespace {

run::ChosenRenderer with_settings(run::ChosenRenderer renderer, const std::string& setting) {
  for (const auto& quality : renderer.entry.timing.cost_ladder)
    if (quality.name == setting)
      for (const auto& [name, value] : quality.scene_settings) renderer.entry.format.settings[name] = value;
  return renderer;
}

void keep_image(const CostMeasurement& study,
                const CostRender& render,
                const image::Image& image,
                std::size_t setting) {
  const Sweep sweep{render.target, render.renderer, {}, "", ""};
  const auto file = [&](const char* ending) {
    return study.request.folder / image_file(study.record, sweep, setting, ending);
  };
  make_folder(file("exr").parent_path());
  image::write_exr(image, file("exr"), image::Precision::Half);
  image::write_png(image::display_image(image), file("png"));
}

}  // namespace

std::optional<CostRender> measured_render(const CostMeasurement& study,
                                          CostRender wanted,
                                          std::optional<std::size_t> kept_as) {
  const auto& subject = study.subjects[wanted.target];
  const auto& chosen = study.plan.renderers[wanted.renderer];
  auto scene = *subject.scene->scene;
  const bool is_fixed = wanted.purpose == Purpose::FixedCost;
  constexpr int kFewestPixels = 4;  // Blender's least width
  if (is_fixed) scene.camera.width_px = scene.camera.height_px = kFewestPixels;
  const auto folder = study.scratch.path() / "render";
  run::make_way(folder);
  // What settings ask for may cost as much in few pixels as in many, so the fixed cost is that of the first.
  const auto& listed = chosen.entry.timing.cost_ladder;
  // Some renderers refuse fewer samples than the independent blocks that they are told to make. The 128
  // samples of 4 x 4 px take less than a millisecond.
  constexpr int kFixedSpp = 8;
  if (is_fixed && listed.empty()) wanted.spp = kFixedSpp;
  const auto& setting = is_fixed && !listed.empty() ? listed.front().name : wanted.setting;
  const auto prepared = run::prepare_render(with_settings(chosen, setting), study.plan, scene, folder,
                                            subject.scene->wall_seconds);
  wanted.load = run::load_average();
  wanted.order = static_cast<int>(study.record.renders.size());
  const auto made = run::render_once(prepared,
                                     {wanted.spp,
                                      wanted.seed,
                                      study.record.settings.threads,
                                      {},
                                      !subject.one_case->negative_values.empty()},
                                     study.context.stop);
  if (!made) return std::nullopt;
  wanted.cpu_seconds = made->cost.cpu_seconds;
  wanted.wall_seconds = made->cost.wall_seconds;
  wanted.render_seconds = made->cost.render_seconds;
  if (is_fixed) return wanted;
  metrics::CompareSettings settings{
      metrics::NegativePixels::Allowed, 0, false, true, {"relmse_eps01", "mse", "psnr_srgb8", "flip"}};
  const auto comparison = metrics::compare(made->image, subject.reference, subject.mask, settings);
  wanted.relmse = metrics::value_of(comparison, "relmse_eps01");
  wanted.mse = metrics::value_of(comparison, "mse");
  wanted.psnr_srgb8 = metrics::value_of(comparison, "psnr_srgb8");
  wanted.flip = metrics::value_of(comparison, "flip");
  if (kept_as) keep_image(study, wanted, made->image, *kept_as);
  return wanted;
}

}  // namespace orbs::studies
