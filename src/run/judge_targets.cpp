#include "run/judge_targets.h"

#include "base/error.h"
#include "base/files.h"
#include "image/colour.h"
#include "image/image_io.h"
#include "judge/diagnosis.h"
#include "judge/difference.h"
#include "judge/judge.h"
#include "run/other_references.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace orbs::run {

using results::JobRecord;
using results::TargetRecord;
using results::Verdict;

TargetRecord blank_target(const Plan& plan,
                          const PlannedTarget& planned,
                          const std::filesystem::path& folder) {
  const auto& one_case = plan.cases[planned.one_case];
  TargetRecord record;
  record.requirement = one_case.requirement;
  record.case_name = one_case.name;
  record.target = planned.target;
  record.renderer = plan.renderers[planned.renderer].entry.name;
  record.declared = planned.declared;
  for (const auto job : planned.jobs) record.jobs.push_back(plan.jobs[job].id);
  const auto reference = std::filesystem::path(kReferenceFolder) / (planned.target + ".exr");
  std::error_code ignored;
  if (std::filesystem::exists(folder / reference, ignored)) record.reference_image = reference.string();
  return record;
}

TargetRecord unsupported_target(const Plan& plan,
                                const PlannedTarget& planned,
                                const std::filesystem::path& folder) {
  auto record = blank_target(plan, planned, folder);
  record.verdict = Verdict::Unsupported;
  record.reason = planned.unsupported;
  if (planned.declared) return record;
  record.reason = fmt::format("{} does not declare {}", record.renderer, record.requirement);
  if (const auto reason = registry::limit_reason(plan.renderers[planned.renderer].entry, record.requirement))
    record.reason += fmt::format(": {}", *reason);
  return record;
}

void take_job_verdict(const JobRecord& job, TargetRecord& record) {
  // A usable image that nobody has judged yet waits for its verdict.
  record.verdict = results::verdict_without_image(job.end.outcome).value_or(Verdict::Skipped);
  record.reason = job.end.reason;
}

namespace {

// What is wrong with an image that a check refuses.
std::string diagnosis_of(const Plan& plan,
                         const registry::Case& one_case,
                         const image::Image& result,
                         const image::Image& reference,
                         const WorkFolders& folders,
                         const TargetRecord& record) {
  const bool is_refused = std::any_of(record.checks.begin(), record.checks.end(), [](const auto& check) {
    return check.measured && check.decided && !check.passed;
  });
  if (record.verdict != Verdict::Fail || !is_refused) return "";
  const auto others = other_references(plan, one_case, record.target, folders.references);
  return judge::diagnosis_text(
      judge::diagnosed({result, reference, others, judge::mask_of(one_case, record.target)}));
}

// What the tests of noise call a large error is beside the point once its cause is known: the first-order
// patterns fit it, and mean nothing.
void leave_out(const std::vector<std::string>& remarks, TargetRecord& record) {
  std::erase_if(record.remarks, [&](const auto& remark) {
    return std::find(remarks.begin(), remarks.end(), remark) != remarks.end();
  });
}

judge::JudgeSettings judge_settings(const Plan& plan, const PlannedTarget& planned) {
  const bool is_noise_free = plan.renderers[planned.renderer].entry.sampling.is_noise_free;
  const auto noise = is_noise_free ? metrics::ResultNoise::NoiseFree : metrics::ResultNoise::AsTheImageSays;
  return {.threads = plan.threads, .result_noise = noise};
}

struct Judged {
  TargetRecord record;
  judge::Reference reference;
};

// The image judged by another reference that its case accepts, if it passes by one with a better verdict.
std::optional<Judged> passed_by_accepted(const Plan& plan,
                                         const PlannedTarget& planned,
                                         const image::Image& result,
                                         Verdict verdict,
                                         const WorkFolders& folders) {
  const auto& one_case = plan.cases[planned.one_case];
  const auto scene = std::find_if(one_case.scenes.begin(), one_case.scenes.end(),
                                  [&](const auto& s) { return s.name == planned.target; });
  if (scene == one_case.scenes.end()) return std::nullopt;
  for (const auto& accepted : scene->accepted) {
    Judged judged{blank_target(plan, planned, folders.run),
                  judge::load_reference(one_case, accepted.reference, plan.suite.references,
                                        plan.reference_hashes, folders.references)};
    if (!judged.reference.image) continue;
    auto& record = judged.record;
    judge::judge_image(one_case, result, judged.reference, judge_settings(plan, planned), record);
    if (!passes(record.verdict) || record.verdict >= verdict) continue;
    record.remarks.push_back(fmt::format("judged by the reference of '{}', which is accepted, too: {}",
                                         accepted.reference, accepted.reason));
    record.reference_image =
        (std::filesystem::path(kReferenceFolder) / (accepted.reference + ".exr")).string();
    return judged;
  }
  return std::nullopt;
}

// Judges one image that is there, and writes what people look at first. Maps of the error are not kept: they
// follow from the image and its reference, took 60 % of the size of a run, and the page and 'orbs compare
// --maps' compute them.
void judge_target(const Plan& plan,
                  const PlannedTarget& planned,
                  const image::Image& result,
                  const WorkFolders& folders,
                  TargetRecord& record) {
  const auto& one_case = plan.cases[planned.one_case];
  auto reference = judge::load_reference(one_case, planned.target, plan.suite.references,
                                         plan.reference_hashes, folders.references);
  const auto comparison =
      judge::judge_image(one_case, result, reference, judge_settings(plan, planned), record);
  if (!comparison) return;
  if (auto judged = record.verdict == Verdict::Pass
                        ? std::nullopt
                        : passed_by_accepted(plan, planned, result, record.verdict, folders)) {
    judged->record.image = record.image;
    record = std::move(judged->record);
    reference = std::move(judged->reference);
  }
  record.diagnosis = diagnosis_of(plan, one_case, result, *reference.image, folders, record);
  if (results::names_a_fault(record)) leave_out(comparison->bias_remarks, record);
  const auto relative = std::filesystem::path(record.renderer) / record.target;
  image::write_png(image::display_image(result), folders.unfinished / relative / "result.png");
}

}  // namespace

std::vector<TargetRecord> judge_scene(const Plan& plan,
                                      std::size_t job,
                                      const Execution& execution,
                                      const WorkFolders& folders) {
  std::vector<TargetRecord> records;
  for (const auto& planned : plan.targets) {
    if (planned.jobs.size() != 1 || planned.jobs.front() != job) continue;
    auto& record = records.emplace_back(blank_target(plan, planned, folders.run));
    record.image = execution.record.files.image;
    if (execution.image) {
      judge_target(plan, planned, *execution.image, folders, record);
    } else {
      take_job_verdict(execution.record, record);
    }
  }
  return records;
}

namespace {

// The image of a finished render. Another renderer may have changed it since.
image::Image unchanged_image(const JobRecord& job, const std::filesystem::path& run) {
  const auto file = run / job.files.image;
  const auto bytes = read_file(file);
  if (const auto now = hash_text(content_hash(bytes)); !job.hashes.image.empty() && now != job.hashes.image)
    throw InputError(fmt::format("{}: has changed since its render: its hash is now {}, it was {}",
                                 job.files.image, now, job.hashes.image));
  return image::read_exr(file.string(), bytes);
}

}  // namespace

TargetRecord judge_difference(const Plan& plan,
                              const PlannedTarget& planned,
                              const std::vector<JobRecord>& jobs,
                              const WorkFolders& folders) {
  auto record = blank_target(plan, planned, folders.run);
  for (const auto job : planned.jobs)
    if (!has_image(jobs[job])) {
      take_job_verdict(jobs[job], record);
      record.reason = fmt::format("its scene '{}': {}", jobs[job].identity.scene, jobs[job].end.reason);
      return record;
    }
  std::vector<image::Image> images;
  for (const auto job : planned.jobs) {
    try {
      images.push_back(unchanged_image(jobs[job], folders.run));
    } catch (const InputError& e) {
      record.verdict = Verdict::Unreadable;
      record.reason = fmt::format("its scene '{}': {}", jobs[job].identity.scene, e.what());
      return record;
    }
  }
  const auto result = judge::difference_of(images.front(), images.back());
  const auto relative = std::filesystem::path(record.renderer) / record.target;
  make_folder(folders.unfinished / relative);
  image::write_exr(result, folders.unfinished / relative / "result.exr");
  record.image = (relative / "result.exr").string();
  judge_target(plan, planned, result, folders, record);
  put_in_place(folders.unfinished / relative, folders.run / relative);
  return record;
}

}  // namespace orbs::run
