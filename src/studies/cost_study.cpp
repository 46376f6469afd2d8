#include "studies/cost_study.h"

#include "base/cores.h"
#include "base/error.h"
#include "base/files.h"
#include "base/local_time.h"
#include "base/scratch_folder.h"
#include "image/colour.h"
#include "image/image_io.h"
#include "judge/judge.h"
#include "metrics/compare.h"
#include "registry/image_size.h"
#include "runner/host.h"
#include "runner/render_once.h"
#include "runner/renderer_version.h"
#include "studies/cost_json.h"
#include "studies/cost_ladder.h"
#include "studies/cost_subject.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <random>
#include <set>

#include <fmt/format.h>

namespace orbs::studies {

namespace {

using Clock = std::chrono::steady_clock;

struct Study {
  const runner::Plan& plan;
  const CostRequest& request;
  const StudyContext& context;
  CostRecord record;
  std::vector<CostSubject> subjects;
  ScratchFolder scratch{"orbs-cost"};
  Clock::time_point begin = Clock::now();
  Clock::time_point stored = Clock::now();
  std::set<std::size_t> failed = {};  // ladders that have ended

  double seconds() const { return std::chrono::duration<double>(Clock::now() - begin).count(); }
};

void store(Study& study) {
  write_file(study.request.folder / kCostFile, cost_json(study.record));
  study.stored = Clock::now();
}

runner::ChosenRenderer with_settings(runner::ChosenRenderer renderer, const std::string& rung) {
  for (const auto& quality : renderer.entry.cost_ladder)
    if (quality.name == rung)
      for (const auto& [name, value] : quality.scene_settings) renderer.entry.scene_settings[name] = value;
  return renderer;
}

// One render, measured against the reference unless it is of the fixed cost. Nothing when the user
// interrupts.
std::optional<CostRender> render(Study& study, CostRender wanted, bool keep_image, std::size_t rung) {
  const auto& subject = study.subjects[wanted.target];
  const auto& chosen = study.plan.renderers[wanted.renderer];
  auto scene = *subject.scene->scene;
  const bool is_fixed = wanted.purpose == kFixed;
  constexpr int kFewestPixels = 4;  // Blender's least width
  if (is_fixed) scene.camera.width_px = scene.camera.height_px = kFewestPixels;
  const auto folder = study.scratch.path() / "render";
  std::filesystem::remove_all(folder);
  const auto prepared = runner::prepare_render(with_settings(chosen, wanted.rung), study.plan, scene, folder);
  wanted.load = runner::load_average();
  wanted.order = static_cast<int>(study.record.renders.size());
  const auto made = runner::render_once(prepared,
                                        {wanted.spp,
                                         wanted.seed,
                                         study.record.settings.threads,
                                         {},
                                         !subject.one_case->negative_values.empty()},
                                        study.context.stop);
  if (!made) return std::nullopt;
  wanted.cpu_seconds = made->cost.cpu_seconds;
  wanted.wall_seconds = made->cost.wall_seconds;
  wanted.render_seconds = made->cost.render_seconds;
  if (is_fixed) return wanted;
  metrics::CompareSettings settings{
      metrics::NegativePixels::Allowed, 0, false, true, {"relmse_eps01", "mse", "psnr_srgb8", "flip"}};
  const auto comparison = metrics::compare(made->image, subject.reference, subject.mask, settings);
  wanted.relmse = metrics::value_of(comparison, "relmse_eps01");
  wanted.mse = metrics::value_of(comparison, "mse");
  wanted.psnr_srgb8 = metrics::value_of(comparison, "psnr_srgb8");
  wanted.flip = metrics::value_of(comparison, "flip");
  if (keep_image) {
    const CostLadder ladder{wanted.target, wanted.renderer, {}, "", ""};
    const auto exr = study.request.folder / image_file(study.record, ladder, rung, "exr");
    make_folder(exr.parent_path());
    image::write_exr(made->image, exr, image::Precision::Half);
    image::write_png(image::display_image(made->image),
                     study.request.folder / image_file(study.record, ladder, rung, "png"));
  }
  return wanted;
}

std::vector<CostRung> settings_rungs(const registry::Renderer& entry) {
  std::vector<CostRung> rungs;
  for (const auto& quality : entry.cost_ladder) rungs.push_back({quality.name, quality.spp});
  return rungs;
}

// Every pilot is also the warm-up of its renderer and scene: file caches are filled when the rounds begin.
// Nothing when the user interrupts.
std::optional<CostPilot> pilot(Study& study, std::size_t target, std::size_t renderer) {
  constexpr int kPilotSpp = 8;  // enough: the error of an image is a mean over all its pixels
  const auto& entry = study.plan.renderers[renderer].entry;
  CostPilot found{target, renderer, 0, kPilotSpp, 0, 0, 1, settings_rungs(entry)};
  CostRender wanted{.target = target, .renderer = renderer, .purpose = kFixed};
  const auto fixed = render(study, wanted, false, 0);
  if (!fixed) return std::nullopt;
  found.fixed_seconds = fixed->wall_seconds;
  if (!found.settings.empty()) return found;
  wanted.purpose = kOfRung;
  wanted.spp = found.spp;
  constexpr int kPilotSeed = 900;  // of no rung
  wanted.seed = kPilotSeed;
  const auto made = render(study, wanted, false, 0);
  if (!made) return std::nullopt;
  // Not its wall clock: other work on the machine would count for every sample of every rung.
  found.seconds = found.fixed_seconds +
                  std::max(0.0, made->cpu_seconds - fixed->cpu_seconds) / study.record.settings.threads;
  found.psnr_srgb8 = made->psnr_srgb8.value_or(0);
  study.context.say(fmt::format("pilot  {:<10} {:<18} {:>6} spp  {:5.2f} dB  {:6.2f} s", entry.name,
                                study.record.targets[target].name, found.spp, found.psnr_srgb8,
                                found.seconds));
  return found;
}

// False when the user interrupts.
bool choose_rungs(Study& study) {
  std::vector<CostPilot> pilots;
  std::vector<CostLadder> unrendered;
  std::set<std::pair<std::size_t, std::size_t>> seen;
  for (const auto& planned : study.plan.targets) {
    if (planned.jobs.size() != 1) continue;
    const auto& targets = study.record.targets;
    const auto target =
        std::find_if(targets.begin(), targets.end(), [&](const auto& t) { return t.name == planned.target; });
    if (target == targets.end()) continue;
    const auto index = static_cast<std::size_t>(target - targets.begin());
    if (!seen.insert({index, planned.renderer}).second) continue;
    try {
      const auto found = pilot(study, index, planned.renderer);
      if (!found) return false;
      pilots.push_back(*found);
    } catch (const InputError& e) {
      unrendered.push_back({index, planned.renderer, {}, e.what(), ""});
    }
  }
  const auto& settings = study.record.settings;
  const auto say_expected = [&](const char* what, const std::vector<CostLadder>& ladders) {
    double seconds = 0;
    for (std::size_t i = 0; i < pilots.size(); ++i)
      seconds += expected_seconds(pilots[i], ladders[i], settings).value_or(0);
    study.context.say(fmt::format(
        "{}: about {:.0f} s (ladders of settings, which have no estimate, not counted)", what, seconds));
  };
  if (study.request.rungs.empty()) {
    constexpr double kUnlimited = std::numeric_limits<double>::infinity();
    say_expected(fmt::format("all {} curves to {:g} dB", pilots.size(), settings.target_db).c_str(),
                 choose_ladders(pilots, settings, kUnlimited));
    study.record.ladders = choose_ladders(pilots, settings, settings.budget_seconds - study.seconds());
  } else {
    study.record.ladders = given_ladders(pilots, study.request.rungs);
  }
  say_expected("the rungs of this study", study.record.ladders);
  study.record.ladders.insert(study.record.ladders.end(), unrendered.begin(), unrendered.end());
  return true;
}

struct Task {
  CostRender render;
  std::size_t ladder = 0;
  std::size_t rung = 0;
  bool is_first = false;  // its image is kept
};

// The ladder of the comparison of a renderer with itself: the first renderer's cheapest, so that it is there
// early. By the samples of its last rung, the time of which is what is compared.
std::optional<std::size_t> self_ladder(const CostRecord& record) {
  std::optional<std::size_t> cheapest;
  double least = 0;
  for (std::size_t i = 0; i < record.ladders.size(); ++i) {
    const auto& ladder = record.ladders[i];
    if (ladder.renderer != 0 || ladder.rungs.empty()) continue;
    const auto& target = record.targets[ladder.target];
    const double samples = static_cast<double>(ladder.rungs.back().spp) * target.width_px * target.height_px;
    if (cheapest && samples >= least) continue;
    cheapest = i;
    least = samples;
  }
  return cheapest;
}

std::vector<Task> tasks_of_round(const CostRecord& record, int round) {
  std::vector<Task> tasks;
  constexpr int kSeedsOfRung = 1000;  // so that no two rungs share a seed: nested samples are not independent
  const auto self = self_ladder(record);
  for (std::size_t i = 0; i < record.ladders.size(); ++i) {
    const auto& ladder = record.ladders[i];
    if (ladder.rungs.empty()) continue;
    CostRender wanted{
        .target = ladder.target, .renderer = ladder.renderer, .purpose = kFixed, .seed = 1 + round};
    tasks.push_back({wanted, i, 0, false});
    wanted.purpose = kOfRung;
    for (std::size_t rung = 0; rung < ladder.rungs.size(); ++rung) {
      wanted.rung = ladder.rungs[rung].name;
      wanted.spp = ladder.rungs[rung].spp;
      wanted.seed = 1 + round + kSeedsOfRung * (1 + static_cast<int>(rung));
      tasks.push_back({wanted, i, rung, round == 0});
    }
    if (self != i) continue;
    wanted.purpose = kAgain;
    wanted.seed += kSeedsOfRung;
    tasks.push_back({wanted, i, ladder.rungs.size() - 1, false});
  }
  std::mt19937 random(static_cast<unsigned>(record.settings.order_seed) * 1000U +
                      static_cast<unsigned>(round));
  for (std::size_t i = tasks.size(); i > 1; --i) std::swap(tasks[i - 1], tasks[random() % i]);
  return tasks;
}

bool is_done(const CostRecord& record, const CostRender& wanted) {
  return std::any_of(record.renders.begin(), record.renders.end(), [&](const CostRender& render) {
    return render.target == wanted.target && render.renderer == wanted.renderer &&
           render.purpose == wanted.purpose && render.rung == wanted.rung && render.seed == wanted.seed;
  });
}

// False when the user interrupts.
bool do_task(Study& study, const Task& task) {
  auto& record = study.record;
  auto& ladder = record.ladders[task.ladder];
  if (study.failed.contains(task.ladder) || is_done(record, task.render)) return true;
  try {
    const auto made = render(study, task.render, task.is_first, task.rung);
    if (!made) return false;
    record.renders.push_back(*made);
    study.context.say(fmt::format("{:6.0f} s  {:<10} {:<18} {:<14} {:>8}  {:7.2f} s", study.seconds(),
                                  record.renderers[ladder.renderer].name, record.targets[ladder.target].name,
                                  task.render.purpose == kFixed ? "fixed cost" : task.render.rung,
                                  made->psnr_srgb8 ? fmt::format("{:.2f} dB", *made->psnr_srgb8) : "",
                                  made->cpu_seconds));
  } catch (const InputError& e) {
    study.failed.insert(task.ladder);
    ladder.note = fmt::format("{}{}{}", ladder.note, ladder.note.empty() ? "" : "; ", e.what());
  }
  constexpr auto kStoreEvery = std::chrono::seconds(5);
  if (Clock::now() - study.stored > kStoreEvery) store(study);
  return true;
}

// False when the user interrupts. The first two rounds are rendered whatever they cost: without them there is
// no scatter and so no interval.
bool render_rounds(Study& study) {
  const auto& settings = study.record.settings;
  for (int round = 0; round < settings.seeds; ++round)
    for (const auto& task : tasks_of_round(study.record, round)) {
      if (round >= 2 && study.seconds() > settings.budget_seconds) {
        study.context.say(fmt::format("the budget of {:g} s is used up in round {} of {}",
                                      settings.budget_seconds, round + 1, settings.seeds));
        return true;
      }
      const auto& entry = study.plan.renderers[task.render.renderer].entry;
      // Without random samples, every further image would be the same; its time is measured twice.
      if (entry.is_noise_free && round >= 2) continue;
      if (!do_task(study, task)) return false;
    }
  return true;
}

// What can be named of an error that more time may not cure.
void judge_last_rungs(Study& study) {
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
    if (entry.is_noise_free) settings.result_noise = metrics::ResultNoise::NoiseFree;
    judge::judge_image(*subject.one_case, image::read_image(file), {{}, subject.reference, ""}, settings,
                       judged);
    ladder.finding = judged.verdict == results::Verdict::Pass ? "" : judged.reason;
    for (const auto& remark : judged.remarks) ladder.finding += (ladder.finding.empty() ? "" : "; ") + remark;
  }
}

void describe_renderers(Study& study) {
  for (const auto& chosen : study.plan.renderers)
    study.record.renderers.push_back({chosen.entry.name, runner::renderer_version(chosen, study.plan),
                                      chosen.entry.cost_ladder.empty() ? kSampleLadder : kSettingsLadder,
                                      ""});
}

void check_targets(const CostRecord& record, const std::vector<CostTarget>& earlier) {
  const auto is_same = [](const CostTarget& a, const CostTarget& b) { return a.name == b.name; };
  if (!earlier.empty() &&
      !std::equal(earlier.begin(), earlier.end(), record.targets.begin(), record.targets.end(), is_same))
    throw InputError("the suite has other scenes than when this study began; begin a new one");
}

}  // namespace

CostRecord measure_cost(const runner::Plan& plan,
                        const CostRequest& request,
                        CostRecord record,
                        const StudyContext& context) {
  Study study{plan, request, context, std::move(record), {}};
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
    study.record.host = runner::this_host();
    study.record.load = runner::load_average();
    describe_renderers(study);
    if (!choose_rungs(study)) return study.record;
  }
  study.record.is_finished = render_rounds(study);
  judge_last_rungs(study);
  study.record.load_end = runner::load_average();
  store(study);
  return study.record;
}

}  // namespace orbs::studies
