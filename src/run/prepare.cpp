#include "run/prepare.h"

#include "adapters/export.h"
#include "adapters/native_scene.h"
#include "base/files.h"
#include "registry/renderer_variants.h"

#include <algorithm>

#include <fmt/format.h>

namespace orbs::run {

std::vector<std::string> scene_arguments(const Plan& plan, const PlannedJob& job) {
  const auto& of_scene = plan.scenes[job.scene].arguments;
  const auto found = of_scene.find(registry::entry_of(plan.renderers[job.renderer].entry));
  return found == of_scene.end() ? std::vector<std::string>{} : found->second;
}

registry::Renderer entry_for(const Plan& plan, const PlannedJob& job) {
  return registry::for_scene(plan.renderers[job.renderer].entry, plan.scenes[job.scene].name);
}

ProcessLimits limits_of(const registry::Renderer& renderer, double case_seconds) {
  auto limits = renderer.limits;
  if (case_seconds > 0) limits.wall_seconds = std::min(limits.wall_seconds, case_seconds);
  return limits;
}

ProcessLimits limits_of(const Plan& plan, const PlannedJob& job) {
  return limits_of(plan.renderers[job.renderer].entry, plan.scenes[job.scene].wall_seconds);
}

std::variant<scene::Scene, std::string> scene_for(const Plan& plan, const PlannedJob& job) {
  const auto& planned = plan.scenes[job.scene];
  const auto renderer = entry_for(plan, job);
  if (!job.native_scene.empty()) return *planned.scene;
  if (renderer.format.name == registry::kNativeFormat)
    return fmt::format("it reads hand-written scenes only, and there is no {}",
                       adapters::native_scene_file(renderer, planned.file, planned.name).string());
  return adapters::prepare_scene(renderer, *planned.scene);
}

namespace {

// The name that a file of the scene has beside the scene; numbered, as files of two folders may have one
// name.
std::filesystem::path copied_file(const std::filesystem::path& file,
                                  int number,
                                  const std::filesystem::path& folder) {
  const auto name = fmt::format("{}-{}", number, file.filename().string());
  write_file(folder / name, read_file(file));
  return name;
}

scene::Scene with_files_beside(scene::Scene scene, const std::filesystem::path& folder) {
  int number = 0;
  for (auto& texture : scene.textures) texture.file = copied_file(texture.file, number++, folder);
  for (auto& light : scene.lights)
    if (light.ies) light.ies->file = copied_file(light.ies->file, number++, folder);
  return scene;
}

}  // namespace

void write_job_scene(const Plan& plan,
                     const PlannedJob& planned,
                     const scene::Scene& prepared,
                     const adapters::Job& job) {
  const auto renderer = entry_for(plan, planned);
  if (!planned.native_scene.empty()) {
    adapters::copy_native_scene(planned.native_scene, job.folder);
  } else if (plan.place == RenderPlace::Elsewhere && renderer.format.name == registry::kNeutralFormat) {
    adapters::export_scene(renderer, with_files_beside(prepared, job.folder), job.scene_file);
  } else {
    // The exporters of other formats write all files into the folder of the scene.
    adapters::export_scene(renderer, prepared, job.scene_file);
  }
}

std::vector<adapters::Job> replicas_of(const registry::Renderer& renderer,
                                       const scene::Scene& scene,
                                       const adapters::JobSettings& settings,
                                       const std::filesystem::path& folder) {
  const int seeds = renderer.sampling.seeds;
  if (seeds == 1) return {adapters::make_job(renderer, scene, settings, folder)};
  std::vector<adapters::Job> replicas;
  auto share = settings;
  share.spp = (settings.spp + seeds - 1) / seeds;
  for (int replica = 0; replica < seeds; ++replica) {
    share.seed = settings.seed + replica;
    share.image_file = fmt::format("seed-{}.exr", share.seed);
    replicas.push_back(adapters::make_job(renderer, scene, share, folder));
  }
  return replicas;
}

namespace {

adapters::JobSettings settings_of(const Plan& plan, const PlannedJob& job) {
  adapters::JobSettings settings;
  settings.spp = job.spp;
  settings.seed = plan.settings.seed;
  settings.threads = plan.threads;
  settings.root = plan.root;
  settings.build = plan.build;
  settings.executable = plan.renderers[job.renderer].executable;
  settings.arguments = scene_arguments(plan, job);
  settings.scene_file = job.native_scene.filename().string();
  return settings;
}

}  // namespace

adapters::Job one_render(const Plan& plan,
                         const PlannedJob& job,
                         const std::filesystem::path& folder,
                         int spp,
                         const std::string& image_file) {
  auto settings = settings_of(plan, job);
  settings.spp = spp;
  settings.image_file = image_file;
  return adapters::make_job(entry_for(plan, job), *plan.scenes[job.scene].scene, settings, folder);
}

std::vector<adapters::Job> replicas_of(const Plan& plan,
                                       const PlannedJob& job,
                                       const std::filesystem::path& run_folder) {
  const auto entry = entry_for(plan, job);
  auto settings = settings_of(plan, job);
  if (job.look) {
    std::vector<adapters::Job> two;
    settings.spp = job.look->spp;
    for (const int seed : job.look->seeds) {
      settings.seed = seed;
      settings.image_file = fmt::format("seed-{}.exr", seed);
      two.push_back(
          adapters::make_job(entry, *plan.scenes[job.scene].scene, settings, run_folder / job.folder));
    }
    return two;
  }
  return replicas_of(entry, *plan.scenes[job.scene].scene, settings, run_folder / job.folder);
}

}  // namespace orbs::run
