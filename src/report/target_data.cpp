#include "report/target_data.h"

#include "base/files_inside.h"
#include "base/text.h"
#include "json/field_writer.h"
#include "json/writer.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <system_error>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::report {

namespace {

using results::JobRecord;
using results::RunRecord;
using results::RunView;
using results::TargetRecord;

constexpr std::uint64_t kLogTail_bytes = 8192;

// The end of a log, from the start of a line. "" if the run's folder has no such file: a results.json from
// elsewhere may name any path.
std::string log_tail(const RunRecord& run, const std::string& name) {
  const auto file = open_inside(run.folder, name);
  if (!file) return "";
  const auto begin = file->size() > kLogTail_bytes ? file->size() - kLogTail_bytes : 0;
  const auto text = file->read(begin, kLogTail_bytes);
  return begin > 0 ? text.substr(std::min(text.find('\n') + 1, text.size())) : text;
}

std::vector<ImageFile> images_of(const TargetRecord& target) {
  std::vector<ImageFile> images;
  if (!target.image.empty()) images.push_back({"result", "result", target.image});
  if (!target.reference_image.empty()) images.push_back({"reference", "reference", target.reference_image});
  if (!target.proof.image.empty())
    images.push_back({target.proof.is_undone ? "fault undone" : "reference with fault", "proof",
                      target.proof.image,
                      target.proof.is_undone ? "the result with the fault undone that the diagnosis names"
                                             : "the reference with the fault that the diagnosis names"});
  for (const auto& map : target.maps)
    images.push_back({map.name, "map", map.image, map.definition, map.is_signed, map.scale_maximum});
  return images;
}

// The folder as a shell of the user reaches it: a server keeps it open, under a name of its own process.
std::string folder_for_shell(const RunRecord& run) {
  std::error_code failed;
  const auto folder = std::filesystem::canonical(run.folder, failed);
  return failed ? run.folder : folder.string();
}

// The command that renders and judges this target again, and no other.
std::vector<std::string> run_command(const RunRecord& run, const TargetRecord& target, const JobRecord* job) {
  std::vector<std::string> words{"orbs",           "run",     "--suite",     run.suite,    "--case",
                                 target.case_name, "--scene", target.target, "--renderer", target.renderer};
  if (job != nullptr) words.insert(words.end(), {"--seed", std::to_string(job->identity.seed)});
  if (run.size != "1") words.insert(words.end(), {"--size", run.size});
  // Only the command line records the scale of the samples.
  const auto given = std::find(run.command_line.begin(), run.command_line.end(), "--spp-scale");
  if (given != run.command_line.end() && given + 1 != run.command_line.end())
    words.insert(words.end(), {*given, given[1]});
  return words;
}

// Whether `orbs run --accept-failures` would write an entry for the target that has none.
bool is_acceptable(const RunRecord& run, const TargetRecord& target) {
  const bool is_strict_enough = target.verdict != results::Verdict::PassWithRemarks || run.strict;
  return target.declared && is_strict_enough && results::can_be_expected(target.verdict) &&
         target.expectation != results::Expectation::Known;
}

void add_commands(const RunRecord& run,
                  const TargetRecord& target,
                  const JobRecord* job,
                  TargetDetail& detail) {
  auto words = run_command(run, target, job);
  detail.command = shell_text(words);
  words.emplace_back("--accept-failures");
  if (is_acceptable(run, target)) detail.accept_command = shell_text(words);
  std::vector<std::string> reference{"orbs",   "reference",      "--suite", run.suite,
                                     "--case", target.case_name, "--scene", target.target};
  if (target.verdict != results::Verdict::MissingReference) reference.emplace_back("--accept");
  detail.reference_command = shell_text(reference);
}

}  // namespace

TargetDetail target_detail(const RunView& view, std::size_t index) {
  const auto& run = view.run;
  const auto& target = run.targets.at(index);
  TargetDetail detail{.case_name = target.case_name,
                      .target = target.target,
                      .renderer = target.renderer,
                      .requirement = target.requirement,
                      .reason = reason_text(target),
                      .reference = target.reference,
                      .remarks = target.remarks,
                      .diagnosis = target.diagnosis,
                      .hidden = target.hidden,
                      .measures = target.measures,
                      .checks = target.checks,
                      .looks = target.looks,
                      .wrong_regions = target.wrong_regions,
                      .images = images_of(target),
                      .reference_provenance = target.reference_provenance,
                      .jobs = {},
                      .scenes = {},
                      .command = {},
                      .accept_command = {},
                      .reference_command = {}};
  const JobRecord* first = nullptr;
  for (const auto& job : run.jobs) {
    if (std::find(target.jobs.begin(), target.jobs.end(), job.identity.id) == target.jobs.end()) continue;
    if (first == nullptr) first = &job;
    auto& shown = detail.jobs.emplace_back(Job{job, log_tail(run, job.files.log)});
    auto& command = shown.record.program.shell;
    command = command.empty() ? shell_text(job.program.argv)
                              : fmt::format("cd {} && {}", shell_text({folder_for_shell(run)}), command);
  }
  for (const auto& scene : run.scenes)
    if (std::any_of(detail.jobs.begin(), detail.jobs.end(),
                    [&](const Job& job) { return job.record.identity.scene == scene.name; }))
      detail.scenes.push_back(scene);
  add_commands(run, target, first, detail);
  return detail;
}

std::string target_json(const RunView& view, std::size_t index) {
  json::Writer out;
  json::write_record(out, target_detail(view, index));
  return out.text();
}

}  // namespace orbs::report
