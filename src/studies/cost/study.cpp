#include "studies/cost/study.h"

#include "base/error.h"
#include "base/files.h"
#include "base/local_time.h"
#include "base/parallel.h"
#include "image/image_io.h"
#include "judge/judge.h"
#include "registry/image_size.h"
#include "results/study_kinds.h"
#include "run/host.h"
#include "run/renderer_version.h"
#include "studies/cost/json.h"
#include "studies/cost/other_load.h"
#include "studies/cost/report.h"
#include "studies/cost/schedule.h"
#include "studies/cost/sweep.h"

#include <algorithm>
#include <chrono>
#include <optional>
#include <set>

#include <fmt/format.h>

namespace orbs::studies {

namespace {

bool is_same_render(const CostRender& render, const CostRender& wanted) {
  return render.target == wanted.target && render.renderer == wanted.renderer &&
         render.purpose == wanted.purpose && render.setting == wanted.setting && render.seed == wanted.seed;
}

// One that other work disturbed is made again when the study is resumed.
bool is_done(const CostRecord& record, const CostRender& wanted) {
  return std::any_of(record.renders.begin(), record.renders.end(), [&](const CostRender& render) {
    return is_same_render(render, wanted) && !is_disturbed(render);
  });
}

void keep(CostRecord& record, const CostRender& made) {
  std::erase_if(record.renders, [&](const CostRender& render) { return is_same_render(render, made); });
  record.renders.push_back(made);
}

using Clock = std::chrono::steady_clock;

struct Progress {
  CostMeasurement& study;
  Clock::time_point begin = Clock::now();
  Clock::time_point stored = Clock::now();
  std::set<std::size_t> failed = {};  // sweeps that have ended
  bool is_warned = false;             // that the machine is in use
  bool is_in_use = false;             // the last render was disturbed, and so were its repeats

  double seconds() const { return std::chrono::duration<double>(Clock::now() - begin).count(); }
};

void store(const CostMeasurement& study) {
  write_file(study.request.folder / results::kCost.file, cost_json(study.record));
}

// Said at the first render that is disturbed, which is soon after the pilot, and not when all is over.
void note_other_work(Progress& progress, const CostRender& made) {
  progress.is_in_use = is_disturbed(made);
  if (!progress.is_in_use || progress.is_warned) return;
  progress.is_warned = true;
  progress.study.context.say(fmt::format(
      "warning: other work takes {:.0f} % of this machine: times are marked as disturbed. Ctrl-C ends the study; "
      "--resume makes what was disturbed once more on an idle machine",
      100 * made.other_share.value_or(0)));
}

// False when the user interrupts.
bool do_task(Progress& progress, const CostTask& task) {
  auto& study = progress.study;
  auto& record = study.record;
  auto& sweep = record.sweeps[task.sweep];
  if (progress.failed.contains(task.sweep) || is_done(record, task.render)) return true;
  try {
    const auto made = undisturbed_render(
        [&] {
          return measured_render(study, task.render,
                                 task.is_first ? std::optional(task.setting) : std::nullopt);
        },
        progress.is_in_use ? 0 : kMostRepeats);
    if (!made) return false;
    note_other_work(progress, *made);
    keep(record, *made);
    study.context.say(
        fmt::format("{:6.0f} s  {:<10} {:<18} {:<14} {:>8}  {:7.2f} s{}", progress.seconds(),
                    record.renderers[sweep.renderer].name, record.targets[sweep.target].name,
                    task.render.purpose == Purpose::FixedCost ? "fixed cost" : task.render.setting,
                    made->psnr_srgb8 ? fmt::format("{:.2f} dB", *made->psnr_srgb8) : "", made->cpu_seconds,
                    is_disturbed(*made) ? fmt::format("  disturbed: others took {:.0f} % of the machine",
                                                      100 * made->other_share.value_or(0))
                                        : ""));
  } catch (const InputError& e) {
    progress.failed.insert(task.sweep);
    sweep.note = fmt::format("{}{}{}", sweep.note, sweep.note.empty() ? "" : "; ", e.what());
  }
  constexpr auto kStoreEvery = std::chrono::seconds(5);
  if (Clock::now() - progress.stored > kStoreEvery) {
    store(study);
    progress.stored = Clock::now();
  }
  return true;
}

// False when the user interrupts. The budget holds from the first pilot, and nothing begins after it.
bool render_all(Progress& progress) {
  const auto& study = progress.study;
  const double budget_seconds = study.record.settings.budget_seconds;
  const auto ended = make_until_spent(
      cost_tasks(study.record), budget_seconds, [&] { return progress.seconds(); },
      [&](const CostTask& task) { return do_task(progress, task); });
  if (ended == Ended::BudgetSpent)
    study.context.say(
        fmt::format("the budget of {:g} s is spent; what was not measured is named below", budget_seconds));
  return ended != Ended::Interrupted;
}

// What can be named of an error that more time may not cure.
void judge_last_settings(CostMeasurement& study) {
  for (auto& sweep : study.record.sweeps) {
    if (sweep.settings.empty()) continue;
    const auto& subject = study.subjects[sweep.target];
    const auto& entry = study.plan.renderers[sweep.renderer].entry;
    const auto file =
        study.request.folder / image_file(study.record, sweep, sweep.settings.size() - 1, "exr");
    if (!no_file_problem(file).empty()) continue;
    results::TargetRecord judged;
    judged.target = subject.target.name;
    judge::JudgeSettings settings;
    settings.measured = judge::Measured::ForTheVerdict;
    if (entry.sampling.is_noise_free) settings.result_noise = metrics::ResultNoise::NoiseFree;
    judge::judge_image(*subject.one_case, image::read_image(file), {{}, subject.reference, ""}, settings,
                       judged);
    sweep.finding = results::passes(judged.verdict) ? "" : judged.reason;
    for (const auto& remark : judged.remarks) sweep.finding += (sweep.finding.empty() ? "" : "; ") + remark;
  }
}

void describe_renderers(CostMeasurement& study) {
  for (const auto& chosen : study.plan.renderers)
    study.record.renderers.push_back(
        {chosen.entry.name, run::renderer_version(chosen, study.plan, {.say = study.context.say}),
         chosen.entry.timing.cost_sweep.empty() ? SweepOf::Samples : SweepOf::Settings,
         chosen.entry.sampling.biased,
         chosen.entry.command.sequence.words.empty() ? 0 : chosen.entry.sampling.seeds});
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
  CostMeasurement study{plan, request, context, std::move(record), {}};
  Progress progress{study};
  const auto earlier = std::move(study.record.targets);
  study.record.targets.clear();
  study.record.settings = request.settings;
  study.record.settings.threads = plan.threads;
  const CoreBinding binding(plan.threads);
  study.subjects = load_cost_subjects(plan, request.folder);
  for (const auto& subject : study.subjects) study.record.targets.push_back(subject.target);
  check_targets(study.record, earlier);
  if (study.record.sweeps.empty()) {
    study.record.orbs_version = context.orbs_version;
    study.record.started = local_time_now();
    study.record.suite = plan.suite.name;
    study.record.size = registry::size_text(plan.settings.size_divisor);
    study.record.host = run::this_host();
    study.record.load = run::load_average();
    describe_renderers(study);
    if (!find_sweeps(study, request.settings.budget_seconds)) return study.record;
  }
  for (auto& sweep : study.record.sweeps)  // earlier versions did not store it
    sweep.is_noise_free = plan.renderers.at(sweep.renderer).entry.sampling.is_noise_free;
  study.record.is_finished = render_all(progress);
  judge_last_settings(study);
  study.record.load_end = run::load_average();
  store(study);
  return study.record;
}

}  // namespace orbs::studies
