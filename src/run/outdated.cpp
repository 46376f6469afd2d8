#include "run/outdated.h"

#include "adapters/job.h"
#include "adapters/native_scene.h"
#include "base/files.h"
#include "json/field_writer.h"
#include "run/plan/job_limits.h"
#include "run/plan/scene_hash.h"
#include "run/prepare.h"

#include <fmt/format.h>

namespace orbs::run {

namespace {

// The words of the command as the job gets them. Not those of the configuration: an exporter of another
// version may fill the same words with other values. The folder is that of no job, so that a run may be
// moved.
std::vector<std::string> command_words(const Plan& plan, const PlannedJob& job) {
  const auto& chosen = plan.renderers[job.renderer];
  adapters::JobSettings settings;
  settings.spp = job.spp;
  settings.seed = plan.settings.seed;
  settings.threads = plan.threads;
  settings.root = plan.root;
  settings.build = plan.build;
  settings.executable = chosen.executable;
  settings.arguments = scene_arguments(plan, job);
  return adapters::make_job(chosen.entry, *plan.scenes[job.scene].scene, settings, "/").argv;
}

}  // namespace

std::string scene_hash(const Plan& plan, const PlannedJob& job) {
  const auto& scene = plan.scenes[job.scene];
  auto hash = scene_content_hash(*scene.scene, scene.file);
  if (!job.native_scene.empty())
    hash = content_hash(hash_text(adapters::native_scene_hash(job.native_scene)), hash);
  return hash_text(hash);
}

std::string settings_hash(const Plan& plan, const PlannedJob& job) {
  const auto& executable = plan.renderers[job.renderer].executable;
  json::Writer out;
  out.begin_object().member("program", executable.string()).member("words", command_words(plan, job));
  out.member("threads", plan.threads).member("may_be_negative", job.may_be_negative);
  json::write_fields(out, entry_for(plan, job), [](const json::Field& field) { return field.changes_image; });
  return hash_text(content_hash(out.end_object().text()));
}

std::string limits_hash(const Plan& plan, const PlannedJob& job) {
  const auto limits = limits_of(plan, job);
  return hash_text(content_hash(fmt::format("{} {} {} {} {}", limits.wall_seconds,
                                            limits.cpu_seconds.value_or(0), limits.memory_bytes.value_or(0),
                                            limits.output_bytes.value_or(0), limits.grace_seconds)));
}

std::string judged_hash(const Plan& plan,
                        std::size_t index,
                        const judge::ReferenceCopies& references,
                        const std::string& orbs_version) {
  auto hash = content_hash(orbs_version);
  if (plan.renderers[plan.jobs[index].renderer].entry.sampling.is_noise_free)
    hash = content_hash("noise-free", hash);
  for (const auto& planned : plan.targets) {
    if (planned.jobs.size() != 1 || planned.jobs.front() != index) continue;
    const auto& one_case = plan.cases[planned.one_case];
    hash = content_hash(planned.target, content_hash(read_file(one_case.file), hash));
    for (const auto& scene : one_case.scenes) {
      if (scene.name != planned.target) continue;
      const auto copied = references.copied.find(registry::reference_name(scene) + ".exr");
      hash = content_hash(plan.reference_hashes.at(scene.name), hash);
      if (copied != references.copied.end()) hash = content_hash(copied->second.hash, hash);
      for (const auto& accepted : scene.accepted)
        if (const auto other = references.copied.find(accepted.reference + ".exr");
            other != references.copied.end())
          hash = content_hash(other->second.hash, hash);
    }
  }
  return hash_text(hash);
}

std::string files_hash(const Plan& plan,
                       const PlannedJob& job,
                       const results::JobRecord& record,
                       const std::filesystem::path& run_folder) {
  const auto scene_file = replicas_of(plan, job, run_folder).front().scene_file;
  auto hash = content_hash("");
  for (const auto& file : {scene_file, run_folder / record.files.image})
    if (no_file_problem(file).empty()) hash = content_hash(hash_text(content_hash(read_file(file))), hash);
  return hash_text(hash);
}

namespace {

// Outcomes that may have had their cause in the machine, and not in the renderer.
bool is_worth_another_try(results::JobOutcome outcome) {
  using results::JobOutcome;
  switch (outcome) {
    case JobOutcome::Crash:
    case JobOutcome::Timeout:
    case JobOutcome::OutOfMemory:
    case JobOutcome::NoOutput:
    case JobOutcome::Unreadable:
    case JobOutcome::Stale:
    case JobOutcome::Skipped:
      return true;
    case JobOutcome::Image:
    case JobOutcome::Unsupported:
    case JobOutcome::InvalidPixels:
    case JobOutcome::WrongChannels:
    case JobOutcome::WrongSize:
      return false;
  }
  return false;
}

}  // namespace

std::optional<std::string> why_outdated(const results::JobRecord& found, const results::JobRecord& now) {
  if (found.identity.id != now.identity.id) return "its samples or its seed have changed";
  if (found.hashes.scene != now.hashes.scene) return "its scene has changed";
  if (found.program.version != now.program.version)
    return fmt::format("it was rendered by '{}', now there is '{}'", found.program.version,
                       now.program.version);
  if (found.hashes.settings != now.hashes.settings) return "its command, environment or threads have changed";
  if (found.hashes.program != now.hashes.program)
    return "its program, or a file that its command names, has changed";
  if (found.hashes.files != now.hashes.files)
    return "its scene file or image in the folder of the run has changed";
  // An image that was finished within the old limits is the same under new ones.
  if (!has_image(found) && found.hashes.limits != now.hashes.limits) return "its limits have changed";
  if (is_worth_another_try(found.end.outcome))
    return fmt::format("it ended without an image ({}) and is tried again",
                       job_outcome_name(found.end.outcome));
  return std::nullopt;
}

}  // namespace orbs::run
