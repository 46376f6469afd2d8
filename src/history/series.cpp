#include "history/series.h"

#include "base/error.h"
#include "history/number_changes.h"
#include "history/time_changes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include <fmt/format.h>

namespace orbs::history {

namespace {

using results::JobsById;
using results::RunRecord;
using results::TargetRecord;

std::optional<double> psnr_of(const TargetRecord& target) {
  for (const auto& measure : target.measures)
    if (measure.name == "psnr_srgb8") return measure.value;
  return std::nullopt;
}

void add_renders(const TargetRecord& target, const JobsById& jobs, const std::string& machine, Point& point) {
  double seconds = 0;
  bool is_timed = !target.jobs.empty() && !machine.empty();
  for (const auto& id : target.jobs) {
    const auto found = jobs.find(id);
    if (found == jobs.end()) continue;
    const auto& job = *found->second;
    seconds += job.cost.cpu_seconds;
    is_timed = is_timed && has_image(job) && results::timing_machine(job.cost.host) == machine;
    point.version = job.program.version;
    point.made_by += fmt::format("{} {} {} {} ", job.hashes.program, job.hashes.scene, job.hashes.judged,
                                 job.identity.spp);
  }
  if (is_timed && seconds >= kLeastSeconds) point.cpu_seconds = seconds;
}

Point point_of(const TargetRecord& target,
               std::size_t run,
               const JobsById& jobs,
               const std::string& machine) {
  Point point;
  point.run = run;
  point.verdict = target.verdict;
  point.expectation = target.expectation;
  point.psnr_db = psnr_of(target);
  if (const auto mse = mean_squared_error(target)) point.mse = mse->value;
  for (std::size_t c = 0; c < point.light.size(); ++c)
    if (const auto light = mean_light(target, "rgb"[c])) point.light.at(c) = {light->value, light->error};
  add_renders(target, jobs, machine, point);
  return point;
}

void drop_others(std::vector<RunRecord>& runs, History& history) {
  const auto before = runs.size();
  std::erase_if(runs,
                [&](const RunRecord& run) { return run.suite != history.suite || run.size != history.size; });
  if (runs.size() < before)
    history.notes.push_back(
        fmt::format("{} runs of other suites or sizes are left out; the newest run is of {} at {}",
                    before - runs.size(), history.suite, history.size));
  const auto elsewhere = std::count_if(runs.begin(), runs.end(), [&](const RunRecord& run) {
    return results::timing_machine(run.host) != history.machine;
  });
  if (elsewhere > 0)
    history.notes.push_back(fmt::format(
        "times of {} runs are left out: they ran on another kind of machine than the newest", elsewhere));
}

}  // namespace

History make_history(std::vector<RunRecord> runs) {
  if (runs.empty()) throw InputError("there is no run; name the folders of runs");
  std::stable_sort(runs.begin(), runs.end(),
                   [](const RunRecord& a, const RunRecord& b) { return a.started < b.started; });
  History history;
  history.suite = runs.back().suite;
  history.size = runs.back().size;
  history.machine = results::timing_machine(runs.back().host);
  drop_others(runs, history);
  std::map<std::tuple<std::string, std::string, std::string>, std::size_t> index;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    history.runs.push_back(
        {runs[i].label.empty() ? runs[i].name : runs[i].label, runs[i].started, runs[i].orbs_version});
    const auto jobs = jobs_by_id(runs[i]);
    for (const auto& target : runs[i].targets) {
      if (target.verdict == results::Verdict::Skipped) continue;
      const auto [at, is_new] =
          index.try_emplace({target.renderer, target.case_name, target.target}, history.series.size());
      if (is_new)
        history.series.push_back({target.renderer,
                                  target.requirement,
                                  target.case_name,
                                  target.target,
                                  target.jobs.size() == 1,
                                  {}});
      history.series[at->second].points.push_back(point_of(target, i, jobs, history.machine));
    }
  }
  return history;
}

bool is_flaky(const Series& series) {
  std::map<std::string, std::set<results::Verdict>> verdicts;
  for (const auto& point : series.points)
    if (!point.made_by.empty()) verdicts[point.made_by].insert(point.verdict);
  return std::any_of(verdicts.begin(), verdicts.end(), [](const auto& one) { return one.second.size() > 1; });
}

}  // namespace orbs::history
