#include "results/job_list.h"

#include "base/files.h"
#include "json/document.h"
#include "results/field_reader.h"
#include "results/field_writer.h"

namespace orbs::results {

void write_job_list(const JobList& list, const std::filesystem::path& folder) {
  json::Writer out;
  out.begin_object().member("format", "orbs-jobs/1");
  write_fields(out, list);
  write_file(folder / kJobListFile, out.end_object().text());
}

JobList read_job_list(const std::filesystem::path& folder) {
  const auto document = json::parse_file(folder / kJobListFile);
  json::ObjectReader in(document);
  check_format(in, "orbs-jobs/1");
  JobList list;
  FieldReader read(in);
  fields(read, list);
  return list;
}

}  // namespace orbs::results
