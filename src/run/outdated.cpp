#include "run/outdated.h"

#include "adapters/native_scene.h"
#include "base/files.h"
#include "json/field_writer.h"
#include "run/job_folder.h"
#include "run/prepare.h"

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

}  // namespace orbs::run
