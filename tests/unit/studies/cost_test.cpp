#include "structure/source_files.h"
#include "studies/cost/json.h"
#include "studies/cost/numbers.h"
#include "studies/cost/report.h"
#include "studies/cost/sweep.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

using namespace orbs::studies;

namespace {

// A renderer whose relmse is b + v / t^p with t = seconds above the fixed cost, t = spp x cost.
struct MadeUp {
  double bias_squared = 0;
  double variance = 0.01;  // at one second
  double seconds_per_sample = 0.01;
  double fixed = 0.2;
};

constexpr int kSeeds = 4;

void add_curve(CostRecord& record, std::size_t renderer, const MadeUp& truth, std::mt19937& random) {
  std::normal_distribution<double> normal;
  Sweep sweep{0, renderer, {}, "", ""};
  for (const int spp : {16, 32, 64, 128, 256, 512}) {
    sweep.settings.push_back({std::to_string(spp) + " spp", spp});
    for (int seed = 0; seed < kSeeds; ++seed) {
      CostRender render{
          .target = 0, .renderer = renderer, .setting = sweep.settings.back().name, .spp = spp, .seed = seed};
      const double seconds = truth.seconds_per_sample * spp;
      render.cpu_seconds = truth.fixed + seconds * (1 + 0.01 * normal(random));
      render.wall_seconds = render.cpu_seconds / 2;
      const double error =
          (truth.bias_squared + truth.variance / seconds + record.targets[0].reference_noise.relmse) *
          (1 + 0.03 * normal(random));
      render.relmse = error;
      render.mse = error;
      render.psnr_srgb8 = 10 * std::log10(1 / error);
      record.renders.push_back(render);
      if (seed < kSeeds && spp == 512 && renderer == 0) {
        render.purpose = Purpose::Again;
        record.renders.push_back(render);
      }
    }
  }
  CostRender fixed{.target = 0, .renderer = renderer, .purpose = Purpose::FixedCost};
  fixed.cpu_seconds = truth.fixed;
  record.renders.push_back(fixed);
  record.sweeps.push_back(sweep);
}

CostRecord made_up(const std::vector<MadeUp>& renderers) {
  std::mt19937 random(11);
  CostRecord record;
  record.is_finished = true;
  record.targets.push_back({"t", "M1", "Lambert", 8, 8, "", {1e-6, 1e-6, 50.0}});
  for (std::size_t i = 0; i < renderers.size(); ++i)
    record.renderers.push_back({"r" + std::to_string(i), "1", SweepOf::Samples, ""});
  for (std::size_t i = 0; i < renderers.size(); ++i) add_curve(record, i, renderers[i], random);
  return record;
}

const TimeToError& time_of(const CostCurve& curve, std::size_t metric, double level) {
  for (const auto& time : curve.times_to_error)
    if (time.target.metric == metric && time.target.level == level) return time;
  throw std::runtime_error("no such error");
}

}  // namespace

TEST(Cost, TimesToErrorAreThoseAtWhichTheErrorIsReached) {
  const auto numbers = cost_numbers(made_up({MadeUp{}}));
  const auto& curve = numbers.curves.at(0);
  // 0.01 / t = 0.01 at t = 1 s above the fixed cost.
  const auto& time = time_of(curve, kRelmse, 1e-2);
  ASSERT_TRUE(time.cpu_seconds);
  EXPECT_LE(time.cpu_seconds->low, 1.2);
  EXPECT_GE(time.cpu_seconds->high, 1.2);
  EXPECT_NEAR(time.cpu_seconds->value, 1.2, 0.06);
  EXPECT_EQ(time.bound, Bound::Exact);
  EXPECT_EQ(time_of(curve, kRelmse, 1e-4).bound, Bound::AtLeast);
  EXPECT_FALSE(time_of(curve, kRelmse, 1e-4).cpu_seconds);
  EXPECT_NEAR(time_of(curve, kRelmse, 1e-4).bound_seconds, 5.32, 0.2);
  ASSERT_TRUE(curve.fit);
  EXPECT_FALSE(curve.fit->has_floor);
  EXPECT_NEAR(curve.fit->exponent.value, 1, 0.05);
  EXPECT_NEAR(curve.seconds_per_db->value, std::pow(10, 0.1) - 1, 0.05);
}

TEST(Cost, ABiasIsAFloorAndItsNumberIsFound) {
  const auto numbers = cost_numbers(made_up({MadeUp{.bias_squared = 2e-3}}));
  ASSERT_TRUE(numbers.curves.at(0).fit);
  EXPECT_TRUE(numbers.curves.at(0).fit->has_floor);
  EXPECT_NEAR(numbers.curves.at(0).fit->bias_squared.value, 2e-3, 4e-4);
  EXPECT_FALSE(time_of(numbers.curves.at(0), kRelmse, 1e-3).cpu_seconds);
}

// Errors that fall as 1 / samples, with times of the first points that other work on the machine made longer.
TEST(Cost, NoisyTimesAreNoFloor) {
  auto record = made_up({MadeUp{}});
  for (auto& render : record.renders)
    if (render.spp == 16 || render.spp == 64) render.cpu_seconds += 0.3 * (render.cpu_seconds - 0.2);
  const auto numbers = cost_numbers(record);
  ASSERT_TRUE(numbers.curves.at(0).fit);
  EXPECT_FALSE(numbers.curves.at(0).fit->has_floor);
  EXPECT_NEAR(numbers.curves.at(0).fit->exponent.value, 1, 0.05);
}

// Samples that converge ever more slowly, as low-discrepancy ones do, have no floor before they are flat.
TEST(Cost, ABendIsNoFloor) {
  auto record = made_up({MadeUp{}});
  for (auto& render : record.renders)
    if (render.relmse && render.spp < 128) *render.relmse *= 128.0 / render.spp;
  const auto numbers = cost_numbers(record);
  ASSERT_TRUE(numbers.curves.at(0).fit);
  EXPECT_FALSE(numbers.curves.at(0).fit->has_floor);
}

TEST(Cost, TheFasterOfTwoIsCalledFasterAndTheFrontierIsIts) {
  const auto numbers = cost_numbers(made_up({MadeUp{}, MadeUp{.variance = 0.02}}));
  ASSERT_TRUE(numbers.self_comparison && numbers.self_comparison->passed);
  for (const auto& one : numbers.comparisons) {
    if (one.error != ErrorTarget{kRelmse, 1e-2}) continue;
    EXPECT_EQ(one.ranking, Ranking::Slower);
    ASSERT_TRUE(one.time_ratio);
    EXPECT_NEAR(one.time_ratio->value, 2.2 / 1.2, 0.15);
  }
  for (const auto& point : numbers.curves.at(0).points)
    EXPECT_TRUE(point.is_on_frontier) << point.setting.name;
  EXPECT_FALSE(numbers.curves.at(1).points.back().is_on_frontier);
}

TEST(Cost, NothingIsRankedWhenARendererDiffersFromItself) {
  auto record = made_up({MadeUp{}, MadeUp{.variance = 0.02}});
  for (auto& render : record.renders)
    if (render.purpose == Purpose::Again) render.cpu_seconds *= 1.4;
  const auto numbers = cost_numbers(record);
  ASSERT_TRUE(numbers.self_comparison);
  EXPECT_FALSE(numbers.self_comparison->passed);
  EXPECT_TRUE(numbers.comparisons.empty());
  EXPECT_NE(cost_table(record, {}).find("nothing is ranked"), std::string::npos);
}

// Pairs of equal renderers of which the check calls some different: at most 1 % by time and 1 % by error.
TEST(Cost, TheSelfComparisonRarelyFindsADifferenceWhereThereIsNone) {
  std::mt19937 random(17);
  std::normal_distribution<double> normal;
  int failed = 0;
  constexpr int kPairs = 1000;
  for (int pair = 0; pair < kPairs; ++pair) {
    CostRecord record;
    record.targets.push_back({"t", "M1", "", 8, 8, "", {}});
    record.renderers.push_back({"r", "1", SweepOf::Samples, ""});
    record.sweeps.push_back({0, 0, {{"64 spp", 64}}, "", ""});
    for (int i = 0; i < 2 * kSeeds; ++i) {
      CostRender render{.setting = "64 spp", .spp = 64};
      if (i >= kSeeds) render.purpose = Purpose::Again;
      render.cpu_seconds = 3 * std::exp(0.03 * normal(random));
      render.relmse = 1e-3 * std::exp(0.03 * normal(random));
      record.renders.push_back(render);
    }
    failed += cost_numbers(record).self_comparison->passed ? 0 : 1;
  }
  EXPECT_LE(failed, kPairs * 3 / 100);
  EXPECT_GE(failed, 5) << "a check that never fails tests nothing";
}

TEST(Cost, IsReadBackAsItWasWritten) {
  const auto record = made_up({MadeUp{}, MadeUp{.bias_squared = 1e-3}});
  const auto text = cost_json(record);
  const orbs::structure::TestFolder folder("cost");
  folder.write("cost.json", text);
  EXPECT_EQ(cost_json(read_cost_file(folder.path() / "cost.json")), text);
}

TEST(Sweep, CrossesTheTargetWithMoreAndMoreSamples) {
  // 8 samples give 25 dB, so 80 give 35, and half as many again 120.
  const CostPilot pilot{0, 0, 0.1, 8, 0.5, 25, 1, {}};
  const auto sweeps = choose_sweeps({pilot}, CostSettings{}, 1e9);
  ASSERT_EQ(sweeps.at(0).settings.size(), 5);
  EXPECT_EQ(sweeps[0].settings.front().spp, 8);
  EXPECT_EQ(sweeps[0].settings.back().spp, 128);
  EXPECT_EQ(sweeps[0].note, "");
}

TEST(Sweep, EndsWhereTheBudgetEndsAndSaysSo) {
  const CostPilot fast{0, 0, 0.1, 8, 0.2, 30, 1, {}};
  const CostPilot slow{1, 0, 0.1, 8, 40.1, 25, 1, {}};
  const auto sweeps = choose_sweeps({fast, slow}, CostSettings{}, 600);
  EXPECT_EQ(sweeps.at(0).note, "");
  EXPECT_LT(sweeps.at(1).settings.back().spp, 120);
  EXPECT_NE(sweeps.at(1).note.find("35 dB may need 120 spp"), std::string::npos) << sweeps[1].note;
  double sum = 0;
  for (const auto& [pilot, sweep] : {std::pair{fast, sweeps[0]}, {slow, sweeps[1]}})
    sum += expected_seconds(pilot, sweep, CostSettings{});
  EXPECT_LE(sum, 600);
}

// Half the samples of a renderer that mostly starts save nothing, and those of a quick one nearly nothing.
TEST(Sweep, StartsOfSlowRenderersCostNoCurve) {
  const CostPilot quick{0, 0, 0.04, 8, 0.08, 25, 1, {}};
  const CostPilot slow_to_start{0, 1, 1.4, 8, 1.56, 25, 1, {}};
  const CostPilot listed{.target = 0,
                         .renderer = 2,
                         .fixed_seconds = 0.3,
                         .settings = {{"coarse", 1}},
                         .setting_seconds = {20},
                         .is_noise_free = false};
  const auto sweeps = choose_sweeps({quick, slow_to_start, listed}, {.seeds = 4}, 60);
  EXPECT_EQ(sweeps.at(0).settings.back().spp, 128);
  EXPECT_GE(sweeps.at(1).settings.back().spp, 64);
}

TEST(Sweep, SettingsAreTriedWhileTheNextFitsIntoTheBudget) {
  CostPilot pilot{
      .fixed_seconds = 0.5, .settings = {{"low", 1}, {"usual", 1}, {"fine", 1}}, .is_noise_free = true};
  const CostSettings settings{.seeds = 4};
  EXPECT_TRUE(may_try_next_setting(pilot, settings, 0));  // or nothing would be known
  pilot.setting_seconds = {1};
  EXPECT_FALSE(may_try_next_setting(pilot, settings, 5.9));  // 2 renders of 1 s and of 2 s
  EXPECT_TRUE(may_try_next_setting(pilot, settings, 6.1));
  pilot.setting_seconds = {1, 5};
  EXPECT_FALSE(may_try_next_setting(pilot, settings, 61));  // 2 renders of 1 s, 5 s and 25 s
  EXPECT_TRUE(may_try_next_setting(pilot, settings, 63));
  const auto sweep = choose_sweeps({pilot}, settings, 60).at(0);
  ASSERT_EQ(sweep.settings.size(), 2);
  EXPECT_EQ(sweep.note, "the budget ends at 'usual', 5 s a render; 'fine' would take longer");
  EXPECT_DOUBLE_EQ(expected_seconds(pilot, sweep, settings), 2 * 6 + 4 * 0.5);
}
