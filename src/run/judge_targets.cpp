#include "run/judge_targets.h"

#include "base/error.h"
#include "base/files.h"
#include "base/text.h"
#include "image/colour.h"
#include "image/image_io.h"
#include "judge/diagnosis.h"
#include "judge/difference.h"
#include "judge/judge.h"
#include "judge/nearest_reading.h"
#include "judge/provenance.h"
#include "metrics/merged_renders.h"
#include "metrics/surface_layers.h"
#include "run/looks.h"
#include "run/other_references.h"
#include "run/wrong_regions.h"

#include <algorithm>
#include <array>
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

// Says what is wrong with an image that a check refuses, and writes the image that shows it beside the
// result.
void diagnose(const Plan& plan,
              const registry::Case& one_case,
              const image::Image& result,
              const image::Image& reference,
              const WorkFolders& folders,
              TargetRecord& record) {
  // The usual faults are those of colours; metrics name those of layers themselves.
  const bool is_refused = std::any_of(record.checks.begin(), record.checks.end(), [](const auto& check) {
    return check.measured && check.decided && !check.passed && !metrics::is_of_layers(check.what);
  });
  if (record.verdict != Verdict::Fail || !is_refused) return;
  const auto others = other_references(plan, one_case, record.target, folders.references);
  const auto diagnosis =
      judge::diagnosed({result, reference, others, judge::mask_of(one_case, record.target)});
  record.diagnosis = judge::diagnosis_text(diagnosis);
  if (!diagnosis) return;
  const auto file = std::filesystem::path(record.renderer) / record.target / "fault-undone.exr";
  image::write_exr(diagnosis->proof, folders.unfinished / file);
  record.proof = {file.string(), diagnosis->is_undone};
}

// What the tests of noise call a large error is beside the point once its cause is known: the first-order
// patterns fit it, and mean nothing.
void leave_out(const std::vector<std::string>& remarks, TargetRecord& record) {
  std::erase_if(record.remarks, [&](const auto& remark) {
    return std::find(remarks.begin(), remarks.end(), remark) != remarks.end();
  });
}

// The scene that an image shows; nullptr of a difference of two.
const scene::Scene* scene_of(const Plan& plan, const PlannedTarget& planned) {
  const auto found = std::find_if(plan.scenes.begin(), plan.scenes.end(),
                                  [&](const auto& one) { return one.name == planned.target; });
  return found == plan.scenes.end() ? nullptr : found->scene.get();
}

// What is judged. Halves: of the samples of one that is rendered in looks, nullptr for fixed samples.
struct JudgedImage {
  const image::Image& image;
  const std::array<image::Image, 2>* halves = nullptr;
  int spp = 0;
  int first_guess = 1;
  std::vector<results::LookApart> apart = {};  // by look
  results::JobCondition condition = {};        // of its render, where it is of one
};

// The samples of the reference for one sample of the image, each pixel of which covers several of the full
// size; in samples of the case, of which the renderer may count others. 0 where the reference does not say.
double sample_ratio(const Plan& plan,
                    const PlannedTarget& planned,
                    const image::Image& reference,
                    const JudgedImage& judged) {
  const auto stated = to_integer(judge::provenance_of(reference)["spp"]);
  const auto& scene = plan.scenes[plan.jobs[planned.jobs.front()].scene];
  const auto divisor = static_cast<double>(scene.size_divisor);
  const double scale = plan.renderers[planned.renderer].entry.sampling.spp_scale;
  return stated ? static_cast<double>(*stated) * divisor * divisor * scale / judged.spp : 0;
}

judge::JudgeSettings judge_settings(const Plan& plan,
                                    const PlannedTarget& planned,
                                    const judge::Reference& reference,
                                    const JudgedImage& judged) {
  const bool is_noise_free = plan.renderers[planned.renderer].entry.sampling.is_noise_free;
  const auto noise = is_noise_free ? metrics::ResultNoise::NoiseFree : metrics::ResultNoise::AsTheImageSays;
  judge::JudgeSettings settings{
      .threads = plan.threads, .result_noise = noise, .condition = judged.condition};
  if (judged.halves == nullptr) return settings;
  settings.looks.most = kMostLooks;
  settings.looks.halves = judged.halves;
  settings.looks.spp = judged.spp;
  for (const auto& apart : judged.apart)
    settings.looks.apart.push_back({apart.spp, {apart.r, apart.g, apart.b}});
  settings.looks.of_first_guess = static_cast<double>(judged.spp) / judged.first_guess;
  if (reference.image) settings.looks.sample_ratio = sample_ratio(plan, planned, *reference.image, judged);
  return settings;
}

struct Judged {
  TargetRecord record;
  judge::Reference reference;
  judge::Look look;
};

// The image judged by another reference that its case accepts, if it passes by one with a better verdict.
std::optional<Judged> passed_by_accepted(const Plan& plan,
                                         const PlannedTarget& planned,
                                         const JudgedImage& image,
                                         Verdict verdict,
                                         const WorkFolders& folders) {
  const auto& one_case = plan.cases[planned.one_case];
  const auto scene = std::find_if(one_case.scenes.begin(), one_case.scenes.end(),
                                  [&](const auto& s) { return s.name == planned.target; });
  if (scene == one_case.scenes.end()) return std::nullopt;
  for (const auto& accepted : scene->accepted) {
    Judged judged{blank_target(plan, planned, folders.run),
                  judge::load_reference(one_case, accepted.reference, plan.suite.references,
                                        plan.reference_hashes, folders.references),
                  {}};
    if (!judged.reference.image) continue;
    auto& record = judged.record;
    judged.look = judge::judge_image(one_case, image.image, judged.reference,
                                     judge_settings(plan, planned, judged.reference, image), record)
                      .look;
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
judge::Look judge_target(const Plan& plan,
                         const PlannedTarget& planned,
                         const JudgedImage& given,
                         const WorkFolders& folders,
                         TargetRecord& record) {
  const auto& one_case = plan.cases[planned.one_case];
  auto reference = judge::load_reference(one_case, planned.target, plan.suite.references,
                                         plan.reference_hashes, folders.references);
  const auto read = reference.image ? judge::nearest_reading(given.image, *reference.image) : std::nullopt;
  const JudgedImage image{read ? *read : given.image, given.halves, given.spp,
                          given.first_guess,          given.apart,  given.condition};
  const auto judgement = judge::judge_image(one_case, image.image, reference,
                                            judge_settings(plan, planned, reference, image), record);
  auto look = judgement.look;
  if (!judgement.comparison) return look;
  if (auto judged = record.verdict == Verdict::Pass
                        ? std::nullopt
                        : passed_by_accepted(plan, planned, image, record.verdict, folders)) {
    judged->record.image = record.image;
    record = std::move(judged->record);
    reference = std::move(judged->reference);
    look = judged->look;
  }
  diagnose(plan, one_case, image.image, *reference.image, folders, record);
  if (results::names_a_fault(record)) leave_out(judgement.comparison->bias_remarks, record);
  record.wrong_regions = wrong_regions(record, image.image, *reference.image,
                                       judge::mask_of(one_case, record.target), scene_of(plan, planned));
  const auto relative = std::filesystem::path(record.renderer) / record.target;
  image::write_png(image::display_image(image.image), folders.unfinished / relative / "result.png");
  return look;
}

}  // namespace

std::vector<JudgedTarget> judge_scene(const Plan& plan,
                                      std::size_t job,
                                      const Execution& execution,
                                      const WorkFolders& folders) {
  std::vector<JudgedTarget> all;
  const auto* halves = execution.merged ? &execution.merged->halves : nullptr;
  for (const auto& planned : plan.targets) {
    if (planned.jobs.size() != 1 || planned.jobs.front() != job) continue;
    auto& [record, look] = all.emplace_back(JudgedTarget{blank_target(plan, planned, folders.run)});
    record.image = execution.record.files.image;
    if (execution.image) {
      look = judge_target(
          plan, planned,
          {*execution.image, halves, execution.record.identity.spp, first_guess_spp(plan.jobs[job]),
           execution.record.sampling.apart, execution.record.condition},
          folders, record);
    } else {
      take_job_verdict(execution.record, record);
    }
  }
  return all;
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

// Both scenes are rendered with the same seeds, so a look of both has the difference of what they show.
std::vector<results::LookApart> apart_of_difference(const results::JobSampling& of,
                                                    const results::JobSampling& minus) {
  std::vector<results::LookApart> apart;
  for (std::size_t i = 0; i < std::min(of.apart.size(), minus.apart.size()); ++i) {
    const auto& a = of.apart[i];
    const auto& b = minus.apart[i];
    if (a.spp == b.spp) apart.push_back({a.spp, a.r - b.r, a.g - b.g, a.b - b.b});
  }
  return apart;
}

std::array<image::Image, 2> halves_of_difference(const std::vector<const JobRecord*>& jobs,
                                                 const std::filesystem::path& run) {
  std::vector<std::array<image::Image, 2>> both;
  for (const auto* job : jobs) {
    const auto all = image::read_image(run / job->files.folder / kHalvesFile);
    both.push_back(metrics::halves_of(all));
  }
  return {judge::difference_of(both.front()[0], both.back()[0]),
          judge::difference_of(both.front()[1], both.back()[1])};
}

}  // namespace

JudgedTarget judge_difference(const Plan& plan,
                              const PlannedTarget& planned,
                              const std::vector<const JobRecord*>& jobs,
                              const WorkFolders& folders) {
  JudgedTarget judged{blank_target(plan, planned, folders.run)};
  auto& record = judged.record;
  for (const auto* job : jobs)
    if (!has_image(*job)) {
      take_job_verdict(*job, record);
      record.reason = fmt::format("its scene '{}': {}", job->identity.scene, job->end.reason);
      return judged;
    }
  std::vector<image::Image> images;
  std::array<image::Image, 2> halves;
  const bool has_halves = jobs.front()->sampling.looks > 0 && jobs.back()->sampling.looks > 0;
  for (const auto* job : jobs) {
    try {
      images.push_back(unchanged_image(*job, folders.run));
      if (has_halves && job == jobs.back()) halves = halves_of_difference(jobs, folders.run);
    } catch (const InputError& e) {
      record.verdict = Verdict::Unreadable;
      record.reason = fmt::format("its scene '{}': {}", job->identity.scene, e.what());
      return judged;
    }
  }
  const auto result = judge::difference_of(images.front(), images.back());
  const auto relative = std::filesystem::path(record.renderer) / record.target;
  make_folder(folders.unfinished / relative);
  image::write_exr(result, folders.unfinished / relative / "result.exr");
  record.image = (relative / "result.exr").string();
  judged.look = judge_target(plan, planned,
                             {result, has_halves ? &halves : nullptr,
                              std::min(jobs.front()->identity.spp, jobs.back()->identity.spp),
                              first_guess_spp(plan.jobs[planned.jobs.front()]),
                              apart_of_difference(jobs.front()->sampling, jobs.back()->sampling)},
                             folders, record);
  put_in_place(folders.unfinished / relative, folders.run / relative);
  return judged;
}

}  // namespace orbs::run
