#include "runner/prepare.h"

#include "adapters/export.h"
#include "adapters/native_scene.h"

#include <fmt/format.h>

namespace orbs::runner {

namespace {

adapters::JobSettings job_settings(const Plan& plan, const PlannedJob& job, int replica) {
  const auto& renderer = plan.renderers[job.renderer];
  const int seeds = renderer.entry.seeds;
  adapters::JobSettings settings;
  settings.spp = (job.spp + seeds - 1) / seeds;
  settings.seed = plan.settings.seed + replica;
  settings.threads = plan.threads;
  settings.root = plan.root;
  settings.build = plan.build;
  settings.executable = renderer.executable;
  if (seeds > 1) settings.image_file = fmt::format("seed-{}.exr", settings.seed);
  settings.scene_file = job.native_scene.filename().string();
  return settings;
}

}  // namespace

std::variant<scene::Scene, std::string> scene_for(const Plan& plan, const PlannedJob& job) {
  const auto& planned = plan.scenes[job.scene];
  const auto& renderer = plan.renderers[job.renderer].entry;
  if (!job.native_scene.empty()) return *planned.scene;
  if (renderer.scene_format == registry::kNativeFormat)
    return fmt::format("it reads hand-written scenes only, and there is no {}",
                       adapters::native_scene_file(renderer, planned.file, planned.name).string());
  return adapters::prepare_scene(renderer, *planned.scene);
}

std::vector<adapters::Job> replicas_of(const Plan& plan,
                                       const PlannedJob& job,
                                       const std::filesystem::path& run_folder) {
  const auto& renderer = plan.renderers[job.renderer].entry;
  std::vector<adapters::Job> replicas;
  for (int replica = 0; replica < renderer.seeds; ++replica)
    replicas.push_back(adapters::make_job(renderer, *plan.scenes[job.scene].scene,
                                          job_settings(plan, job, replica), run_folder / job.folder));
  return replicas;
}

}  // namespace orbs::runner
