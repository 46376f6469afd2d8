#include "history/pair_runs.h"

#include "base/error.h"

#include <map>
#include <tuple>
#include <utility>

#include <fmt/format.h>

namespace orbs::history {

namespace {

using results::JobRecord;
using results::JobsById;
using results::RunRecord;
using results::TargetRecord;

/// One of the two runs.
struct Side {
  explicit Side(const RunRecord& the_run) : run(&the_run), jobs(jobs_by_id(the_run)) {}
  const RunRecord* run;
  JobsById jobs;
};

std::string samples_of(const TargetRecord& target, const JobsById& jobs) {
  std::string text;
  for (const auto& id : target.jobs)
    if (const auto job = jobs.find(id); job != jobs.end())
      text += fmt::format("{}{}", text.empty() ? "" : " and ", job->second->identity.spp);
  return text;
}

bool is_reached(const TargetRecord& target) { return target.verdict != results::Verdict::Skipped; }

std::string why_not_reached(const RunRecord& run) {
  return run.finished ? "the run was interrupted" : "the run is going on, or was killed";
}

// "" if both were rendered.
std::string why_not_rendered(const TargetPair& pair, const Side& before, const Side& after) {
  if (!is_reached(*pair.after)) return why_not_reached(*after.run);
  if (!is_reached(*pair.before))
    return fmt::format("in {}: {}", before.run->name, why_not_reached(*before.run));
  return "";
}

// What has no image has no reference to be compared; its verdict says why.
std::string why_no_numbers(const TargetPair& pair) {
  if (!has_numbers(*pair.before) || !has_numbers(*pair.after)) return "";
  if (pair.before->reference_provenance != pair.after->reference_provenance)
    return "the reference is another one";
  return "";
}

TargetPair pair_of(const TargetRecord& of_before,
                   const TargetRecord& of_after,
                   const Side& before,
                   const Side& after) {
  TargetPair pair{&of_before, &of_after};
  pair.not_rendered = why_not_rendered(pair, before, after);
  pair.not_compared = why_no_numbers(pair);
  pair.has_other_samples = samples_of(of_before, before.jobs) != samples_of(of_after, after.jobs);
  return pair;
}

std::string why_no_times(const JobRecord& before, const JobRecord& after) {
  const auto machine = results::timing_machine(before.cost.host);
  if (machine.empty() || machine != results::timing_machine(after.cost.host))
    return "another kind of machine";
  if (before.identity.spp != after.identity.spp || before.identity.seeds != after.identity.seeds)
    return "other numbers of samples";
  if (before.program.threads != after.program.threads)
    return fmt::format("{} threads before, {} now", before.program.threads, after.program.threads);
  return "";
}

std::string name_of(const TargetRecord& target) { return target.renderer + " " + target.target; }

std::string name_with_failure(const TargetRecord& target) {
  if (!counts_as_failure(target.verdict, target.expectation)) return name_of(target);
  return fmt::format("{} ({})", name_of(target), state_name(target));
}

}  // namespace

RunPair pair_runs(const RunRecord& before, const RunRecord& after) {
  if (before.suite != after.suite || before.size != after.size)
    throw InputError(
        fmt::format("{} is of suite {} at size {}, {} of suite {} at size {}: compare runs of the same",
                    before.folder, before.suite, before.size, after.folder, after.suite, after.size));
  using Key = std::tuple<std::string, std::string, std::string>;
  std::map<Key, const TargetRecord*> earlier;
  for (const auto& target : before.targets)
    earlier[{target.case_name, target.target, target.renderer}] = &target;
  const Side side_before(before);
  const Side side_after(after);
  RunPair pair;
  for (const auto& target : after.targets) {
    const auto found = earlier.find({target.case_name, target.target, target.renderer});
    if (found == earlier.end()) {
      pair.only_after.push_back(name_with_failure(target));
      continue;
    }
    pair.targets.push_back(pair_of(*found->second, target, side_before, side_after));
    earlier.erase(found);
  }
  for (const auto& [key, target] : earlier) pair.only_before.push_back(name_of(*target));
  if (pair.targets.empty())
    throw InputError(fmt::format("{} and {} have no target in common", before.folder, after.folder));
  std::map<std::pair<std::string, std::string>, const JobRecord*> renders;
  for (const auto& job : before.jobs)
    if (has_image(job)) renders[{job.identity.renderer, job.identity.scene}] = &job;
  for (const auto& job : after.jobs)
    if (const auto found = renders.find({job.identity.renderer, job.identity.scene});
        has_image(job) && found != renders.end())
      pair.jobs.push_back({found->second, &job, why_no_times(*found->second, job)});
  return pair;
}

RunPair pair_renderers(const RunRecord& run, const std::string& before, const std::string& after) {
  std::map<std::pair<std::string, std::string>, const TargetRecord*> first;
  for (const auto& target : run.targets)
    if (target.renderer == before) first[{target.case_name, target.target}] = &target;
  const Side side(run);
  RunPair pair;
  for (const auto& target : run.targets)
    if (const auto found = first.find({target.case_name, target.target});
        target.renderer == after && found != first.end())
      pair.targets.push_back(pair_of(*found->second, target, side, side));
  return pair;
}

}  // namespace orbs::history
