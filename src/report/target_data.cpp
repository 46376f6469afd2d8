#include "report/target_data.h"

#include "base/files_inside.h"
#include "base/shell.h"
#include "json/writer.h"
#include "results/field_writer.h"

#include <algorithm>
#include <cstdint>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::report {

namespace {

using json::Writer;
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

// The whole record of the render, and the end of its log.
void write_job(Writer& out, const JobRecord& job, const RunRecord& run) {
  auto shown = job;
  auto& command = shown.program.shell;
  command = command.empty() ? shell_text(job.program.argv)
                            : fmt::format("cd {} && {}", shell_text({run.folder}), command);
  out.begin_object();
  results::write_fields(out, shown);
  out.member("log", log_tail(run, job.files.log)).end_object();
}

Writer& write_image(Writer& out, std::string_view name, std::string_view kind, const std::string& file) {
  return out.begin_object().member("name", name).member("kind", kind).member("file", file);
}

void write_images(Writer& out, const TargetRecord& target) {
  out.key("images").begin_array();
  if (!target.image.empty()) write_image(out, "result", "result", target.image).end_object();
  if (!target.reference_image.empty())
    write_image(out, "reference", "reference", target.reference_image).end_object();
  for (const auto& map : target.maps)
    write_image(out, map.name, "map", map.image)
        .member("definition", map.definition)
        .member("signed", map.is_signed)
        .member("scale_maximum", map.scale_maximum)
        .end_object();
  out.end_array();
}

void write_measures(Writer& out, const TargetRecord& target) {
  out.key("measures").begin_array();
  for (const auto& measure : target.measures) results::write_record(out, measure);
  out.end_array().key("checks").begin_array();
  for (const auto& check : target.checks) results::write_record(out, check);
  out.end_array();
}

// The scenes of the renders that the image is made from.
void write_scenes(Writer& out, const RunRecord& run, const TargetRecord& target) {
  out.key("scenes").begin_array();
  for (const auto& scene : run.scenes)
    if (std::any_of(run.jobs.begin(), run.jobs.end(), [&](const JobRecord& job) {
          return job.identity.scene == scene.name &&
                 std::find(target.jobs.begin(), target.jobs.end(), job.identity.id) != target.jobs.end();
        }))
      results::write_record(out, scene);
  out.end_array();
}

// The command that renders and judges this target again, and no other.
std::vector<std::string> run_command(const RunRecord& run, const TargetRecord& target, const JobRecord* job) {
  std::vector<std::string> words{"orbs",           "run",     "--suite",     run.suite,    "--case",
                                 target.case_name, "--scene", target.target, "--renderer", target.renderer};
  if (job != nullptr) words.insert(words.end(), {"--seed", std::to_string(job->identity.seed)});
  // Only the command line records the scale of the samples.
  const auto given = std::find(run.command_line.begin(), run.command_line.end(), "--spp-scale");
  if (given != run.command_line.end() && given + 1 != run.command_line.end())
    words.insert(words.end(), {*given, given[1]});
  return words;
}

}  // namespace

std::string target_json(const RunView& view, std::size_t index) {
  const auto& target = view.run.targets.at(index);
  const JobRecord* first = nullptr;
  Writer out;
  out.begin_object().member("case", target.case_name).member("target", target.target);
  out.member("renderer", target.renderer).member("requirement", target.requirement);
  out.member("reason", reason_text(target)).member("reference", target.reference);
  out.member("remarks", target.remarks);
  out.member("diagnosis", target.diagnosis);
  out.member("hidden", target.hidden);
  write_measures(out, target);
  write_images(out, target);
  out.key("reference_provenance").begin_object();
  for (const auto& [name, text] : target.reference_provenance) out.member(name, text);
  out.end_object().key("jobs").begin_array();
  for (const auto& job : view.run.jobs) {
    if (std::find(target.jobs.begin(), target.jobs.end(), job.identity.id) == target.jobs.end()) continue;
    if (first == nullptr) first = &job;
    write_job(out, job, view.run);
  }
  out.end_array();
  write_scenes(out, view.run, target);
  out.member("command", shell_text(run_command(view.run, target, first)));
  return out.end_object().text();
}

}  // namespace orbs::report
