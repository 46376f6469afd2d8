#include "run/render.h"

#include "base/error.h"
#include "base/files.h"
#include "image/colour.h"
#include "image/image_io.h"
#include "judge/judge.h"
#include "judge/noise.h"
#include "metrics/compare.h"
#include "metrics/pixel_errors.h"
#include "run/host.h"
#include "run/job_folder.h"
#include "studies/cost/curve.h"
#include "studies/cost/render.h"

#include <algorithm>

#include <fmt/format.h>

namespace orbs::studies {

namespace {

ReferenceNoise noise_of(const image::Image& reference, const metrics::Mask& mask) {
  ReferenceNoise noise;
  const auto included = metrics::included_pixels(mask, reference.width, reference.height);
  double count = 0;
  for (const char* colour : {"R", "G", "B"}) {
    const int variance = image::channel_index(reference, std::string("variance.") + colour);
    if (variance < 0) continue;
    const auto value = static_cast<std::size_t>(image::channel_index(reference, colour));
    for (int y = 0; y < reference.height; ++y)
      for (int x = 0; x < reference.width; ++x) {
        if (included[static_cast<std::size_t>(y) * static_cast<std::size_t>(reference.width) +
                     static_cast<std::size_t>(x)] == 0)
          continue;
        const double of_pixel = static_cast<double>(reference.at(x, y, static_cast<std::size_t>(variance)));
        const double level = static_cast<double>(reference.at(x, y, value));
        noise.mse += of_pixel;
        noise.relmse += of_pixel / (level * level + metrics::relmse::kEpsilon);
        ++count;
      }
  }
  if (count == 0) return noise;
  noise.mse /= count;
  noise.relmse /= count;
  if (const auto srgb8 = judge::noise_mse_srgb8(reference, reference); srgb8 && *srgb8 > 0)
    noise.psnr_srgb8 = judge::psnr_srgb8_of(*srgb8);
  return noise;
}

// The case that a scene is known by: that in whose folder its file lies, if a chosen case has it, for others
// may look at it as well. Else the first.
const registry::Case& own_case(const run::Plan& plan,
                               const std::string& target,
                               const registry::Case& first) {
  for (const auto& one_case : plan.cases)
    for (const auto& scene : one_case.scenes)
      if (scene.name == target &&
          scene.file.lexically_normal().parent_path() == one_case.file.lexically_normal().parent_path())
        return one_case;
  return first;
}

bool is_known(const std::vector<CostSubject>& subjects, const std::string& target) {
  return std::any_of(subjects.begin(), subjects.end(),
                     [&](const CostSubject& subject) { return subject.target.name == target; });
}

}  // namespace

std::vector<CostSubject> load_cost_subjects(const run::Plan& plan, const std::filesystem::path& folder) {
  std::vector<CostSubject> subjects;
  make_folder(folder / "images/reference");
  for (const auto& planned : plan.targets) {
    const auto& name = planned.target;
    if (planned.jobs.empty() || is_known(subjects, name)) continue;
    if (judge::is_difference(plan.cases[planned.one_case], name)) continue;
    const auto& one_case = own_case(plan, name, plan.cases[planned.one_case]);
    auto reference = judge::load_reference(one_case, name, plan.suite.references, plan.reference_hashes, {},
                                           registry::reduced_size(plan.settings));
    if (!reference.image) throw InputError(reference.problem);
    CostSubject subject;
    subject.one_case = &one_case;
    subject.scene = &*std::find_if(plan.scenes.begin(), plan.scenes.end(),
                                   [&](const auto& scene) { return scene.name == name; });
    subject.reference = std::move(*reference.image);
    subject.mask = judge::mask_of(one_case, name);
    subject.target = {name,
                      one_case.requirement,
                      one_case.title,
                      subject.reference.width,
                      subject.reference.height,
                      fmt::format("images/reference/{}.exr", name),
                      noise_of(subject.reference, subject.mask)};
    image::write_exr(subject.reference, folder / subject.target.reference);
    subjects.push_back(std::move(subject));
  }
  if (subjects.empty()) throw InputError("none of the chosen renderers renders a scene of the chosen cases");
  return subjects;
}

namespace {

run::ChosenRenderer with_settings(run::ChosenRenderer renderer, const std::string& setting) {
  for (const auto& quality : renderer.entry.timing.cost_sweep)
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
  const auto& listed = chosen.entry.timing.cost_sweep;
  // Some renderers refuse fewer samples than the independent blocks that they are told to make. The 128
  // samples of 4 x 4 px take less than a millisecond.
  constexpr int kFixedSpp = 8;
  if (is_fixed && listed.empty()) wanted.spp = kFixedSpp;
  const auto& setting = is_fixed && !listed.empty() ? listed.front().name : wanted.setting;
  const auto prepared = run::prepare_render(with_settings(chosen, setting), study.plan, scene, folder,
                                            subject.scene->wall_seconds);
  wanted.load = run::load_average();
  wanted.order = static_cast<int>(study.record.renders.size());
  const auto before = study.request.machine_time();
  // Of a sequence, the fixed cost is that of its first image: its seeds count how often it was measured.
  const bool is_first = is_fixed && study.record.renderers[wanted.renderer].sequence_images > 0;
  const auto made = run::render_once(prepared,
                                     {wanted.spp,
                                      is_first ? 1 : wanted.seed,
                                      study.record.settings.threads,
                                      {},
                                      !subject.one_case->negative_values.empty()},
                                     study.context.stop);
  if (!made) return std::nullopt;
  const auto after = study.request.machine_time();
  wanted.images = made->cost.images;
  wanted.cpu_seconds = made->cost.cpu_seconds;
  if (before && after)
    wanted.other_share =
        run::share_of_others(*before, *after, wanted.cpu_seconds + made->cost.supervisor_cpu_seconds);
  wanted.wall_seconds = made->cost.wall_seconds;
  wanted.render_seconds = made->cost.render_seconds;
  wanted.trial_seconds = made->cost.trial_seconds;
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
