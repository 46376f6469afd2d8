#include "run/cluster/merge_runs.h"

#include "base/error.h"
#include "base/files.h"
#include "base/files_inside.h"
#include "results/record.h"
#include "results/run_folder.h"
#include "run/judge_targets.h"
#include "run/plan/plan_file.h"
#include "run/renderer_version.h"
#include "run/run_file.h"
#include "run/summary.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::run {

namespace {

namespace fs = std::filesystem;
using results::JobRecord;
using results::RunRecord;
using results::TargetRecord;

/// Where a job or a target was found.
template <typename Record>
struct Found {
  std::size_t shard;
  const Record* record;
};

using Jobs = std::map<std::string, Found<JobRecord>>;
using TargetKey = std::tuple<std::string, std::string, std::string>;  // case, target, renderer
using Targets = std::map<TargetKey, Found<TargetRecord>>;

TargetKey key_of(const FiledTarget& target) { return {target.case_name, target.target, target.renderer}; }

// At most so many lines of each kind of complaint; a node that is lost misses hundreds of jobs.
std::string complaint(const std::string& head, const std::vector<std::string>& lines) {
  constexpr std::size_t kMost = 20;
  if (lines.empty()) return "";
  auto text = fmt::format("{} ({}):", head, lines.size());
  for (std::size_t i = 0; i < std::min(lines.size(), kMost); ++i) text += fmt::format("\n  {}", lines[i]);
  if (lines.size() > kMost) text += fmt::format("\n  and {} more", lines.size() - kMost);
  return text + "\n";
}

void compare_programs(const std::vector<RunRecord>& runs, std::vector<std::string>& contradictions) {
  const auto& first = runs.front();
  std::map<std::string, std::string> versions;
  for (const auto& renderer : first.renderers) versions[renderer.name] = renderer.version;
  for (const auto& run : runs) {
    if (run.plan != first.plan)
      contradictions.push_back(
          fmt::format("{} is of another plan than {}: other scenes, cases, renderers or settings", run.folder,
                      first.folder));
    if (run.orbs_version != first.orbs_version)
      contradictions.push_back(fmt::format("{} was made by orbs {}, {} by orbs {}", run.folder,
                                           run.orbs_version, first.folder, first.orbs_version));
    for (const auto& renderer : run.renderers)
      if (const auto known = versions.find(renderer.name);
          known != versions.end() && is_other_version(known->second, renderer.version))
        contradictions.push_back(fmt::format("{} has {} '{}', {} has '{}'", run.folder, renderer.name,
                                             renderer.version, first.folder, known->second));
  }
}

Jobs find_jobs(const std::vector<RunRecord>& runs, std::vector<std::string>& contradictions) {
  Jobs jobs;
  for (std::size_t shard = 0; shard < runs.size(); ++shard)
    for (const auto& job : runs[shard].jobs) {
      if (job.end.outcome == results::JobOutcome::Skipped) continue;
      const auto [known, is_new] = jobs.try_emplace(job.identity.id, Found<JobRecord>{shard, &job});
      if (!is_new && known->second.record->hashes.files != job.hashes.files)
        contradictions.push_back(fmt::format("{} {}: {} and {} have different files of this render",
                                             job.identity.renderer, job.identity.scene,
                                             runs[known->second.shard].folder, runs[shard].folder));
    }
  return jobs;
}

// The first shard that has judged a target counts: renders of other shards have the same files, or the shards
// contradict each other.
Targets find_targets(const std::vector<RunRecord>& runs) {
  Targets targets;
  for (std::size_t shard = 0; shard < runs.size(); ++shard)
    for (const auto& target : runs[shard].targets)
      if (target.verdict != results::Verdict::Skipped)
        targets.try_emplace({target.case_name, target.target, target.renderer},
                            Found<TargetRecord>{shard, &target});
  return targets;
}

// Renders that no shard has; and targets that no shard has judged, although none of their renders is missing.
std::vector<std::string> missing_parts(const FiledPlan& plan, const Jobs& jobs, const Targets& targets) {
  std::vector<std::string> missing;
  std::set<std::string> missing_jobs;
  for (const auto& job : plan.jobs)
    if (!jobs.contains(job.id)) {
      missing.push_back(fmt::format("{} {}: not rendered (job {})", job.renderer, job.scene, job.id));
      missing_jobs.insert(job.id);
    }
  for (const auto& target : plan.targets)
    if (!targets.contains(key_of(target)) &&
        std::none_of(target.jobs.begin(), target.jobs.end(),
                     [&](const auto& id) { return missing_jobs.contains(id); }))
      missing.push_back(
          fmt::format("{} {} of {}: not judged", target.renderer, target.target, target.case_name));
  return missing;
}

// Why the run has no such folder of its own; "" if it has. What another machine has sent may hold a symbolic
// link to any folder of this one.
std::string folder_problem(const fs::path& run, const fs::path& relative) {
  std::error_code failed;
  const auto found = fs::canonical(run / relative, failed);
  if (failed) return fmt::format("{}: {}", (run / relative).string(), failed.message());
  if (found.lexically_relative(fs::canonical(run, failed)) == relative.lexically_normal()) return "";
  return fmt::format("{}: leads to {}, expected a folder of the run", (run / relative).string(),
                     found.string());
}

// Why the run has not the image that was judged, by its hash unless that is ""; "" if it has.
std::string image_problem(const fs::path& run, const std::string& relative, const std::string& hash) {
  const auto file = open_inside(run, relative);
  if (!file) return fmt::format("{}: there is no such file", (run / relative).string());
  if (hash.empty()) return "";
  const auto now = hash_text(content_hash(file->read(0, static_cast<std::size_t>(file->size()))));
  if (now == hash) return "";
  return fmt::format("{}: is not the image that was judged: its hash is now {}, it was {}",
                     (run / relative).string(), now, hash);
}

// What was lost or damaged on the way from the machine that made it.
std::vector<std::string> damaged_files(const std::vector<RunRecord>& runs,
                                       const Jobs& jobs,
                                       const Targets& targets) {
  std::vector<std::string> damaged;
  const auto note = [&](std::string problem) {
    if (!problem.empty()) damaged.push_back(std::move(problem));
  };
  for (const auto& run : runs) {
    std::error_code ignored;
    if (fs::exists(fs::path(run.folder) / kReferenceFolder, ignored))
      note(folder_problem(run.folder, kReferenceFolder));
  }
  for (const auto& [id, found] : jobs) {
    const auto& files = found.record->files;
    const auto& run = runs[found.shard].folder;
    auto problem = folder_problem(run, files.folder);
    if (problem.empty() && !files.image.empty())
      problem = image_problem(run, files.image, found.record->hashes.image);
    note(std::move(problem));
  }
  for (const auto& [key, found] : targets)
    if (found.record->jobs.size() >= 2 && !found.record->image.empty())
      note(image_problem(runs[found.shard].folder, found.record->image, ""));
  return damaged;
}

// Hard links where the disk allows them: the images of a cluster's run are many gigabytes.
void take_folder(const fs::path& from, const fs::path& to) {
  make_folder(to);
  std::error_code failed;
  for (auto entry = fs::recursive_directory_iterator(from, failed);
       !failed && entry != fs::recursive_directory_iterator(); entry.increment(failed)) {
    const auto target = to / entry->path().lexically_relative(from);
    const auto type = entry->symlink_status().type();
    if (type == fs::file_type::directory) make_folder(target);
    if (type != fs::file_type::regular) continue;
    std::error_code no_link;
    fs::create_hard_link(entry->path(), target, no_link);
    if (no_link) fs::copy_file(entry->path(), target, fs::copy_options::overwrite_existing, failed);
    if (failed) break;
  }
  if (failed)
    throw WriteError(
        fmt::format("{}: cannot be copied to {}: {}", from.string(), to.string(), failed.message()));
}

void compare_references(const std::vector<RunRecord>& runs, std::vector<std::string>& contradictions) {
  std::map<std::string, std::pair<std::uint64_t, const RunRecord*>> known;
  std::error_code ignored;
  for (const auto& run : runs)
    for (const auto& entry : fs::directory_iterator(fs::path(run.folder) / kReferenceFolder, ignored)) {
      const auto name = entry.path().filename().string();
      const auto hash = content_hash(read_file(entry.path()));
      const auto [found, is_new] = known.try_emplace(name, hash, &run);
      if (!is_new && found->second.first != hash)
        contradictions.push_back(fmt::format("{} and {} have different references {}", run.folder,
                                             found->second.second->folder, name));
    }
}

template <typename Item, typename NameOf>
void take_in_order(const std::vector<std::string>& names,
                   const std::vector<RunRecord>& runs,
                   std::vector<Item> RunRecord::*items,
                   NameOf&& name_of,
                   RunRecord& merged) {
  std::map<std::string, const Item*> known;
  for (const auto& run : runs)
    for (const auto& item : run.*items) known.try_emplace(name_of(item), &item);
  (merged.*items).clear();
  for (const auto& name : names)
    if (const auto found = known.find(name); found != known.end()) {
      (merged.*items).push_back(*found->second);
      known.erase(found);
    }
}

RunRecord merged_record(const FiledPlan& plan,
                        const std::vector<RunRecord>& runs,
                        const Jobs& jobs,
                        const Targets& targets,
                        const fs::path& folder) {
  RunRecord merged = runs.front();
  merged.shard = "1/1";
  merged.folder = folder.string();
  merged.name = folder.filename().string();
  merged.interrupted = false;
  merged.finished = true;
  for (const auto& run : runs) {
    merged.started = std::min(merged.started, run.started);
    merged.wall_seconds = std::max(merged.wall_seconds, run.wall_seconds);
  }
  merged.jobs.clear();
  for (const auto& job : plan.jobs) merged.jobs.push_back(*jobs.at(job.id).record);
  merged.targets.clear();
  for (const auto& listed : plan.targets) merged.targets.push_back(*targets.at(key_of(listed)).record);
  std::vector<std::string> cases;
  std::vector<std::string> scenes;  // and differences of them, which no run has as scenes
  for (const auto& one_case : plan.cases) {
    cases.push_back(one_case.name);
    scenes.insert(scenes.end(), one_case.targets.begin(), one_case.targets.end());
  }
  take_in_order(
      scenes, runs, &RunRecord::scenes, [](const auto& one) { return one.name; }, merged);
  take_in_order(
      cases, runs, &RunRecord::cases, [](const auto& one) { return one.name; }, merged);
  summarise(merged);
  return merged;
}

void take_files(const RunRecord& merged,
                const std::vector<RunRecord>& runs,
                const Jobs& jobs,
                const Targets& targets) {
  const fs::path folder = merged.folder;
  for (const auto& run : runs) {
    const auto references = fs::path(run.folder) / kReferenceFolder;
    std::error_code ignored;
    if (fs::exists(references, ignored)) take_folder(references, folder / kReferenceFolder);
  }
  for (const auto& [id, found] : jobs) {
    const auto& [shard, job] = found;
    const auto from = fs::path(runs[shard].folder) / job->files.folder;
    take_folder(from, folder / job->files.folder);
  }
  for (const auto& [key, found] : targets) {
    const auto& [shard, target] = found;
    if (target->jobs.size() < 2 || target->image.empty()) continue;
    const auto relative = fs::path(target->image).parent_path();
    take_folder(fs::path(runs[shard].folder) / relative, folder / relative);
  }
}

}  // namespace

RunRecord merge_runs(const std::vector<fs::path>& shards,
                     const fs::path& merged,
                     const std::vector<std::string>& command_line) {
  std::vector<RunRecord> runs;
  for (const auto& shard : shards) {
    runs.push_back(results::read_run_folder(fs::absolute(shard).lexically_normal()).run);
    if (runs.back().plan.empty())
      throw InputError(fmt::format("{}: was made by a version of orbs that knew no shards", shard.string()));
  }
  std::vector<std::string> contradictions;
  compare_programs(runs, contradictions);
  const auto plan = read_plan(fs::path(runs.front().folder) / kPlanFile);
  const auto jobs = find_jobs(runs, contradictions);
  const auto targets = find_targets(runs);
  compare_references(runs, contradictions);
  const auto missing = missing_parts(plan, jobs, targets);
  const auto damaged = damaged_files(runs, jobs, targets);
  if (!contradictions.empty() || !missing.empty() || !damaged.empty())
    throw InputError(
        complaint("the runs contradict each other", contradictions) + complaint("the runs lack", missing) +
        complaint("files are damaged", damaged) +
        (missing.empty() && damaged.empty() ? "" : "orbs run --resume FOLDER completes a shard"));
  const auto folder = make_run_folder(merged.string());
  const results::RunLock lock(folder);
  auto record = merged_record(plan, runs, jobs, targets, folder);
  record.command_line = command_line;
  take_files(record, runs, jobs, targets);
  write_plan(plan, folder);
  write_run_file({record.started, {}, record.label}, folder);
  write_file(folder / "results.json", results::run_json(record));
  return record;
}

}  // namespace orbs::run
