#include "base/files.h"
#include "fuzz/feed.h"
#include "history/comparison_text.h"
#include "history/history_text.h"
#include "history/steps.h"
#include "json/document.h"
#include "report/files.h"
#include "report/overview.h"
#include "report/target_data.h"
#include "results/effect_costs.h"
#include "results/image_hashes.h"
#include "results/qualification.h"
#include "results/record.h"
#include "results/study_kinds.h"
#include "run/plan/plan_file.h"

#include <array>
#include <functional>

namespace orbs::fuzz {

namespace {

using results::RunRecord;

// What is written of a record reads back as the same.
void check_round_trip(const RunRecord& run, const std::filesystem::path& folder) {
  const auto text = results::run_json(run);
  write_file(folder / "again.json", text);
  require(results::run_json(results::read_results_file(folder / "again.json")) == text,
          "a record reads back as it was written");
}

// Whatever stands in a record, reports of it are files of their formats.
void check_reports(const RunRecord& run) {
  results::RunView view{run, {}, false};
  view.states.assign(run.jobs.size(), results::JobState::Done);
  json::parse("overview", report::overview_json(view));
  for (std::size_t i = 0; i < run.targets.size(); ++i) json::parse("target", report::target_json(view, i));
  report::results_csv(run);
  report::junit_xml(run);
  results::exit_status(run);
}

void check_history(const RunRecord& run) {
  const auto history = history::make_history({run, run, run, run, run, run});
  history::history_markdown(history, history::find_steps(history));
  try {
    json::parse("comparison", history::comparison_json(history::compare_runs(run, run)));
  } catch (const InputError&) {
    return;  // there is nothing to compare
  }
}

void feed_results(const std::filesystem::path& file) {
  const auto run = results::read_results_file(file);
  check_round_trip(run, file.parent_path());
  check_reports(run);
  check_history(run);
}

void feed_job(const std::filesystem::path& file) {
  const auto read = results::read_job_file(file);
  const auto text = results::job_json(read.job, read.targets);
  write_file(file.parent_path() / "again.json", text);
  const auto again = results::read_job_file(file.parent_path() / "again.json");
  require(results::job_json(again.job, again.targets) == text, "a render reads back as it was written");
}

void feed_plan(const std::filesystem::path& file) {
  const auto plan = run::read_plan(file);
  const auto folder = file.parent_path() / "again";
  make_folder(folder);
  run::write_plan(plan, folder);
  const auto text = read_file(folder / run::kPlanFile);
  run::write_plan(run::read_plan(folder / run::kPlanFile), folder);
  require(read_file(folder / run::kPlanFile) == text, "a plan reads back as it was written");
}

// The folder of a study holds the file of one kind.
void feed_study(const std::filesystem::path& file) {
  for (const auto& kind : results::kStudyKinds)
    if (kind.file != file.filename()) std::filesystem::remove(file.parent_path() / kind.file);
  results::read_study_folder(file.parent_path());
}

struct Kind {
  const char* file;
  std::function<void(const std::filesystem::path& file)> feed;
};

const std::array<Kind, 8>& kinds() {
  static const std::array<Kind, 8> kKinds{
      {{"results.json", feed_results},
       {"job.json", feed_job},
       {run::kPlanFile, feed_plan},
       {results::kCost.file.data(), feed_study},
       {results::kStability.file.data(), feed_study},
       {results::kImageHashesFile, [](const auto& file) { results::read_image_hashes(file.parent_path()); }},
       {results::kEffectCostsFile, [](const auto& file) { results::read_effect_costs(file); }},
       {"qualification.json", [](const auto& file) {
          for (const auto& gate : results::read_qualification(file)) results::is_qualified(gate);
        }}}};
  return kKinds;
}

}  // namespace

// The first byte, modulo their number, says which file of a run, a study or a suite the rest is.
std::string feed_record(std::string_view bytes) {
  static const ScratchFolder folder("orbs-feed-record");
  if (bytes.empty()) return "";
  const auto& kind = kinds().at(static_cast<unsigned char>(bytes.front()) % kinds().size());
  const auto file = folder.path() / kind.file;
  write_file(file, bytes.substr(1));
  return complaint_of(file.string(), [&] { kind.feed(file); });
}

}  // namespace orbs::fuzz
