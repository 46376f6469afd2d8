// The noise of a reference stays, however many samples a renderer takes. Its variance may be half of what a
// pass leaves room for: then it costs a right renderer twice the samples at most, and leaves none undecided.
#include "base/parallel.h"
#include "base/statistics.h"
#include "judge/judge.h"
#include "metrics/pair_samples.h"
#include "metrics/worst_tile.h"
#include "registry/cases.h"
#include "registry/configuration.h"
#include "run/looks.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <mutex>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

using namespace orbs;

namespace {

// Of the pixels of a rectangle, of one channel.
struct Sums {
  double light = 0;
  double variance = 0;
  double pixels = 0;
  double mean() const { return light / pixels; }
  double error() const { return std::sqrt(variance) / pixels; }
};

Sums sums_of(const metrics::PairSamples& samples, const Rectangle& where, std::size_t channel) {
  Sums sums;
  metrics::for_each_block_pixel(samples, where, [&](std::size_t pixel) {
    sums.light += static_cast<double>(samples.reference[3 * pixel + channel]);
    sums.variance += metrics::variance_at(samples.reference_variance, 3 * pixel + channel);
    sums.pixels += 1;
  });
  return sums;
}

double limit_of(const registry::Case& one_case, const char* metric) {
  return registry::find_gate(one_case.gates, metric)->max.value();
}

// Its light lies on a few tiles, in colours of which a part is outside of Rec. 709 and negative: a tile has a
// standard error of 2.5 %, in red of 8 %. Seven times the samples would do for green and blue.
bool is_known_to_be_noisy(const std::string& name) { return name == "appearance prism_SF10"; }

// The standard errors of the reference over those that a pass leaves room for.
std::vector<std::string> too_noisy(const std::string& name,
                                   const registry::Case& one_case,
                                   const image::Image& reference) {
  constexpr double kShare = std::numbers::sqrt2;
  constexpr double kFirmness = 10;  // of means, see metrics/noise_test.h
  constexpr double kTilesThatFit =
      7.4;  // standard errors in the limit, where all of 3 x 64 intervals must fit
  constexpr double kNormal = 1e9;
  const double to_pass = student_quantile(2 * metrics::kWrongPasses / run::kMostLooks, kNormal);
  const auto samples = metrics::pair_samples(reference, reference);
  std::vector<std::string> complaints;
  for (std::size_t c = 0; c < 3; ++c) {
    const auto all = sums_of(samples, {0, 0, samples.width, samples.height}, c);
    if (!(all.mean() > kFirmness * all.error())) continue;
    constexpr std::array kMeans{"mean_ratio_r", "mean_ratio_g", "mean_ratio_b"};
    const double most = limit_of(one_case, kMeans.at(c)) / kShare / to_pass;
    if (all.error() > most * all.mean())
      complaints.push_back(
          fmt::format("{}: {} of the reference has a standard error of {:.3g} %, at most {:.3g} % is wanted",
                      name, "RGB"[c], 100 * all.error() / all.mean(), 100 * most));
    const double most_of_tile = limit_of(one_case, "local_bias") / kShare / kTilesThatFit;
    double worst = 0;
    constexpr int kTile = metrics::worst_tile::kSize_px;
    for (int y = 0; y + kTile <= samples.height; y += kTile)
      for (int x = 0; x + kTile <= samples.width; x += kTile) {
        const auto tile = sums_of(samples, {x, y, x + kTile, y + kTile}, c);
        if (tile.pixels > 0)
          worst = std::max(worst, tile.error() / (std::max(0.0, tile.mean()) + all.mean()));
      }
    if (worst > most_of_tile)
      complaints.push_back(
          fmt::format("{}: a tile of {} has a standard error of {:.3g} %, at most {:.3g} % is wanted", name,
                      "RGB"[c], 100 * worst, 100 * most_of_tile));
  }
  return complaints;
}

}  // namespace

TEST(EveryReference, LeavesRoomForADecision) {
  std::vector<std::function<std::vector<std::string>()>> tasks;
  for (const auto& suite : registry::load_configuration(ORBS_SOURCE_DIR "/configuration.json").suites)
    for (const auto& one_case : registry::load_cases(suite))
      for (const auto& name : registry::target_names(one_case))
        tasks.emplace_back([=]() -> std::vector<std::string> {
          const auto reference = judge::load_reference(one_case, name, suite.references);
          if (!reference.image || judge::is_difference(one_case, name)) return {};
          const std::string display_name = suite.name + " " + name;
          auto complaints = too_noisy(display_name, one_case, *reference.image);
          if (!is_known_to_be_noisy(display_name)) return complaints;
          if (complaints.empty())
            complaints.push_back(display_name + ": is no longer noisy, and is to be no exception");
          else
            complaints.clear();
          return complaints;
        });
  std::mutex mutex;
  std::vector<std::string> complaints;
  for_each_index(static_cast<int>(tasks.size()), 0, [&](int index) {
    auto found = tasks[static_cast<std::size_t>(index)]();
    const std::lock_guard lock(mutex);
    complaints.insert(complaints.end(), found.begin(), found.end());
  });
  std::sort(complaints.begin(), complaints.end());
  EXPECT_TRUE(complaints.empty()) << fmt::format("{}", fmt::join(complaints, "\n"));
}
