#include "results/record.h"

#include "json/document.h"
#include "json/field_reader.h"
#include "json/field_writer.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::results {

JobsById jobs_by_id(const RunRecord& run) {
  JobsById jobs;
  for (const auto& job : run.jobs) jobs.try_emplace(job.identity.id, &job);
  return jobs;
}

std::string references_note(const RunRecord& run) {
  std::vector<std::string> names;
  for (const auto& renderer : run.renderers)
    if (renderer.could_read_references) names.push_back(renderer.name);
  if (names.empty()) return "";
  return fmt::format(
      "The references were not hidden from {}, which could have made images from them: --sandbox hides them.",
      fmt::join(names, ", "));
}

std::string command_of(const JobsById& jobs, const TargetRecord& target) {
  std::string commands;
  for (const auto& id : target.jobs)
    if (const auto job = jobs.find(id); job != jobs.end() && !job->second->program.shell.empty())
      commands += (commands.empty() ? "" : " ; ") + job->second->program.shell;
  return commands;
}

bool judged_nothing(const RunRecord& run) {
  return std::all_of(run.targets.begin(), run.targets.end(),
                     [](const TargetRecord& target) { return target.verdict == Verdict::Unsupported; });
}

int exit_status(const RunRecord& run) {
  if (judged_nothing(run)) return 2;
  const bool failed = std::any_of(run.targets.begin(), run.targets.end(), [](const TargetRecord& target) {
    return target.declared && counts_as_failure(target.verdict, target.expectation);
  });
  return failed ? 1 : 0;
}

using json::ObjectReader;

JobFile read_job_file(const std::filesystem::path& file) {
  const auto document = json::parse_file(file);
  ObjectReader in(document);
  json::check_format(in, "orbs-job/2");
  JobFile content;
  json::FieldReader read(in);
  fields(read, content.job);
  read("targets", content.targets);
  return content;
}

RunRecord read_results_file(const std::filesystem::path& file) {
  const auto document = json::parse_file(file);
  ObjectReader in(document);
  json::check_format(in, "orbs-results/2");
  RunRecord run;
  json::FieldReader read(in);
  fields(read, run);
  run.folder = std::filesystem::absolute(file).parent_path().string();
  run.name = std::filesystem::path(run.folder).filename().string();
  for (auto& job : run.jobs)
    if (job.cost.host == Host{}) job.cost.host = run.host;
  return run;
}

std::string scenes_json(const std::vector<SceneRecord>& scenes) {
  json::Writer out;
  out.begin_object().member("format", "orbs-effects/1");
  json::FieldWriter{out}("scenes", scenes);
  return out.end_object().text();
}

std::string job_json(const JobRecord& job, const std::vector<TargetRecord>& targets) {
  json::Writer out;
  out.begin_object().member("format", "orbs-job/2");
  json::write_fields(out, job);
  json::FieldWriter{out}("targets", targets);
  return out.end_object().text();
}

std::string run_json(const RunRecord& run) {
  auto stored = run;
  for (auto& job : stored.jobs)
    if (job.cost.host == run.host) job.cost.host = {};
  json::Writer out;
  out.begin_object().member("format", "orbs-results/2").member("exit_status", exit_status(run));
  json::write_fields(out, stored);
  return out.end_object().text();
}

}  // namespace orbs::results
