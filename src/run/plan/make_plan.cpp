#include "run/plan/make_plan.h"

#include "adapters/job.h"
#include "adapters/native_scene.h"
#include "adapters/process/programs.h"
#include "base/error.h"
#include "base/files.h"
#include "judge/gate.h"
#include "judge/judge.h"
#include "metrics/mask.h"
#include "registry/cases.h"
#include "registry/image_size.h"
#include "run/condition.h"
#include "run/expected.h"
#include "run/looks.h"
#include "run/plan/choose_renderers.h"
#include "run/plan/plan_file.h"
#include "run/plan/render_seconds.h"
#include "run/plan/scenes.h"

#include <algorithm>
#include <map>
#include <set>
#include <thread>
#include <utility>

#include <fmt/format.h>

namespace orbs::run {

namespace {

void check_regions(const Plan& plan, const registry::Case& one_case) {
  const auto check = [&](const std::string& target, const Rectangle& region) {
    const auto& camera = scene_of_target(plan, one_case, target)->scene->camera;
    if (region.x1 > camera.width_px || region.y1 > camera.height_px)
      throw InputError(fmt::format("{}: the rectangle {} of '{}' reaches beyond its {} x {} pixels",
                                   one_case.file.string(), rectangle_text(region), target, camera.width_px,
                                   camera.height_px));
  };
  for (const auto& mask : one_case.masks) {
    for (const auto& rectangle : mask.rectangles) check(mask.target, rectangle);
    const auto& camera = scene_of_target(plan, one_case, mask.target)->scene->camera;
    with_note(fmt::format("reading the masks of '{}' in {}", mask.target, one_case.file.string()), [&] {
      metrics::included_pixels(judge::mask_of(one_case, mask.target), camera.width_px, camera.height_px);
    });
  }
  for (const auto& pixels : one_case.pixel_checks) check(pixels.target, pixels.region);
}

// Everything that makes the image what it is, but not the folder and the time: the same id in every run.
std::string job_id(const Plan& plan,
                   const PlannedScene& scene,
                   const ChosenRenderer& renderer,
                   const PlannedJob& job) {
  auto text = fmt::format("{}\n{}\n{}\n{}\n{}", plan.suite.name, scene.name, renderer.entry.name, job.spp,
                          plan.settings.seed);
  if (job.first_spp > 0) text += fmt::format("\nlooks from {}", job.first_spp);
  if (const int divisor = scene.size_divisor; divisor != 1)
    text += fmt::format("\n{}", registry::size_text(divisor));
  return hash_text(content_hash(text));
}

std::size_t job_for(Plan& plan, const std::string& scene_name, std::size_t renderer) {
  const auto found = std::find_if(plan.jobs.begin(), plan.jobs.end(), [&](const PlannedJob& job) {
    return job.renderer == renderer && plan.scenes[job.scene].name == scene_name;
  });
  if (found != plan.jobs.end()) return static_cast<std::size_t>(found - plan.jobs.begin());
  PlannedJob job;
  job.renderer = renderer;
  while (plan.scenes[job.scene].name != scene_name) ++job.scene;
  const auto& scene = plan.scenes[job.scene];
  const auto& chosen = plan.renderers[renderer];
  const auto scaled = [&](int spp) {
    return adapters::scaled_spp(spp, chosen.entry.sampling.spp_scale, plan.settings.spp_scale);
  };
  job.first_spp = first_look_spp(plan, chosen.entry);
  // What a smaller image needs more for its means, looks find out themselves.
  job.spp = job.first_spp > 0 ? scaled(scene.spp) : scaled(enough_spp(scene, chosen.entry));
  job.id = job_id(plan, scene, chosen, job);
  job.folder = std::filesystem::path(chosen.entry.name) / scene.name;
  job.native_scene = adapters::native_scene(chosen.entry, scene.file, scene.name);
  plan.jobs.push_back(job);
  return plan.jobs.size() - 1;
}

bool declares(const Plan& plan, std::size_t renderer, const registry::Case& one_case) {
  return registry::has_feature(plan.renderers[renderer].entry.support.declares,
                               registry::parse_requirement(one_case.requirement));
}

// Jobs are started in their order. One scene of each requirement comes first, by every renderer, so that the
// table of a run fills evenly while it goes on, and one that is interrupted says something of everything.
void plan_first_jobs(Plan& plan) {
  std::set<std::string> begun;
  for (const auto& one_case : plan.cases) {
    if (!begun.insert(one_case.requirement).second) continue;
    const auto& scene = one_case.scenes.front().name;
    for (std::size_t renderer = 0; renderer < plan.renderers.size(); ++renderer)
      if (declares(plan, renderer, one_case) &&
          why_not_at_size(plan, plan.renderers[renderer].entry, one_case, scene, {scene}).empty())
        job_for(plan, scene, renderer);
  }
}

void plan_targets(Plan& plan) {
  for (std::size_t renderer = 0; renderer < plan.renderers.size(); ++renderer)
    for (std::size_t c = 0; c < plan.cases.size(); ++c) {
      const auto& one_case = plan.cases[c];
      const bool declared = declares(plan, renderer, one_case);
      const auto add = [&](const std::string& target, const std::vector<std::string>& scenes) {
        PlannedTarget planned{c, renderer, target, {}, declared};
        if (declared)
          planned.unsupported =
              why_not_at_size(plan, plan.renderers[renderer].entry, one_case, target, scenes);
        if (declared && planned.unsupported.empty())
          for (const auto& scene : scenes) planned.jobs.push_back(job_for(plan, scene, renderer));
        plan.targets.push_back(std::move(planned));
      };
      for (const auto& scene : one_case.scenes) add(scene.name, {scene.name});
      for (const auto& difference : one_case.differences)
        add(difference.name, {difference.of, difference.minus});
    }
}

bool may_be_negative(const Plan& plan, const PlannedJob& job) {
  return std::any_of(plan.targets.begin(), plan.targets.end(), [&](const PlannedTarget& target) {
    return target.renderer == job.renderer && target.target == plan.scenes[job.scene].name &&
           !plan.cases[target.one_case].negative_values.empty();
  });
}

int threads_per_job(const registry::RunSettings& settings) {
  if (settings.threads > 0) return settings.threads;
  const int cores = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  return std::max(1, cores / settings.jobs);
}

}  // namespace

Plan make_plan(const registry::Configuration& configuration,
               const registry::RunSettings& settings,
               const std::filesystem::path& program_folder,
               RenderPlace place) {
  Plan plan;
  plan.place = place;
  plan.settings = settings;
  plan.configuration = configuration.file;
  plan.below = configuration.below;
  plan.root = configuration.root;
  plan.build = program_folder;
  plan.suite = registry::find_suite(configuration, settings.suite);
  plan.threads = threads_per_job(settings);
  choose_renderers(configuration, plan);
  const auto all = registry::load_cases(plan.suite);
  plan.cases = registry::choose_cases(all, settings);
  refuse_unknown_expected(configuration, plan.suite, all);
  plan.expected = configuration.expected;
  load_scenes(plan);
  hash_references(all, plan);
  for (const auto& one_case : plan.cases) {
    judge::refuse_unknown_metrics(one_case);
    check_regions(plan, one_case);
  }
  reduce_size(plan);
  plan_first_jobs(plan);
  plan_targets(plan);
  for (auto& job : plan.jobs) job.may_be_negative = may_be_negative(plan, job);
  plan_conditions(plan);
  const auto seconds = estimated_cpu_seconds(plan);
  for (std::size_t job = 0; job < plan.jobs.size(); ++job) plan.jobs[job].cpu_seconds = seconds[job];
  plan.id = plan_id(plan);
  refuse_missing_programs(plan);
  return plan;
}

}  // namespace orbs::run
