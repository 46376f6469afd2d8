#include "studies/looks/simulate_looks.h"

#include "base/parallel.h"
#include "image/colour.h"
#include "image/image.h"
#include "judge/judge.h"
#include "metrics/merged_renders.h"
#include "run/looks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>
#include <optional>
#include <random>

namespace orbs::studies {

namespace {

constexpr int kSide_px = 48;
constexpr int kTile_px = 16;
constexpr int kReferenceSpp = 65536;
constexpr int kFirstSpp = 16;
constexpr double kBrightShare = 0.03;  // of the light of fireflies, by one sample in
constexpr double kBrightOdds = 50000;

struct Law {
  const char* name;
  bool has_fireflies;
};
constexpr std::array kLaws{Law{"plain", false}, Law{"fireflies", true}};

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

constexpr std::array kErrors{0.0, 1.0, 1.5, 3.0};

using Values = std::vector<double>;  // one per pixel and channel

std::size_t index_of(int x, int y) {
  return static_cast<std::size_t>(y) * kSide_px + static_cast<std::size_t>(x);
}

// A gradient with squares of twice the light: edges, tiles, dark and bright.
Values scene_values() {
  Values values(3UL * kSide_px * kSide_px);
  for (int y = 0; y < kSide_px; ++y)
    for (int x = 0; x < kSide_px; ++x) {
      const double slope = 0.1 + 0.2 * x / kSide_px + 0.1 * y / kSide_px;
      const bool is_bright = (x / 6 + y / 6) % 2 == 0;
      for (std::size_t c = 0; c < 3; ++c)
        values[3 * index_of(x, y) + c] = slope * (is_bright ? 2 : 1) * (1 - 0.1 * static_cast<double>(c));
    }
  return values;
}

double mean_of_channel(const Values& values, std::size_t channel) {
  double sum = 0;
  for (std::size_t i = channel; i < values.size(); i += 3) sum += values[i];
  return sum / (kSide_px * kSide_px);
}

// The last tile gets brighter by a share of its mean and the image's together.
void add_tile_error(double share, Values& values) {
  const auto right = values;
  for (std::size_t c = 0; c < 3; ++c) {
    double tile = 0;
    for (int y = kSide_px - kTile_px; y < kSide_px; ++y)
      for (int x = kSide_px - kTile_px; x < kSide_px; ++x)
        tile += right[3 * index_of(x, y) + c] / (kTile_px * kTile_px);
    for (int y = kSide_px - kTile_px; y < kSide_px; ++y)
      for (int x = kSide_px - kTile_px; x < kSide_px; ++x)
        values[3 * index_of(x, y) + c] += share * (tile + mean_of_channel(right, c));
  }
}

// The share of a filter [1 2 1] / 4 in x and y, by which the edges are blurred.
void add_blur(double share, Values& values) {
  const auto right = values;
  for (int y = 1; y + 1 < kSide_px; ++y)
    for (int x = 1; x + 1 < kSide_px; ++x)
      for (std::size_t c = 0; c < 3; ++c) {
        double soft = 0;
        for (int v = -1; v <= 1; ++v)
          for (int u = -1; u <= 1; ++u)
            soft += (2 - std::abs(u)) * (2 - std::abs(v)) / 16.0 * right[3 * index_of(x + u, y + v) + c];
        values[3 * index_of(x, y) + c] += share * (soft - right[3 * index_of(x, y) + c]);
      }
}

// Every other pixel is brighter or darker by a step of the display, so that the mean square is the limit's.
void add_steps(double limits, Values& values) {
  const double step = std::sqrt(limits) * std::pow(10, -35 / 20.0);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto pixel = static_cast<int>(i / 3);
    const bool is_up = (pixel % kSide_px + pixel / kSide_px) % 2 == 0;
    const double display = image::srgb_encode(static_cast<float>(values[i])) + (is_up ? step : -step);
    values[i] = image::srgb_decode(static_cast<float>(display));
  }
}

// What a renderer with an error of so many limits of the gate converges to.
Values wrong_values(const GateKind& kind, double limits) {
  auto values = scene_values();
  const std::string name = kind.name;
  const auto& gate = kind.gates.front();
  if (name == "mean_ratio")
    for (auto& value : values) value *= 1 - limits * *gate.max;
  if (name == "local_bias") add_tile_error(limits * *gate.max, values);
  if (name == "edge_blur") add_blur(limits * *gate.max, values);
  if (name == "psnr_srgb8") add_steps(limits, values);
  return values;
}

using Random = std::mt19937_64;

struct Sum {
  double value = 0;
  double square = 0;
};

// The sum of n samples and of their squares, in units of their mean: n exponential numbers sum to a gamma
// one, and the variance of their mean is stated as a renderer would, from the squares.
Sum sum_of_samples(const Law& law, int n, Random& random) {
  const double share = law.has_fireflies ? 1 - kBrightShare : 1;
  std::gamma_distribution<double> gamma(n, 1);
  const double plain = share * gamma(random);
  Sum sum{plain, 2 * plain * plain / n};  // the square of an exponential number is twice that of its mean
  if (!law.has_fireflies) return sum;
  std::poisson_distribution<int> count(n / kBrightOdds);
  const double bright = kBrightShare * kBrightOdds;
  const int met = count(random);
  sum.value += met * bright;
  sum.square += met * bright * bright;
  return sum;
}

image::Image render(const Values& values, const Law& law, int n, Random& random) {
  auto out = image::make_image(kSide_px, kSide_px, {"R", "G", "B", "variance.R", "variance.G", "variance.B"});
  for (std::size_t i = 0; i < values.size(); ++i) {
    const Sum sum = sum_of_samples(law, n, random);
    const double mean = sum.value / n;
    const double variance = std::max(0.0, sum.square / n - mean * mean) / (n - 1);
    const std::size_t at = 6 * (i / 3) + i % 3;
    out.pixels[at] = static_cast<float>(values[i] * mean);
    out.pixels[at + 3] = static_cast<float>(values[i] * values[i] * variance);
  }
  return out;
}

// The variance of a reference is that of the law, as its samples know it.
image::Image reference_image(const Law& law, Random& random) {
  return render(scene_values(), law, kReferenceSpp, random);
}

registry::Case case_of(const GateKind& kind) {
  registry::Case one_case;
  one_case.scenes.push_back({"a", {}});
  one_case.gates = kind.gates;
  return one_case;
}

results::Verdict verdict_of(const registry::Case& one_case,
                            const image::Image& image,
                            const judge::Reference& reference,
                            const judge::Looks& looks,
                            bool& is_open) {
  results::TargetRecord record;
  record.target = "a";
  const auto judged = judge::judge_image(
      one_case, image, reference, {.measured = judge::Measured::ForTheVerdict, .looks = looks}, record);
  is_open = judged.look.is_open;
  return record.verdict;
}

struct Ended {
  results::Verdict verdict = results::Verdict::Skipped;
  results::Verdict fixed = results::Verdict::Skipped;
  int spp = 0;
};

// As run/render_looks.cpp goes about it, but for budgets.
Ended sequence(const registry::Case& one_case, const Values& values, const Law& law, std::uint64_t seed) {
  Random random(seed);
  const judge::Reference reference{"", reference_image(law, random), ""};
  run::PlannedJob job;
  job.first_spp = kFirstSpp;
  metrics::MergedRenders merged;
  Ended ended;
  bool is_open = true;
  for (int looks = 0; is_open && looks < run::kMostLooks; ++looks) {
    const int spp = run::next_look(job, looks, 1).spp;
    metrics::add_renders(merged, {render(values, law, spp, random), render(values, law, spp, random)}, spp);
    ended.spp = merged.samples;
    ended.verdict = verdict_of(one_case, merged.mean, reference,
                               {.most = run::kMostLooks,
                                .sample_ratio = static_cast<double>(kReferenceSpp) / merged.samples,
                                .halves = &merged.halves},
                               is_open);
  }
  bool ignored = false;
  ended.fixed = verdict_of(one_case, render(values, law, kFixedSpp, random), reference, {}, ignored);
  return ended;
}

void count(results::Verdict verdict, int& failed, int& passed) {
  passed += results::passes(verdict) ? 1 : 0;
  failed += results::kind_of(verdict) == results::VerdictKind::WrongImage ? 1 : 0;
}

LooksRow simulate_row(const Law& law,
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
  for (const auto& law : kLaws)
    for (const auto& kind : gate_kinds())
      for (const double error : kErrors) {
        if (stop != nullptr && stop->load()) return rows;
        rows.push_back(simulate_row(law, kind, error, settings, stop));
      }
  return rows;
}

}  // namespace orbs::studies
