#include "run/condition.h"

#include "base/files.h"
#include "base/text.h"
#include "metrics/pixel_difference.h"
#include "run/job_folder.h"
#include "run/prepare.h"

#include <algorithm>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace orbs::run {

namespace {

bool is_bounded(const Plan& plan, std::size_t job) {
  return std::any_of(plan.targets.begin(), plan.targets.end(), [&](const PlannedTarget& target) {
    return target.jobs == std::vector<std::size_t>{job} && plan.cases[target.one_case].condition.has_value();
  });
}

// One process, as the job's own, but for its samples, its image and what follows the command.
RenderJob render_of(const RenderJob& job, adapters::Job replica, const std::vector<std::string>& arguments) {
  const auto& first = job.replicas.front();
  replica.argv.insert(replica.argv.end(), arguments.begin(), arguments.end());
  replica.id = first.id;
  replica.scene_file_hash = first.scene_file_hash;
  replica.ready_since = first.ready_since;
  replica.may_be_negative = first.may_be_negative;
  auto one = job;
  one.replicas = {std::move(replica)};
  return one;
}

std::string shell_of(const PlannedJob& planned, const std::vector<RenderJob>& renders) {
  auto text = "cd " + shell_text({planned.folder.string()});
  for (const auto& render : renders) {
    const auto& job = render.replicas.front();
    auto words = job.argv;
    for (auto& word : words) word = named_within(job.folder, std::move(word));
    text += " && " + shell_command(environment_of(render.renderer, job), words);
  }
  return text;
}

void add_times(const Rendered& rendered, results::JobCondition& condition, results::JobCost& cost) {
  for (const auto& process : rendered.processes) {
    const double cpu_seconds = process.user_seconds + process.system_seconds;
    condition.cpu_seconds += cpu_seconds;
    cost.cpu_seconds += cpu_seconds;
    cost.wall_seconds += process.wall_seconds;
    cost.peak_rss_bytes = std::max(cost.peak_rss_bytes, process.peak_rss_bytes);
  }
}

}  // namespace

void plan_conditions(Plan& plan) {
  if (plan.place == RenderPlace::Elsewhere || !plan.images.empty()) return;
  for (std::size_t job = 0; job < plan.jobs.size(); ++job)
    plan.jobs[job].has_condition =
        !plan.renderers[plan.jobs[job].renderer].entry.command.double_precision.empty() &&
        is_bounded(plan, job);
}

results::JobCondition measure_condition(const Plan& plan,
                                        const PlannedJob& planned,
                                        const RenderJob& job,
                                        const std::atomic<bool>* stop,
                                        results::JobCost& cost) {
  const auto& entry = plan.renderers[planned.renderer].entry;
  const int spp = std::max(std::min(kConditionSpp, planned.spp), entry.sampling.least_spp);
  const auto one = [&](const char* file, const std::vector<std::string>& arguments) {
    const auto& folder = job.replicas.front().folder;
    return render_of(job, one_render(plan, planned, folder, spp, file), arguments);
  };
  const std::vector<RenderJob> renders{one(kSinglePrecisionImage, {}),
                                       one(kDoublePrecisionImage, entry.command.double_precision)};
  results::JobCondition condition;
  condition.spp = spp;
  condition.shell = shell_of(planned, renders);
  std::vector<image::Image> images;
  for (const auto& render_job : renders) {
    auto rendered = render(render_job, stop);
    add_times(rendered, condition, cost);
    if (!rendered.outcome.image) {
      condition.problem = fmt::format("the render in {} precision: {}", images.empty() ? "single" : "double",
                                      rendered.outcome.reason);
      return condition;
    }
    images.push_back(std::move(*rendered.outcome.image));
  }
  const auto found = metrics::pixel_difference(images.front(), images.back());
  condition.pixels = found.mean;
  condition.x = found.x;
  condition.y = found.y;
  return condition;
}

void keep_condition_images(const std::filesystem::path& from, const std::filesystem::path& to) {
  for (const char* file : {kSinglePrecisionImage, kDoublePrecisionImage}) {
    if (!no_file_problem(from / file).empty()) continue;
    make_way(to / file);
    write_file(to / file, read_file(from / file));
  }
}

}  // namespace orbs::run
