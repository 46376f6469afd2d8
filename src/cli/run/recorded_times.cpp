#include "cli/run/recorded_times.h"

#include "base/duration.h"
#include "base/error.h"
#include "registry/image_size.h"
#include "results/record.h"
#include "run/plan/render_seconds.h"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

namespace orbs::cli {

namespace {

namespace fs = std::filesystem;

}  // namespace

std::vector<fs::path> results_files(const std::set<fs::path>& folders) {
  std::vector<std::pair<fs::file_time_type, fs::path>> runs;
  for (const auto& folder : folders) {
    std::error_code failed;
    for (auto entry = fs::directory_iterator(folder, failed); !failed && entry != fs::directory_iterator();
         entry.increment(failed)) {
      const auto file = entry->path() / "results.json";
      std::error_code missing;
      if (const auto time = fs::last_write_time(file, missing); !missing) runs.emplace_back(time, file);
    }
  }
  std::sort(runs.rbegin(), runs.rend());
  std::vector<fs::path> files;
  for (const auto& [time, file] : runs) files.push_back(file);
  return files;
}

namespace {

std::vector<results::RunRecord> read_runs(const std::vector<fs::path>& files) {
  std::vector<results::RunRecord> runs;
  for (const auto& file : files) {
    std::error_code ignored;
    if (!fs::exists(file, ignored)) continue;
    try {
      runs.push_back(results::read_results_file(file));
    } catch (const InputError&) {
      continue;  // it has no times that could be used, and this is no place to complain about it
    }
  }
  return runs;
}

// Of runs at the size of the plan, or of those at other sizes; returns how many are new.
std::size_t take_times(const results::RunRecord& run, const run::Plan& plan, RecordedTimes& times) {
  std::size_t added = 0;
  if (run.suite != plan.suite.name) return added;
  const double share =
      static_cast<double>(registry::size_divisor(run.size)) / static_cast<double>(plan.settings.size_divisor);
  for (const auto& job : run.jobs) {
    const auto& was = job.identity;
    if (!has_image(job) || was.spp <= 0 || was.suite != plan.suite.name) continue;
    for (const auto& planned : plan.jobs)
      if (plan.scenes[planned.scene].name == was.scene &&
          plan.renderers[planned.renderer].entry.name == was.renderer) {
        const bool as_needed = planned.first_spp > 0 && job.sampling.looks > 0;
        const double samples = as_needed ? 1 : static_cast<double>(planned.spp) / was.spp;
        added += times.seconds.emplace(planned.id, job.cost.wall_seconds * samples * share * share).second;
        if (share == 1 && job.program.threads >= plan.threads && job.cost.peak_rss_bytes > 0)
          times.peak_rss_bytes.emplace(planned.id, job.cost.peak_rss_bytes);
      }
  }
  return added;
}

void take_shipped_times(const run::Plan& plan, RecordedTimes& times) {
  const auto shipped = run::shipped_cpu_seconds(plan);
  for (std::size_t job = 0; job < shipped.size(); ++job) {
    if (!shipped[job]) continue;
    if (!times.seconds.emplace(plan.jobs[job].id, shipped[job]->cpu_seconds / plan.threads).second) continue;
    ++times.from_elsewhere;
    if (shipped[job]->is_rough) ++times.rough;
  }
}

// Their folders are in place. Whether one is outdated, the run finds out.
void take_finished(const run::Plan& plan, const fs::path& resumed, RecordedTimes& times) {
  for (const auto& job : plan.jobs) {
    try {
      if (results::read_job_file(resumed / job.folder / "job.json").job.identity.id == job.id)
        times.finished.insert(job.id);
    } catch (const InputError&) {
      continue;  // it is not there, or of no use
    }
  }
}

}  // namespace

RecordedTimes recorded_times(const run::Plan& plan,
                             const std::set<fs::path>& folders,
                             const std::vector<fs::path>& resumed) {
  RecordedTimes times;
  constexpr std::size_t kMost = 8;  // each takes some milliseconds to read
  auto files = results_files(folders);
  if (files.size() > kMost) files.resize(kMost);
  for (const auto& folder : resumed) files.insert(files.begin(), folder / "results.json");
  const auto runs = read_runs(files);
  const auto size = registry::size_text(plan.settings.size_divisor);
  for (const auto& run : runs)
    if (run.size == size) take_times(run, plan, times);
  for (const auto& run : runs)
    if (run.size != size) times.rough += take_times(run, plan, times);
  take_shipped_times(plan, times);
  for (const auto& folder : resumed) take_finished(plan, folder, times);
  return times;
}

std::string amount_text(const run::Plan& plan, const RecordedTimes& times) {
  const auto count = plan.jobs.size();
  if (count == 0) return "nothing to render: no target is declared that can be rendered";
  auto text = fmt::format("{} render{}", count, count == 1 ? "" : "s");
  const auto left = count - times.finished.size();
  if (left == 0) return text + ", all finished: nothing is left to render";
  if (left < count) text += fmt::format(", {} of them left", left);
  if (times.seconds.empty()) return text + "; no earlier run here says how long they take";
  double sum = 0;
  std::size_t known = 0;
  for (const auto& job : plan.jobs) {
    const auto time = times.seconds.find(job.id);
    if (time == times.seconds.end() || times.finished.contains(job.id)) continue;
    sum += time->second;
    ++known;
  }
  text += fmt::format(", about {}", duration_text(sum / plan.settings.jobs));
  if (times.rough > 0) text += ", roughly: by other sizes or scenes";
  if (times.from_elsewhere > 0)
    text += times.from_elsewhere == times.seconds.size() ? ", as another machine took"
                                                         : ", in part by the times of another machine";
  if (known < left) text += fmt::format(" for {} of them, the others have no recorded time", known);
  return text;
}

}  // namespace orbs::cli
