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

std::string samples_of(const TargetRecord& target, const JobsById& jobs) {
  std::string text;
  for (const auto& id : target.jobs)
    if (const auto job = jobs.find(id); job != jobs.end())
      text += fmt::format("{}{}", text.empty() ? "" : " and ", job->second->identity.spp);
  return text;
}

std::string why_no_numbers(const TargetRecord& before,
                           const TargetRecord& after,
                           const JobsById& jobs_before,
                           const JobsById& jobs_after) {
  const auto spp_before = samples_of(before, jobs_before);
  const auto spp_after = samples_of(after, jobs_after);
  if (spp_before != spp_after) return fmt::format("{} spp before, {} now", spp_before, spp_after);
  if (before.reference_provenance != after.reference_provenance) return "the reference is another one";
  return "";
}

std::string why_no_times(const JobRecord& before, const JobRecord& after) {
  const auto machine = results::timing_machine(before.cost.host);
  if (machine.empty() || machine != results::timing_machine(after.cost.host))
    return "another kind of machine";
  if (before.identity.spp != after.identity.spp || before.identity.seeds != after.identity.seeds)
    return fmt::format("{} spp before, {} now", before.identity.spp, after.identity.spp);
  if (before.program.threads != after.program.threads)
    return fmt::format("{} threads before, {} now", before.program.threads, after.program.threads);
  return "";
}

std::string name_of(const TargetRecord& target) { return target.renderer + " " + target.target; }

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
  const auto jobs_before = jobs_by_id(before);
  const auto jobs_after = jobs_by_id(after);
  RunPair pair;
  for (const auto& target : after.targets) {
    const auto found = earlier.find({target.case_name, target.target, target.renderer});
    if (found == earlier.end()) {
      pair.only_after.push_back(name_of(target));
      continue;
    }
    pair.targets.push_back(
        {found->second, &target, why_no_numbers(*found->second, target, jobs_before, jobs_after)});
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
  const auto jobs = jobs_by_id(run);
  RunPair pair;
  for (const auto& target : run.targets)
    if (const auto found = first.find({target.case_name, target.target});
        target.renderer == after && found != first.end())
      pair.targets.push_back({found->second, &target, why_no_numbers(*found->second, target, jobs, jobs)});
  return pair;
}

}  // namespace orbs::history
