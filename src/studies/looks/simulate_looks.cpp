#include "studies/looks/simulate_looks.h"

#include "base/parallel.h"
#include "image/colour.h"
#include "image/image.h"
#include "judge/judge.h"
#include "metrics/merged_renders.h"
#include "run/looks.h"
#include "studies/looks/simulated_images.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>

namespace orbs::studies {

namespace {

constexpr int kTile_px = 16;
constexpr int kReferenceSpp = 65536;
constexpr int kFirstSpp = 16;
constexpr int kMostSpp = 32768;

struct GateKind {
  const char* name;
  std::vector<registry::Gate> gates;
};

const std::vector<GateKind>& gate_kinds() {
  static const std::vector<GateKind> kinds = [] {
    std::vector<GateKind> all{{"mean_ratio", {}}, {"local_bias", {}}, {"edge_blur", {}}, {"psnr_srgb8", {}}};
    for (const auto& gate : registry::default_gates())
      for (auto& kind : all)
        if (gate.metric.starts_with(kind.name)) kind.gates.push_back(gate);
    return all;
  }();
  return kinds;
}

// All gates together, for noise of the kinds that no single gate is made for.
const GateKind& all_gates() {
  static const GateKind all{"all", registry::default_gates()};
  return all;
}

constexpr std::array kErrors{0.0, 1.0, 1.5, 3.0};
constexpr std::array kErrorsOfAll{0.0, 3.0};

double mean_of_channel(const Values& values, std::size_t channel) {
  double sum = 0;
  for (std::size_t i = channel; i < values.size(); i += 3) sum += values[i];
  return sum / (kSimulatedSide_px * kSimulatedSide_px);
}

// The last tile gets brighter by a share of its mean and the image's together.
void add_tile_error(double share, Values& values) {
  const auto right = values;
  for (std::size_t c = 0; c < 3; ++c) {
    double tile = 0;
    for (int y = kSimulatedSide_px - kTile_px; y < kSimulatedSide_px; ++y)
      for (int x = kSimulatedSide_px - kTile_px; x < kSimulatedSide_px; ++x)
        tile += right[3 * simulated_index(x, y) + c] / (kTile_px * kTile_px);
    for (int y = kSimulatedSide_px - kTile_px; y < kSimulatedSide_px; ++y)
      for (int x = kSimulatedSide_px - kTile_px; x < kSimulatedSide_px; ++x)
        values[3 * simulated_index(x, y) + c] += share * (tile + mean_of_channel(right, c));
  }
}

// The share of a filter [1 2 1] / 4 in x and y, by which the edges are blurred.
void add_blur(double share, Values& values) {
  const auto right = values;
  for (int y = 1; y + 1 < kSimulatedSide_px; ++y)
    for (int x = 1; x + 1 < kSimulatedSide_px; ++x)
      for (std::size_t c = 0; c < 3; ++c) {
        double soft = 0;
        for (int v = -1; v <= 1; ++v)
          for (int u = -1; u <= 1; ++u)
            soft +=
                (2 - std::abs(u)) * (2 - std::abs(v)) / 16.0 * right[3 * simulated_index(x + u, y + v) + c];
        values[3 * simulated_index(x, y) + c] += share * (soft - right[3 * simulated_index(x, y) + c]);
      }
}

// Every other pixel is brighter or darker by a step of the display, so that the mean square is the limit's.
void add_steps(double limits, Values& values) {
  const double step = std::sqrt(limits) * std::pow(10, -35 / 20.0);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto pixel = static_cast<int>(i / 3);
    const bool is_up = (pixel % kSimulatedSide_px + pixel / kSimulatedSide_px) % 2 == 0;
    const double display = image::srgb_encode(static_cast<float>(values[i])) + (is_up ? step : -step);
    values[i] = image::srgb_decode(static_cast<float>(display));
  }
}

// What a renderer with an error of so many limits of the gate converges to.
Values wrong_values(const GateKind& kind, double limits) {
  auto values = simulated_values();
  const std::string name = kind.name;
  const auto& gate = kind.gates.front();
  if (name == "mean_ratio" || name == "all")
    for (auto& value : values) value *= 1 - limits * *registry::find_gate(kind.gates, "mean_ratio_r")->max;
  if (name == "local_bias") add_tile_error(limits * *gate.max, values);
  if (name == "edge_blur") add_blur(limits * *gate.max, values);
  if (name == "psnr_srgb8") add_steps(limits, values);
  return values;
}

registry::Case case_of(const GateKind& kind) {
  registry::Case one_case;
  one_case.scenes.push_back({"a", {}});
  one_case.gates = kind.gates;
  return one_case;
}

judge::Look judge_look(const registry::Case& one_case,
                       const image::Image& image,
                       const judge::Reference& reference,
                       const judge::Looks& looks,
                       results::Verdict& verdict) {
  results::TargetRecord record;
  record.target = "a";
  const auto judged = judge::judge_image(
      one_case, image, reference, {.measured = judge::Measured::ForTheVerdict, .looks = looks}, record);
  verdict = record.verdict;
  return judged.look;
}

struct Ended {
  results::Verdict verdict = results::Verdict::Skipped;
  results::Verdict fixed = results::Verdict::Skipped;
  int spp = 0;
};

// A renderer that takes any number of samples.
run::Plan plan_of_looks() {
  run::Plan plan;
  plan.renderers.emplace_back();
  scene::Scene scene;
  scene.camera.width_px = scene.camera.height_px = kSimulatedSide_px;
  plan.scenes.push_back(
      {.name = "a", .file = {}, .scene = std::make_shared<const scene::Scene>(std::move(scene))});
  return plan;
}

// As run/render_looks.cpp goes about it, but for budgets.
Ended sequence(const registry::Case& one_case,
               const Values& values,
               const SampleLaw& law,
               std::uint64_t seed) {
  Random random(seed);
  const judge::Reference reference{"", simulated_reference(law, kReferenceSpp, random), ""};
  const auto plan = plan_of_looks();
  run::PlannedJob job;
  job.first_spp = kFirstSpp;
  metrics::MergedRenders merged;
  judge::Looks looks{.most = run::kMostLooks};
  Ended ended;
  bool is_open = true;
  judge::Need need{2, 2};
  for (int count = 0; is_open && count < run::kMostLooks && ended.spp < kMostSpp; ++count) {
    const int after = count == 0
                          ? kFirstSpp
                          : std::min(kMostSpp, run::samples_after_next(plan, job, count, ended.spp, need));
    const int spp = run::next_look(plan, job, count, ended.spp, after).spp;
    const std::array renders{simulated_image(values, law, spp, random),
                             simulated_image(values, law, spp, random)};
    looks.apart.push_back(metrics::renders_apart(renders[0], renders[1], 2 * spp));
    metrics::add_renders(merged, renders, spp);
    ended.spp = looks.spp = merged.samples;
    looks.sample_ratio = law.is_computed ? 0 : static_cast<double>(kReferenceSpp) / merged.samples;
    looks.halves = &merged.halves;
    const auto look = judge_look(one_case, merged.mean, reference, looks, ended.verdict);
    is_open = look.is_open;
    need = look.need;
  }
  judge_look(one_case, simulated_image(values, law, kFixedSpp, random), reference, {}, ended.fixed);
  return ended;
}

void count(results::Verdict verdict, int& failed, int& passed) {
  passed += results::passes(verdict) ? 1 : 0;
  failed += results::kind_of(verdict) == results::VerdictKind::WrongImage ? 1 : 0;
}

LooksRow simulate_row(const SampleLaw& law,
                      const GateKind& kind,
                      double error,
                      const LooksSettings& settings,
                      const std::atomic<bool>* stop) {
  const auto one_case = case_of(kind);
  const auto values = wrong_values(kind, error);
  std::vector<std::optional<Ended>> all(static_cast<std::size_t>(settings.sequences));
  for_each_index(settings.sequences, settings.threads, [&](int index) {
    if (stop != nullptr && stop->load()) return;
    // The same reference and samples for every error and gate.
    all[static_cast<std::size_t>(index)] =
        sequence(one_case, values, law, settings.seed * 1000003 + static_cast<std::uint64_t>(index));
  });
  LooksRow row{law.name, kind.name, error};
  for (const auto& ended : all) {
    if (!ended) continue;
    ++row.sequences;
    count(ended->verdict, row.failed, row.passed);
    count(ended->fixed, row.fixed_failed, row.fixed_passed);
    row.mean_spp += ended->spp;
  }
  if (row.sequences > 0) row.mean_spp /= row.sequences;
  return row;
}

}  // namespace

std::vector<LooksRow> simulate_looks(const LooksSettings& settings, const std::atomic<bool>* stop) {
  std::vector<LooksRow> rows;
  const auto add = [&](const SampleLaw& law, const GateKind& kind, double error) {
    if (stop == nullptr || !stop->load()) rows.push_back(simulate_row(law, kind, error, settings, stop));
  };
  for (const auto& law : kSampleLaws) {
    if (law.is_for_all_gates) {
      for (const double error : kErrorsOfAll) add(law, all_gates(), error);
      continue;
    }
    for (const auto& kind : gate_kinds())
      for (const double error : kErrors) add(law, kind, error);
  }
  return rows;
}

}  // namespace orbs::studies
