#include "run/render_looks.h"

#include "base/error.h"
#include "base/files.h"
#include "image/image_io.h"
#include "metrics/seeds.h"
#include "results/run_folder.h"
#include "run/condition.h"
#include "run/looks.h"
#include "run/resume.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include <fmt/format.h>

namespace orbs::run {

namespace {

using results::JobOutcome;
using results::JobRecord;
using results::Verdict;

// What was measured of an earlier look, added to by the next.
void add_cost(const results::JobCost& before, results::JobCost& cost) {
  cost.wall_seconds += before.wall_seconds;
  cost.cpu_seconds += before.cpu_seconds;
  if (before.render_seconds) cost.render_seconds = cost.render_seconds.value_or(0) + *before.render_seconds;
  cost.peak_rss_bytes = std::max(cost.peak_rss_bytes, before.peak_rss_bytes);
  if (!before.started.empty()) cost.started = before.started;
}

metrics::MergedRenders merged_before(const RenderSession& session, const JobRecord& before) {
  const auto& run = session.folders.run;
  return metrics::merged_renders_of(image::read_image(run / before.files.image),
                                    image::read_image(run / before.files.folder / kHalvesFile),
                                    2 * before.sampling.looks, before.identity.spp);
}

// Merges the two renders of a look with those before, and writes what the next look needs.
void merge_look(const RenderSession& session,
                const PlannedJob& job,
                const JobRecord& before,
                Execution& execution) {
  auto& record = execution.record;
  const int looks = before.sampling.looks;
  metrics::MergedRenders merged;
  if (looks > 0) merged = merged_before(session, before);
  auto apart = before.sampling.apart;
  const auto look = metrics::renders_apart(execution.renders[0], execution.renders[1], 2 * job.look->spp);
  apart.push_back({look.spp, look.means[0], look.means[1], look.means[2]});
  metrics::add_renders(merged, {std::move(execution.renders[0]), std::move(execution.renders[1])},
                       job.look->spp);
  record.identity.spp = merged.samples;
  record.sampling = {looks + 1, kMostLooks, "", std::move(apart)};
  const auto folder = session.folders.unfinished / job.folder;
  image::write_exr(merged.mean, folder / std::filesystem::path(record.files.image).filename());
  image::write_exr(metrics::halves_image(merged), folder / kHalvesFile);
  execution.image = merged.mean;
  execution.merged = std::move(merged);
}

// A renderer that ignores its seed, or a scene without noise: all samples at once.
bool are_equal_renders(const Execution& execution) {
  return execution.renders.size() == 2 && metrics::are_equal(execution.renders);
}

void keep_condition(const RenderSession& session,
                    const PlannedJob& job,
                    const JobRecord& before,
                    JobRecord& record) {
  record.condition = before.condition;
  if (before.condition.spp > 0)
    keep_condition_images(session.folders.run / job.folder, session.folders.unfinished / job.folder);
}

// Renders the next look of the job, up to `spp` samples in all. What it leaves without a usable image, or
// what cannot be merged, ends the job.
Execution rendered_look(RenderSession& session, std::size_t index, const JobRecord& before, int spp) {
  auto job = session.plan.jobs[index];
  const int looks = before.sampling.looks;
  job.look = next_look(session.plan, job, looks, looks == 0 ? 0 : before.identity.spp, spp);
  // What rounding decides is asked once.
  job.has_condition = job.has_condition && before.sampling.looks == 0;
  auto execution = render_job(session, index, job);
  if (before.sampling.looks > 0) keep_condition(session, job, before, execution.record);
  add_cost(before.cost, execution.record.cost);
  if (!has_image(execution.record)) return execution;
  if (are_equal_renders(execution)) {
    const auto first = execution.record;
    job.look.reset();
    job.has_condition = false;
    execution = render_job(session, index, job);
    execution.record.condition = first.condition;
    execution.record.sampling.has_equal_seeds = true;
    add_cost(first.cost, execution.record.cost);
    return execution;
  }
  try {
    merge_look(session, job, before, execution);
  } catch (const WriteError&) {
    throw;
  } catch (const InputError& e) {
    execution.record.end.outcome = JobOutcome::WrongChannels;
    execution.record.end.reason = e.what();
    execution.image.reset();
  }
  return execution;
}

// The path to the verdict goes on from that of the look before.
void continue_paths(const JudgedJob& before, JudgedJob& judged) {
  for (std::size_t i = 0; i < judged.targets.size(); ++i) {
    auto& target = judged.targets[i];
    if (i < before.targets.size()) target.looks = before.targets[i].looks;
    const int spp = judged.job.identity.spp;
    if (!target.looks.empty() && target.looks.back().spp == spp) target.looks.pop_back();
    if (judged.job.sampling.looks > 0)
      target.looks.push_back(look_record(judged.looks[i], target.verdict, spp));
  }
}

// First, since all that is said of noise and samples would mislead.
void say_equal_seeds(JudgedJob& judged) {
  if (!judged.job.sampling.has_equal_seeds) return;
  for (auto& target : judged.targets)
    if (!passes(target.verdict))
      target.reason =
          fmt::format("{}{}{}", metrics::kEqualSeeds, target.reason.empty() ? "" : "; ", target.reason);
}

JudgedJob judge_and_place(RenderSession& session,
                          std::size_t index,
                          const JudgedJob& before,
                          Execution execution) {
  auto judged = judge_job(session, index, std::move(execution));
  say_equal_seeds(judged);
  continue_paths(before, judged);
  place_job(session, index, judged);
  return judged;
}

JudgedJob look_at_job(RenderSession& session, std::size_t index, const JudgedJob& before, int spp) {
  auto execution = rendered_look(session, index, before.job, spp);
  if (execution.record.end.outcome == JobOutcome::Skipped) {
    // Interrupted: what the looks before have left stays.
    if (before.job.sampling.looks > 0) return before;
    return skipped_job(session, index, execution.record);
  }
  return judge_and_place(session, index, before, std::move(execution));
}

// What an earlier run has left: nothing, what is done, or looks that go on, judged by today's cases.
struct Earlier {
  bool is_found = false;
  bool is_done = false;
  JudgedJob judged{};
};

Earlier earlier_job(RenderSession& session, std::size_t index) {
  const auto& now = session.at_start[index];
  auto earlier = resumption_of(session.plan, index, now, session.folders);
  if (earlier.step == Step::Render) {
    if (!earlier.reason.empty()) say(session, now, earlier.reason);
    return {};
  }
  const auto& found = earlier.found->job;
  const bool goes_on =
      found.sampling.looks > 0 && has_image(found) &&
      (found.sampling.end.empty() || found.sampling.end == "budget" || found.sampling.end == "looks");
  JudgedJob kept{found, std::move(earlier.found->targets), {}};
  kept.looks.resize(kept.targets.size());
  if (earlier.step == Step::Keep && !goes_on) return {true, true, std::move(kept)};
  auto execution = take_over(found, session.plan.jobs[index].folder, session.folders);
  if (!execution) return {};
  try {
    if (found.sampling.looks > 0) execution->merged = merged_before(session, found);
  } catch (const InputError& e) {
    say(session, now, fmt::format("rendered again: {}", e.what()));
    return {};
  }
  execution->record.sampling.end = "";
  auto judged = judge_and_place(session, index, kept, std::move(*execution));
  return {true, found.sampling.looks == 0, std::move(judged)};
}

const JobRecord* record_of(const std::vector<JudgedJob>& results, std::size_t job) {
  return &results[job].job;
}

void judge_differences(const RenderSession& session, JobGroup& group, const std::vector<JudgedJob>& results) {
  for (const auto index : group.differences) {
    const auto& planned = session.plan.targets[index];
    const std::vector<const JobRecord*> jobs{record_of(results, planned.jobs.front()),
                                             record_of(results, planned.jobs.back())};
    if (std::any_of(jobs.begin(), jobs.end(),
                    [](const auto* job) { return job->end.outcome == JobOutcome::Skipped; }))
      continue;
    auto judged = judge_difference(session.plan, planned, jobs, session.folders);
    auto& kept = group.judged_differences[index];
    judged.record.looks = std::move(kept.record.looks);
    if (jobs.front()->sampling.looks > 0)
      judged.record.looks.push_back(
          look_record(judged.look, judged.record.verdict, jobs.front()->identity.spp));
    kept = std::move(judged);
  }
}

// Calls visit(record, look, the jobs of the target) for each target of the group.
template <typename Visit>
void for_each_target(const RenderSession& session,
                     JobGroup& group,
                     std::vector<JudgedJob>& results,
                     Visit visit) {
  for (const auto job : group.jobs)
    for (std::size_t i = 0; i < results[job].targets.size(); ++i)
      visit(results[job].targets[i], results[job].looks[i], std::vector<std::size_t>{job});
  for (auto& [index, judged] : group.judged_differences)
    visit(judged.record, judged.look, session.plan.targets[index].jobs);
}

// The jobs that some open target of the group needs more samples of, and what the target needs that needs
// most. All of them take the same step: the difference of two images loses their common noise only where both
// have the same samples.
struct OpenJobs {
  std::set<std::size_t> jobs;
  judge::Need need{0, 0};
};

OpenJobs open_jobs(const RenderSession& session, JobGroup& group, std::vector<JudgedJob>& results) {
  OpenJobs open;
  for_each_target(session, group, results, [&](const auto&, const judge::Look& look, const auto& jobs) {
    if (!look.is_open) return;
    for (const auto job : jobs) {
      if (results[job].job.sampling.looks == 0 || !has_image(results[job].job)) continue;
      open.jobs.insert(job);
      open.need.samples = std::max(open.need.samples, look.need.samples);
      open.need.at_best =
          std::max(open.need.at_best, std::isfinite(look.need.at_best) ? look.need.at_best : 2);
    }
  });
  return open;
}

// Writes why the group ends into its jobs and undecided targets, and tells of them.
template <typename EndOf>
void end_group(RenderSession& session, JobGroup& group, std::vector<JudgedJob>& results, EndOf end_of) {
  std::map<std::size_t, std::string> ends;
  for_each_target(session, group, results,
                  [&](results::TargetRecord& target, const judge::Look& look, const auto& jobs) {
                    const End end = end_of(look);
                    if (target.verdict == Verdict::Inconclusive && !end.text.empty())
                      target.reason = fmt::format("undecided: {}; {}", end.text, target.reason);
                    for (const auto job : jobs)
                      if (auto& name = ends[job]; name.empty() || name == "decided") name = end.name;
                  });
  for (const auto job : group.jobs) {
    auto& judged = results[job];
    const auto found = ends.find(job);
    if (judged.job.sampling.looks > 0)
      judged.job.sampling.end = found == ends.end() ? "decided" : found->second;
    write_job(session, session.folders.run / session.plan.jobs[job].folder, judged);
    count_done(session, judged, true);
  }
  group.is_done = true;
}

void begin(RenderSession& session, JobGroup& group, std::vector<JudgedJob>& results) {
  group.is_begun = true;
  bool is_all_done = true;
  for (const auto job : group.jobs) {
    auto earlier = earlier_job(session, job);
    is_all_done = is_all_done && earlier.is_done;
    if (earlier.is_found) {
      results[job] = std::move(earlier.judged);
    } else if (is_stopped(session)) {
      results[job] = skipped_job(session, job, session.at_start[job]);
    } else {
      results[job] =
          look_at_job(session, job, {session.at_start[job], {}, {}}, session.plan.jobs[job].first_spp);
    }
  }
  if (!is_all_done) return;
  for (const auto job : group.jobs) count_done(session, results[job], false);
  group.is_done = true;
}

// Jobs that had not begun when the run was stopped have left nothing.
bool is_cut(const JobGroup& group, const std::vector<JudgedJob>& results) {
  return std::any_of(group.jobs.begin(), group.jobs.end(),
                     [&](auto job) { return results[job].job.end.outcome == JobOutcome::Skipped; });
}

// What the group's renders have come to, with the time of the look that was taken last.
void sum_looks(JobGroup& group, const std::vector<JudgedJob>& results) {
  LookTime last{-group.seconds, -group.spp};
  group.seconds = 0;
  group.spp = 0;
  group.looks = 0;
  for (const auto job : group.jobs) {
    group.seconds += results[job].job.cost.wall_seconds;
    group.spp = std::max(group.spp, results[job].job.identity.spp);
    group.looks = std::max(group.looks, results[job].job.sampling.looks);
  }
  last.seconds += group.seconds;
  last.spp += group.spp;
  if (last.spp <= 0) return;
  if (last.spp > group.longer_look.spp) group.shorter_look = group.longer_look;
  group.longer_look = last;
}

// Without more samples than the job of the group that may have fewest.
LooksSoFar so_far_of(const RenderSession& session, const JobGroup& group) {
  int most = std::numeric_limits<int>::max();
  for (const auto job : group.jobs) most = std::min(most, most_spp(session.plan, session.plan.jobs[job]));
  return {group.looks,
          group.spp,
          most,
          group.seconds,
          pace_of(group.shorter_look, group.longer_look),
          session.plan.settings.target_budget_seconds};
}

// As the time that the user has set allows, else as the usual number of samples does.
int spp_after_next(const RenderSession& session,
                   std::size_t index,
                   const LooksSoFar& so_far,
                   int spp,
                   const judge::Need& need) {
  const auto& job = session.plan.jobs[index];
  int after = samples_after_next(session.plan, job, so_far.looks, spp, need);
  if (so_far.budget_seconds == 0) return std::min(after, std::max(2 * spp, so_far.most_spp));
  while (after > 2 * spp && so_far.seconds + seconds_for(so_far.pace, after - spp) > so_far.budget_seconds)
    after /= 2;
  return after;
}

void look_at_open_jobs(RenderSession& session, JobGroup& group, std::vector<JudgedJob>& results) {
  const auto so_far = so_far_of(session, group);
  const auto open = open_jobs(session, group, results);
  for (const auto index : open.jobs) {
    const int spp = spp_after_next(session, index, so_far, results[index].job.identity.spp, open.need);
    results[index] = look_at_job(session, index, results[index], spp);
  }
}

}  // namespace

void take_look(RenderSession& session, JobGroup& group, std::vector<JudgedJob>& results) {
  if (!group.is_begun) {
    begin(session, group, results);
    if (group.is_done) return;
  } else {
    look_at_open_jobs(session, group, results);
  }
  if (is_cut(group, results)) {
    group.is_done = true;
    return;
  }
  judge_differences(session, group, results);
  sum_looks(group, results);
  if (open_jobs(session, group, results).jobs.empty()) {
    end_group(session, group, results, [](const auto&) { return End{"decided", ""}; });
    return;
  }
  if (is_stopped(session)) {
    group.is_done = true;
    return;
  }
  const auto so_far = so_far_of(session, group);
  const auto end_of = [&](const judge::Look& look) { return end_after(look, so_far); };
  bool goes_on = false;
  group.seconds_to_decide = 0;
  for_each_target(session, group, results, [&](const auto&, const judge::Look& look, const auto&) {
    goes_on = goes_on || end_of(look).name.empty();
    if (look.is_open)
      group.seconds_to_decide = std::max(group.seconds_to_decide, seconds_to_decide(look, so_far));
  });
  if (!goes_on) end_group(session, group, results, end_of);
}

void end_by_run_budget(RenderSession& session, JobGroup& group, std::vector<JudgedJob>& results) {
  const auto so_far = so_far_of(session, group);
  end_group(session, group, results, [&](const judge::Look& look) {
    return look.is_open ? end_by_budget(look, so_far) : End{"decided", ""};
  });
}

}  // namespace orbs::run
