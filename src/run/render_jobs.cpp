#include "run/render_jobs.h"

#include "base/files.h"
#include "base/parallel.h"
#include "run/looks.h"
#include "run/plan/job_groups.h"
#include "run/render_looks.h"
#include "run/render_session.h"
#include "run/resume.h"

#include <algorithm>
#include <chrono>
#include <numeric>
#include <utility>

namespace orbs::run {

namespace {

using results::JobOutcome;
using results::JobRecord;

// Everything that the render depends on is hashed before the first render starts. A file that is replaced
// later then differs from its hash, and --resume notices.
std::vector<JobRecord> records_at_start(const RenderSession& session,
                                        const std::vector<std::string>& versions) {
  std::vector<JobRecord> records;
  const auto& plan = session.plan;
  for (std::size_t index = 0; index < plan.jobs.size(); ++index) {
    const auto& job = plan.jobs[index];
    auto& record = records.emplace_back(skipped_record(plan, job));
    record.program.version = versions[job.renderer];
    record.hashes = {scene_hash(plan, job),
                     session.programs.hash(job.renderer),
                     "",
                     settings_hash(plan, job),
                     limits_hash(plan, job),
                     judged_hash(plan, index, session.folders.references, session.context.orbs_version),
                     ""};
  }
  return records;
}

// A job with fixed samples.
JudgedJob run_or_keep(RenderSession& session, std::size_t index) {
  const auto& now = session.at_start[index];
  auto earlier = resumption_of(session.plan, index, now, session.folders);
  if (earlier.step == Step::Keep) {
    JudgedJob kept{std::move(earlier.found->job), std::move(earlier.found->targets), {}};
    count_done(session, kept, false);
    return kept;
  }
  if (is_stopped(session)) return skipped_job(session, index, now);
  if (!earlier.reason.empty()) say(session, now, earlier.reason);
  const auto& job = session.plan.jobs[index];
  auto execution =
      earlier.step == Step::Judge ? take_over(earlier.found->job, job.folder, session.folders) : std::nullopt;
  if (!execution) execution = render_job(session, index, job);
  if (execution->record.end.outcome == JobOutcome::Skipped)
    return skipped_job(session, index, execution->record);
  auto judged = judge_job(session, index, std::move(*execution));
  place_job(session, index, judged);
  count_done(session, judged, true);
  return judged;
}

// In the order of the plan, which shows something of each requirement early. With several jobs at a time the
// longest ones start first, or the last of them would run alone while the other cores wait.
std::vector<JobGroup> groups_in_order(const Plan& plan) {
  const auto group_of = group_of_jobs(plan);
  std::vector<JobGroup> groups(plan.jobs.size());
  const auto is_in_looks = [&](std::size_t job) { return plan.jobs[job].first_spp > 0; };
  for (std::size_t job = 0; job < plan.jobs.size(); ++job)
    groups[is_in_looks(job) ? group_of[job] : job].jobs.push_back(job);
  for (std::size_t target = 0; target < plan.targets.size(); ++target)
    if (const auto& jobs = plan.targets[target].jobs; jobs.size() > 1 && is_in_looks(jobs.front()))
      groups[group_of[jobs.front()]].differences.push_back(target);
  std::erase_if(groups, [](const JobGroup& group) { return group.jobs.empty(); });
  if (plan.settings.jobs == 1) return groups;
  const auto seconds_of = [&](const JobGroup& group) {
    double seconds = 0;
    for (const auto job : group.jobs) seconds = std::max(seconds, plan.jobs[job].cpu_seconds);
    return seconds;
  };
  std::stable_sort(groups.begin(), groups.end(),
                   [&](const auto& a, const auto& b) { return seconds_of(a) > seconds_of(b); });
  return groups;
}

// Hands out what is to be done next: first looks in their order, then the look at what is decided soonest.
// Each group has one thread at a time.
class Queue {
 public:
  explicit Queue(std::vector<JobGroup>& groups) : groups_(groups), is_taken_(groups.size(), false) {}

  JobGroup* next() {
    const std::lock_guard lock(mutex_);
    std::size_t best = groups_.size();
    for (std::size_t i = 0; i < groups_.size(); ++i) {
      if (groups_[i].is_done || is_taken_[i]) continue;
      if (best == groups_.size() || is_before(groups_[i], groups_[best])) best = i;
    }
    if (best == groups_.size()) return nullptr;
    is_taken_[best] = true;
    return &groups_[best];
  }
  void give_back(const JobGroup* group) {
    const std::lock_guard lock(mutex_);
    is_taken_[static_cast<std::size_t>(group - groups_.data())] = false;
  }

 private:
  static bool is_before(const JobGroup& a, const JobGroup& b) {
    if (a.is_begun != b.is_begun) return !a.is_begun;
    return a.is_begun && a.seconds_to_decide < b.seconds_to_decide;
  }

  std::vector<JobGroup>& groups_;
  std::vector<bool> is_taken_;  // by a thread
  std::mutex mutex_;
};

class Clock {
 public:
  explicit Clock(double budget_seconds) : budget_seconds_(budget_seconds) {}

  bool is_over() const {
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin_;
    return budget_seconds_ > 0 && passed.count() > budget_seconds_;
  }

 private:
  double budget_seconds_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

void step(RenderSession& session, const Clock& clock, JobGroup& group, std::vector<JudgedJob>& results) {
  if (session.plan.jobs[group.jobs.front()].first_spp > 0) {
    if (group.is_begun && clock.is_over())
      end_by_run_budget(session, group, results);
    else
      take_look(session, group, results);
    return;
  }
  for (const auto job : group.jobs) results[job] = run_or_keep(session, job);
  group.is_done = true;
}

}  // namespace

RenderedJobs render_jobs(const Plan& plan,
                         const std::vector<std::string>& versions,
                         const WorkFolders& folders,
                         const RenderContext& context,
                         ProgramWatch& programs) {
  RenderSession session{plan, folders, context, programs};
  session.at_start = records_at_start(session, versions);
  auto groups = groups_in_order(plan);
  RenderedJobs rendered;
  rendered.jobs.resize(plan.jobs.size());
  Queue queue(groups);
  const Clock clock(plan.settings.budget_seconds);
  const int workers = std::max(1, plan.settings.jobs);
  for_each_index(workers, workers, [&](int) {
    while (auto* group = queue.next()) {
      step(session, clock, *group, rendered.jobs);
      queue.give_back(group);
    }
  });
  for (auto& group : groups)
    for (auto& [target, judged] : group.judged_differences)
      rendered.differences.emplace(target, std::move(judged.record));
  return rendered;
}

}  // namespace orbs::run
