#include "run/plan/reduced_size.h"

#include "adapters/native_scene.h"
#include "base/error.h"
#include "judge/judge.h"
#include "metrics/mask.h"
#include "registry/image_size.h"
#include "registry/placeholders.h"

#include <algorithm>
#include <memory>

#include <fmt/format.h>

namespace orbs::run {

namespace {

void reduce_camera(PlannedScene& planned, int divisor) {
  const auto& camera = planned.scene->camera;
  if (camera.width_px % divisor != 0 || camera.height_px % divisor != 0) {
    planned.size_problem = fmt::format("{} x {} px of scene '{}' cannot be divided by {} in both directions",
                                       camera.width_px, camera.height_px, planned.name, divisor);
    return;
  }
  // The same field of view: it is given by fov_y and the ratio of width and height.
  auto reduced = *planned.scene;
  reduced.camera.width_px /= divisor;
  reduced.camera.height_px /= divisor;
  planned.scene = std::make_shared<const scene::Scene>(std::move(reduced));
}

std::string mask_problem(const registry::Case& one_case,
                         const std::string& target,
                         const scene::Camera& camera) {
  try {
    metrics::included_pixels(judge::mask_of(one_case, target), camera.width_px, camera.height_px);
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

}  // namespace

void reduce_size(Plan& plan) {
  const int divisor = plan.settings.size_divisor;
  if (divisor == 1) return;
  for (auto& scene : plan.scenes) reduce_camera(scene, divisor);
  for (auto& one_case : plan.cases) one_case = registry::reduced_case(std::move(one_case), divisor);
}

int enough_spp(const Plan& plan, const PlannedScene& scene, const registry::Renderer& renderer) {
  if (plan.settings.size_divisor == 1 || renderer.sampling.is_noise_free) return scene.spp;
  const int pixels = scene.scene->camera.width_px * scene.scene->camera.height_px;
  return std::max(scene.spp, (scene.camera_paths + pixels - 1) / pixels);
}

std::string why_not_at_size(const Plan& plan,
                            const registry::Renderer& renderer,
                            const registry::Case& one_case,
                            const std::string& target,
                            const std::vector<std::string>& scenes) {
  const int divisor = plan.settings.size_divisor;
  if (divisor == 1) return "";
  const auto prefix = fmt::format("not measured at {}: ", registry::size_text(divisor));
  if (!renderer.sampling.has_box_filter)
    return fmt::format(
        "{}{} does not filter by a box of one pixel (box_filter), so its image is no average "
        "of the full one",
        prefix, renderer.name);
  const bool command_has_size = registry::uses_placeholder(renderer.command.words, "width") &&
                                registry::uses_placeholder(renderer.command.words, "height");
  for (const auto& name : scenes) {
    const auto planned = std::find_if(plan.scenes.begin(), plan.scenes.end(),
                                      [&](const auto& scene) { return scene.name == name; });
    if (!planned->size_problem.empty()) return prefix + planned->size_problem;
    if (!command_has_size && !adapters::native_scene(renderer, planned->file, name).empty())
      return fmt::format(
          "{}the hand-written scene '{}' has a size of its own, as the command does not use "
          "{{width}} and {{height}}",
          prefix, name);
    if (const auto problem = mask_problem(one_case, target, planned->scene->camera); !problem.empty())
      return prefix + problem;
  }
  return "";
}

}  // namespace orbs::run
