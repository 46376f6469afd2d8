#include "results/read_record.h"

#include "json/document.h"
#include "results/field_reader.h"

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

}  // namespace orbs::results
