#include "studies/cost/study.h"

#include "base/cores.h"
#include "base/error.h"
#include "base/files.h"
#include "base/local_time.h"
#include "image/image_io.h"
#include "judge/judge.h"
#include "registry/image_size.h"
#include "results/cost_study.h"
#include "run/host.h"
#include "run/renderer_version.h"
#include "studies/cost/json.h"
#include "studies/cost/pilot.h"
#include "studies/cost/render.h"
#include "studies/cost/tasks.h"

#include <algorithm>
#include <chrono>
#include <set>

#include <fmt/format.h>

namespace orbs::studies {

namespace {

using Clock = std::chrono::steady_clock;

struct Progress {
  CostStudy& study;
  Clock::time_point begin = Clock::now();
  Clock::time_point stored = Clock::now();
  std::set<std::size_t> failed = {};  // ladders that have ended

  double seconds() const { return std::chrono::duration<double>(Clock::now() - begin).count(); }
};

void store(const CostStudy& study) {
  write_file(study.request.folder / results::kCostFile, cost_json(study.record));
}

// False when the user interrupts.
bool do_task(Progress& progress, const CostTask& task) {
  auto& study = progress.study;
  auto& record = study.record;
  auto& ladder = record.ladders[task.ladder];
  if (progress.failed.contains(task.ladder) || is_done(record, task.render)) return true;
  try {
    const auto made =
        measured_render(study, task.render, task.is_first ? std::optional(task.rung) : std::nullopt);
    if (!made) return false;
    record.renders.push_back(*made);
    study.context.say(fmt::format("{:6.0f} s  {:<10} {:<18} {:<14} {:>8}  {:7.2f} s", progress.seconds(),
                                  record.renderers[ladder.renderer].name, record.targets[ladder.target].name,
                                  task.render.purpose == kFixed ? "fixed cost" : task.render.rung,
                                  made->psnr_srgb8 ? fmt::format("{:.2f} dB", *made->psnr_srgb8) : "",
                                  made->cpu_seconds));
  } catch (const InputError& e) {
    progress.failed.insert(task.ladder);
    ladder.note = fmt::format("{}{}{}", ladder.note, ladder.note.empty() ? "" : "; ", e.what());
  }
  constexpr auto kStoreEvery = std::chrono::seconds(5);
  if (Clock::now() - progress.stored > kStoreEvery) {
    store(study);
    progress.stored = Clock::now();
  }
  return true;
}

// False when the user interrupts. The first two rounds are rendered whatever they cost: without them there is
// no scatter and so no interval.
bool render_rounds(Progress& progress) {
  const auto& study = progress.study;
  const auto& settings = study.record.settings;
  for (int round = 0; round < settings.seeds; ++round)
    for (const auto& task : tasks_of_round(study.record, round)) {
      if (round >= 2 && progress.seconds() > settings.budget_seconds) {
        study.context.say(fmt::format("the budget of {:g} s is used up in round {} of {}",
                                      settings.budget_seconds, round + 1, settings.seeds));
        return true;
      }
      const auto& entry = study.plan.renderers[task.render.renderer].entry;
      // Without random samples, every further image would be the same; its time is measured twice.
      if (entry.sampling.is_noise_free && round >= 2) continue;
      if (!do_task(progress, task)) return false;
    }
  return true;
}

// What can be named of an error that more time may not cure.
void judge_last_rungs(CostStudy& study) {
  for (auto& ladder : study.record.ladders) {
    if (ladder.rungs.empty()) continue;
    const auto& subject = study.subjects[ladder.target];
    const auto& entry = study.plan.renderers[ladder.renderer].entry;
    const auto file = study.request.folder / image_file(study.record, ladder, ladder.rungs.size() - 1, "exr");
    if (!no_file_problem(file).empty()) continue;
    results::TargetRecord judged;
    judged.target = subject.target.name;
    judge::JudgeSettings settings;
    settings.measured = judge::Measured::ForTheVerdict;
    if (entry.sampling.is_noise_free) settings.result_noise = metrics::ResultNoise::NoiseFree;
    judge::judge_image(*subject.one_case, image::read_image(file), {{}, subject.reference, ""}, settings,
                       judged);
    ladder.finding = judged.verdict == results::Verdict::Pass ? "" : judged.reason;
    for (const auto& remark : judged.remarks) ladder.finding += (ladder.finding.empty() ? "" : "; ") + remark;
  }
}

void describe_renderers(CostStudy& study) {
  for (const auto& chosen : study.plan.renderers)
    study.record.renderers.push_back(
        {chosen.entry.name, run::renderer_version(chosen, study.plan, {.say = study.context.say}),
         chosen.entry.timing.cost_ladder.empty() ? kSampleLadder : kSettingsLadder,
         chosen.entry.sampling.biased});
}

void check_targets(const CostRecord& record, const std::vector<CostTarget>& earlier) {
  const auto is_same = [](const CostTarget& a, const CostTarget& b) { return a.name == b.name; };
  if (!earlier.empty() &&
      !std::equal(earlier.begin(), earlier.end(), record.targets.begin(), record.targets.end(), is_same))
    throw InputError("the suite has other scenes than when this study began; begin a new one");
}

}  // namespace

CostRecord measure_cost(const run::Plan& plan,
                        const CostRequest& request,
                        CostRecord record,
                        const StudyContext& context) {
  CostStudy study{plan, request, context, std::move(record), {}};
  Progress progress{study};
  const auto earlier = std::move(study.record.targets);
  study.record.targets.clear();
  study.record.settings = request.settings;
  study.record.settings.threads = plan.threads;
  const CoreBinding binding(plan.threads);
  study.subjects = load_cost_subjects(plan, request.folder);
  for (const auto& subject : study.subjects) study.record.targets.push_back(subject.target);
  check_targets(study.record, earlier);
  if (study.record.ladders.empty()) {
    study.record.orbs_version = context.orbs_version;
    study.record.started = local_time_now();
    study.record.suite = plan.suite.name;
    study.record.size = registry::size_text(plan.settings.size_divisor);
    study.record.host = run::this_host();
    study.record.load = run::load_average();
    describe_renderers(study);
    if (!choose_rungs(study, request.settings.budget_seconds)) return study.record;
  }
  study.record.is_finished = render_rounds(progress);
  judge_last_rungs(study);
  study.record.load_end = run::load_average();
  store(study);
  return study.record;
}

}  // namespace orbs::studies
