#include "results/record_json.h"

#include "json/document.h"
#include "results/field_reader.h"
#include "results/field_writer.h"

namespace orbs::results {

using json::ObjectReader;

JobFile read_job_file(const std::filesystem::path& file) {
  const auto document = json::parse_file(file);
  ObjectReader in(document);
  check_format(in, "orbs-job/2");
  JobFile content;
  FieldReader read(in);
  fields(read, content.job);
  read("targets", content.targets);
  return content;
}

RunRecord read_results_file(const std::filesystem::path& file) {
  const auto document = json::parse_file(file);
  ObjectReader in(document);
  check_format(in, "orbs-results/2");
  RunRecord run;
  FieldReader read(in);
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
  FieldWriter{out}("scenes", scenes);
  return out.end_object().text();
}

std::string job_json(const JobRecord& job, const std::vector<TargetRecord>& targets) {
  json::Writer out;
  out.begin_object().member("format", "orbs-job/2");
  write_fields(out, job);
  FieldWriter{out}("targets", targets);
  return out.end_object().text();
}

std::string run_json(const RunRecord& run) {
  auto stored = run;
  for (auto& job : stored.jobs)
    if (job.cost.host == run.host) job.cost.host = {};
  json::Writer out;
  out.begin_object().member("format", "orbs-results/2").member("exit_status", exit_status(run));
  write_fields(out, stored);
  return out.end_object().text();
}

}  // namespace orbs::results
