#include "run/resume.h"

#include "adapters/native_scene.h"
#include "base/error.h"
#include "base/files.h"
#include "image/image_io.h"
#include "json/field_writer.h"
#include "run/job_folder.h"
#include "run/prepare.h"
#include "run/renderer_version.h"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

namespace orbs::run {

namespace {

// The words of the commands as the job gets them. Not those of the configuration: an exporter of another
// version may fill the same words with other values. They are named within the folder, so that a run may be
// moved.
std::vector<std::string> command_words(const Plan& plan, const PlannedJob& job) {
  std::vector<std::string> words;
  for (const auto& replica : replicas_of(plan, job, "/"))
    for (const auto& word : replica.argv) words.push_back(named_within(replica.folder, word));
  return words;
}

}  // namespace

std::string scene_hash(const Plan& plan, const PlannedJob& job) {
  const auto& scene = plan.scenes[job.scene];
  if (job.native_scene.empty()) return hash_text(scene.hash);
  return hash_text(content_hash(hash_text(adapters::native_scene_hash(job.native_scene)), scene.hash));
}

std::string settings_hash(const Plan& plan, const PlannedJob& job) {
  const auto& executable = plan.renderers[job.renderer].executable;
  json::Writer out;
  out.begin_object().member("program", executable.string()).member("words", command_words(plan, job));
  out.member("threads", plan.threads).member("may_be_negative", job.may_be_negative);
  if (job.has_condition)
    out.member("double_precision", plan.renderers[job.renderer].entry.command.double_precision);
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

namespace fs = std::filesystem;
using results::JobFile;
using results::JobOutcome;
using results::JobRecord;

// What an earlier run left of this render; nothing when there is nothing, or nothing whole.
std::optional<JobFile> found_job(const fs::path& folder) {
  std::error_code ignored;
  if (!fs::exists(folder / "job.json", ignored)) return std::nullopt;
  try {
    return results::read_job_file(folder / "job.json");
  } catch (const InputError&) {
    return std::nullopt;
  }
}

// How many targets the plan judges from this job alone.
std::size_t targets_of(const Plan& plan, std::size_t job) {
  return static_cast<std::size_t>(
      std::count_if(plan.targets.begin(), plan.targets.end(),
                    [&](const auto& target) { return target.jobs == std::vector<std::size_t>{job}; }));
}

// Outcomes that may have had their cause in the machine, and not in the renderer.
bool is_worth_another_try(JobOutcome outcome) {
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

// Why an existing render must be rendered again; nothing when it need not. A crash, a timeout or a missing
// image may have had its cause in the machine and is always tried again.
std::optional<std::string> why_outdated(const JobRecord& found, const JobRecord& now) {
  if (found.identity.id != now.identity.id) return "its samples or its seed have changed";
  if (found.hashes.scene != now.hashes.scene) return "its scene has changed";
  if (is_other_version(found.program.version, now.program.version))
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

}  // namespace

Resumption resumption_of(const Plan& plan,
                         std::size_t job,
                         const JobRecord& now,
                         const WorkFolders& folders) {
  const auto& planned = plan.jobs[job];
  auto found = found_job(folders.run / planned.folder);
  if (!found) return {};
  auto today = now;
  today.hashes.files = files_hash(plan, planned, found->job, folders.run);
  if (auto reason = why_outdated(found->job, today)) return {Step::Render, std::move(*reason)};
  const bool is_judged =
      found->job.hashes.judged == now.hashes.judged && found->targets.size() == targets_of(plan, job);
  return {is_judged ? Step::Keep : Step::Judge, "", std::move(found)};
}

std::optional<Execution> take_over(const JobRecord& found,
                                   const fs::path& folder,
                                   const WorkFolders& folders) {
  Execution execution{found, {}};
  try {
    if (has_image(found)) execution.image = image::read_image(folders.run / found.files.image);
  } catch (const InputError&) {
    return std::nullopt;
  }
  const auto unfinished = folders.unfinished / folder;
  make_folder(unfinished);
  for (const auto& entry : fs::directory_iterator(folders.run / folder))
    if (entry.symlink_status().type() == fs::file_type::regular && entry.path().filename() != "job.json")
      fs::copy_file(entry.path(), unfinished / entry.path().filename());
  return execution;
}

}  // namespace orbs::run
