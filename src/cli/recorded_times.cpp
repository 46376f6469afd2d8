#include "cli/recorded_times.h"

#include "base/error.h"
#include "registry/image_size.h"
#include "results/run_folder.h"
#include "run/plan/render_seconds.h"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

namespace orbs::cli {

namespace {

namespace fs = std::filesystem;

// The newest first: their names hold the date and time.
std::vector<fs::path> earlier_runs(const fs::path& folder, const std::vector<fs::path>& resumed) {
  constexpr std::size_t kMost = 8;  // each takes some milliseconds to read
  std::vector<fs::path> runs;
  std::error_code failed;
  for (auto entry = fs::directory_iterator(folder, failed); !failed && entry != fs::directory_iterator();
       entry.increment(failed))
    if (entry->path().filename().string().starts_with("outputs-")) runs.push_back(entry->path());
  std::sort(runs.rbegin(), runs.rend());
  if (runs.size() > kMost) runs.resize(kMost);
  runs.insert(runs.begin(), resumed.begin(), resumed.end());
  return runs;
}

void take_times(const results::RunRecord& run, const run::Plan& plan, RecordedTimes& times) {
  for (const auto& job : run.jobs) {
    const auto& was = job.identity;
    if (run.size != registry::size_text(plan.settings.size_divisor)) return;
    if (!has_image(job) || was.spp <= 0 || was.suite != plan.suite.name) continue;
    for (const auto& planned : plan.jobs)
      if (plan.scenes[planned.scene].name == was.scene &&
          plan.renderers[planned.renderer].entry.name == was.renderer) {
        times.seconds.emplace(planned.id, job.cost.wall_seconds * planned.spp / was.spp);
        if (job.program.threads >= plan.threads && job.cost.peak_rss_bytes > 0)
          times.peak_rss_bytes.emplace(planned.id, job.cost.peak_rss_bytes);
      }
  }
}

void take_shipped_times(const run::Plan& plan, RecordedTimes& times) {
  const auto shipped = run::shipped_cpu_seconds(plan);
  for (std::size_t job = 0; job < shipped.size(); ++job)
    if (shipped[job] && times.seconds.emplace(plan.jobs[job].id, *shipped[job] / plan.threads).second)
      ++times.from_elsewhere;
}

}  // namespace

RecordedTimes recorded_times(const run::Plan& plan,
                             const fs::path& folder,
                             const std::vector<fs::path>& resumed) {
  RecordedTimes times;
  for (const auto& run : earlier_runs(folder, resumed)) {
    if (times.peak_rss_bytes.size() == plan.jobs.size()) break;
    std::error_code ignored;
    if (!fs::exists(run / "results.json", ignored)) continue;
    try {
      take_times(results::read_run_folder(run).run, plan, times);
    } catch (const InputError&) {
      continue;  // it has no times that could be used, and this is no place to complain about it
    }
  }
  take_shipped_times(plan, times);
  return times;
}

std::string duration_text(double seconds) {
  constexpr double kMinute = 60;
  constexpr double kHour = 3600;
  if (seconds < 1.5 * kMinute) return fmt::format("{:.0f} s", std::max(seconds, 1.0));
  if (seconds < 1.5 * kHour) return fmt::format("{:.0f} min", seconds / kMinute);
  return fmt::format("{:.1f} h", seconds / kHour);
}

std::string amount_text(const run::Plan& plan, const RecordedTimes& times) {
  const auto count = plan.jobs.size();
  auto text = fmt::format("{} render{}", count, count == 1 ? "" : "s");
  double sum = 0;
  for (const auto& [id, time] : times.seconds) sum += time;
  if (times.seconds.empty()) return text + "; no earlier run here says how long they take";
  text += fmt::format(", about {}", duration_text(sum / plan.settings.jobs));
  if (times.from_elsewhere > 0)
    text += times.from_elsewhere == times.seconds.size() ? ", as another machine took"
                                                         : ", in part by the times of another machine";
  if (times.seconds.size() < count)
    text += fmt::format(" for {} of them, the others have no recorded time", times.seconds.size());
  return text;
}

}  // namespace orbs::cli
