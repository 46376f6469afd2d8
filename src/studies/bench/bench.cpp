#include "studies/bench/bench.h"

#include "adapters/process/programs.h"
#include "base/files.h"
#include "base/local_time.h"
#include "metrics/compare.h"
#include "metrics/seeds.h"
#include "run/execute.h"
#include "run/host.h"
#include "run/plan/choose_renderers.h"
#include "run/render.h"
#include "run/renderer_version.h"
#include "scene/load/load_scene.h"
#include "studies/bench/overhead.h"
#include "studies/seed_statistics.h"

#include <algorithm>
#include <array>
#include <ctime>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::studies {

namespace {

constexpr std::array kUsualRenderers{"orbs", "cycles"};

// The usual renderers that are installed, for a user who names none.
std::string names_to_choose(const registry::Configuration& configuration, run::Plan& plan) {
  std::vector<std::string> names;
  for (const char* name : kUsualRenderers)
    for (const auto& renderer : configuration.renderers) {
      if (renderer.name != name) continue;
      if (run::installed_executable(renderer, plan.root, plan.build)) {
        names.emplace_back(name);
      } else {
        plan.left_out.push_back({name, fmt::format("there is no program '{}' here",
                                                   run::program_name(renderer, plan.root, plan.build))});
      }
    }
  return fmt::format("{}", fmt::join(names, ","));
}

run::Plan plan_of(const registry::Configuration& configuration,
                  const BenchSettings& settings,
                  const StudyContext& context) {
  run::Plan plan;
  plan.root = configuration.root;
  plan.build = context.build;
  plan.settings.sandbox = configuration.defaults.sandbox;
  plan.settings.renderers = settings.only.empty() ? names_to_choose(configuration, plan) : settings.only;
  run::choose_renderers(configuration, plan);
  return plan;
}

struct Images {
  std::vector<std::vector<image::Image>> large;  // [renderer][round]
};

// False if the user interrupts.
bool render_round(int round,
                  const std::vector<run::PreparedRender>& subjects,
                  const StudyContext& context,
                  BenchRecord& record,
                  Images& images) {
  const int small_spp = std::max(1, record.settings.spp / 8);
  for (std::size_t turn = 0; turn < subjects.size(); ++turn) {
    // Every other round runs backwards, so that no renderer always comes first.
    const std::size_t i = round % 2 == 0 ? turn : subjects.size() - 1 - turn;
    const auto small =
        run::render_once(subjects[i], {small_spp, round + 1, record.settings.threads}, context.stop);
    if (!small) return false;
    auto large = run::render_once(subjects[i], {record.settings.spp, round + 1, record.settings.threads},
                                  context.stop);
    if (!large) return false;
    record.renderers[i].rounds.push_back({small->cost, large->cost});
    images.large[i].push_back(std::move(large->image));
    context.say(fmt::format("[{}/{}] {:<8} {} and {} spp took {:.2f} and {:.2f} s of CPU", round + 1,
                            record.settings.rounds, record.renderers[i].name, small_spp, record.settings.spp,
                            small->cost.cpu_seconds, large->cost.cpu_seconds));
  }
  return true;
}

void measure_noise(const Images& images, BenchRecord& record) {
  if (record.settings.rounds < 2) return;
  std::vector<image::Image> means;
  for (const auto& of_renderer : images.large) means.push_back(metrics::mean_of(of_renderer));
  const auto mean = metrics::mean_of(means);
  for (std::size_t i = 0; i < record.renderers.size(); ++i)
    record.renderers[i].noise = noise_of_seeds(images.large[i], mean, record.settings.threads);
}

// std::clock counts the CPU time of all threads.
double metrics_cpu_ms(const image::Image& result, const image::Image& reference, int threads) {
  constexpr int kRepetitions = 5;
  std::vector<double> times_ms;
  for (int i = 0; i < kRepetitions; ++i) {
    const auto start = std::clock();
    metrics::compare(result, reference, {}, {metrics::NegativePixels::Allowed, threads});
    times_ms.push_back(1000.0 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
  }
  return spread_of(times_ms)->median;
}

}  // namespace

std::optional<BenchRecord> run_bench(const registry::Configuration& configuration,
                                     const BenchSettings& settings,
                                     const StudyContext& context) {
  const auto plan = plan_of(configuration, settings, context);
  const auto file = configuration.root / "data/bench/cornell-box.json";
  auto scene = scene::load_scene(file);
  scene.camera.width_px = settings.size_px;
  scene.camera.height_px = settings.size_px;
  BenchRecord record;
  record.settings = settings;
  record.orbs_version = context.orbs_version;
  record.started = local_time_now();
  record.host = run::this_host();
  record.load = run::load_average();
  record.scene = scene.name;
  record.trace_depth = scene.trace_depth;
  record.left_out = plan.left_out;
  for (const auto& left : plan.left_out)
    context.say(fmt::format("left out: {}: {}", left.renderer, left.reason));
  const ScratchFolder scratch("orbs-bench");
  std::vector<run::PreparedRender> subjects;
  for (const auto& chosen : plan.renderers) {
    subjects.push_back(run::prepare_render(chosen, plan, scene, scratch.path() / chosen.entry.name));
    record.renderers.push_back(
        {chosen.entry.name, run::renderer_version(chosen, plan, {.say = context.say}), {}, {}});
  }
  Images images{std::vector<std::vector<image::Image>>(subjects.size())};
  for (int round = 0; round < settings.rounds; ++round)
    if (!render_round(round, subjects, context, record, images)) return std::nullopt;
  measure_noise(images, record);
  constexpr int kOverheadRounds = 20;
  record.overhead = measure_overhead(scene, images.large.front().front(), kOverheadRounds,
                                     scratch.path() / "overhead", context.stop);
  if (!record.overhead) return std::nullopt;
  record.start = measure_start(context.build, file, kOverheadRounds, scratch.path() / "start");
  record.metrics_cpu_ms =
      metrics_cpu_ms(images.large.front().front(), metrics::mean_of(images.large.front()), settings.threads);
  return record;
}

}  // namespace orbs::studies
