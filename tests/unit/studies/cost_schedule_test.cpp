#include "studies/cost/report.h"
#include "studies/cost/schedule.h"
#include "studies/cost/seeds.h"
#include "studies/cost/sweep.h"

#include <algorithm>
#include <map>
#include <set>

#include <gtest/gtest.h>

using namespace orbs::studies;

namespace {

// Three curves: the second is the cheapest, the third has no random samples.
CostRecord three_curves() {
  CostRecord record;
  record.settings.seeds = 4;
  record.targets.push_back({"t", "M1", "", 8, 8, "", {}});
  for (const char* name : {"dear", "cheap", "noise-free"}) {
    Sweep sweep{0, record.renderers.size(), {}, "", ""};
    for (const int spp : {4, 8, 16, 32}) sweep.settings.push_back({std::to_string(spp) + " spp", spp});
    sweep.is_noise_free = std::string(name) == "noise-free";
    sweep.seconds_per_sample = record.renderers.empty() ? 3 : static_cast<double>(record.renderers.size());
    record.renderers.push_back({name, "1", SweepOf::Samples, ""});
    record.sweeps.push_back(sweep);
  }
  return record;
}

// Makes renders on a made-up clock: each takes a second.
struct FakeClock {
  CostRecord& record;
  double seconds = 0;

  Ended run(const std::vector<CostTask>& tasks, double budget_seconds) {
    return make_until_spent(
        tasks, budget_seconds, [this] { return seconds; },
        [this](const CostTask& task) {
          record.renders.push_back(task.render);
          ++seconds;
          return true;
        });
  }
};

}  // namespace

TEST(Schedule, EveryCurveHasThreePointsBeforeAnyHasFour) {
  auto record = three_curves();
  std::map<std::size_t, std::set<std::string>> points;
  for (const auto& task : cost_tasks(record)) {
    if (task.render.purpose != Purpose::Sweep) continue;
    points[task.sweep].insert(task.render.setting);
    if (points[task.sweep].size() <= 3) continue;
    for (std::size_t sweep = 0; sweep < 3; ++sweep) EXPECT_GE(points[sweep].size(), 3) << sweep;
  }
  for (const auto& [sweep, settings] : points) EXPECT_EQ(settings.size(), 4) << sweep;
}

TEST(Schedule, TheCheapestCurveIsFirst) {
  std::vector<std::size_t> order;
  for (const auto& task : cost_tasks(three_curves()))
    if (task.is_first) order.push_back(task.sweep);
  order.resize(6);
  EXPECT_EQ(order, (std::vector<std::size_t>{1, 2, 0, 1, 2, 0}));
}

TEST(Schedule, EverySeedIsRenderedOnceAndNoiseFreeOnesTwice) {
  std::map<std::pair<std::size_t, std::string>, std::set<int>> seeds;
  for (const auto& task : cost_tasks(three_curves())) {
    const auto key =
        std::pair(task.sweep, std::to_string(static_cast<int>(task.render.purpose)) + task.render.setting);
    EXPECT_TRUE(seeds[key].insert(task.render.seed).second);
  }
  for (const auto& [key, own] : seeds) EXPECT_EQ(own.size(), key.first == 2 ? 2 : 4) << key.second;
}

TEST(Schedule, EndsWhenTheBudgetIsSpentAndNamesWhatIsMissing) {
  auto record = three_curves();
  FakeClock clock{record};
  const auto tasks = cost_tasks(record);
  // 3 curves, 3 points, 2 seeds, 2 fixed costs of each and 2 renders of the first renderer again.
  EXPECT_EQ(clock.run(tasks, 3 * 3 * 2 + 3 * 2 + 2), Ended::BudgetSpent);
  EXPECT_EQ(clock.seconds, 26);
  EXPECT_EQ(unmeasured_text(record, record.sweeps[1]),
            "not measured: 32 spp, 2 of 4 seeds of 4 spp, 2 of 4 seeds of 8 spp, 2 of 4 seeds of 16 spp");
  EXPECT_EQ(unmeasured_text(record, record.sweeps[2]), "not measured: 32 spp");
  EXPECT_EQ(
      unmeasured_summary(record),
      "the study ended before all was measured: of 12 settings of all curves, 3 were not rendered and 6 "
      "with fewer seeds than wanted\n");
  EXPECT_NE(cost_table(record, {}).find("noise-free on t: not measured: 32 spp\n"), std::string::npos);
  EXPECT_EQ(clock.run({}, 1e9), Ended::Done);
}

TEST(Schedule, WhatOtherWorkDisturbedIsLeftOutAndNotUnmeasured) {
  auto record = three_curves();
  FakeClock{record}.run(cost_tasks(record), 1e9);
  for (auto& render : record.renders)
    if (render.renderer == 1 && render.setting == "8 spp" && render.purpose == Purpose::Sweep) {
      render.other_share = 0.5;
      break;
    }
  EXPECT_EQ(unmeasured_text(record, record.sweeps[1]),
            "left out because of other work: 1 of 4 renders of 8 spp");
  EXPECT_EQ(unmeasured_summary(record), "");
}

// They did not store which renderer makes the same image each time.
TEST(Schedule, NothingIsSaidOfTheSeedsOfStudiesOfEarlierVersions) {
  auto record = three_curves();
  FakeClock{record}.run(cost_tasks(record), 1e9);
  for (auto& sweep : record.sweeps) sweep.is_noise_free.reset();
  for (const auto& sweep : record.sweeps) EXPECT_EQ(unmeasured_text(record, sweep), "");
}

TEST(Schedule, NothingIsMissingWhenAllIsMade) {
  auto record = three_curves();
  FakeClock clock{record};
  EXPECT_EQ(clock.run(cost_tasks(record), 1e9), Ended::Done);
  for (const auto& sweep : record.sweeps) EXPECT_EQ(unmeasured_text(record, sweep), "");
}

TEST(Schedule, TheFirstRendererIsComparedWithItselfOnEveryScene) {
  CostRecord record;
  record.settings.seeds = 2;
  record.renderers.push_back({"r", "1", SweepOf::Samples, ""});
  record.renderers.push_back({"other", "1", SweepOf::Samples, ""});
  for (std::size_t t = 0; t < 20; ++t) {
    record.targets.push_back({"t" + std::to_string(t), "M1", "", 8, 8, "", {}});
    for (const std::size_t renderer : {0U, 1U})
      record.sweeps.push_back({t, renderer, {{"4 spp", 4}, {"8 spp", 8}}, "", ""});
  }
  const auto tasks = cost_tasks(record);
  std::map<std::size_t, int> again;
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    if (tasks[i].render.purpose != Purpose::Again) continue;
    ++again[tasks[i].render.target];
    EXPECT_EQ(tasks[i].render.setting, "8 spp");
    // The two stand side by side, and take turns in being the first.
    const auto& beside = tasks[tasks[i].render.seed % 2 == 1 ? i - 1 : i + 1].render;
    EXPECT_EQ(beside.target, tasks[i].render.target);
    EXPECT_EQ(beside.setting, "8 spp");
  }
  EXPECT_EQ(again.size(), 20);
  for (const auto& [target, count] : again) EXPECT_EQ(count, 2) << target;
}

namespace {

// Forty scenes: a fast renderer, one with a slow start, and one that is swept by settings.
std::vector<CostPilot> forty_scenes() {
  std::vector<CostPilot> pilots;
  for (std::size_t target = 0; target < 40; ++target) {
    const double slowness = 1 + static_cast<double>(target % 4);
    pilots.push_back({target, 0, 0.4, 8, 0.4 + 0.1 * slowness, 25, 1, {}});
    pilots.push_back({target, 1, 0.9, 8, 0.9 + 0.2 * slowness, 25, 1, {}});
    pilots.push_back({target, 2, 0.3, 1, 0, 0, 1, {{"coarse", 1}, {"low", 1}, {"medium", 1}}});
    pilots.back().setting_seconds = {slowness, 1.5 * slowness, 2 * slowness};
    pilots.back().is_noise_free = true;
  }
  return pilots;
}

double seconds_of(const CostPilot& pilot, const CostTask& task) {
  if (task.render.purpose == Purpose::FixedCost) return pilot.fixed_seconds;
  if (!pilot.settings.empty()) return pilot.setting_seconds.at(task.setting);
  return pilot.fixed_seconds + (pilot.seconds - pilot.fixed_seconds) / pilot.spp * task.render.spp;
}

}  // namespace

TEST(Schedule, AnHourIsEnoughForFortyScenesOfThreeRenderers) {
  constexpr double kBudgetSeconds = 3600;
  constexpr double kLonger = 1.5;  // than the pilots said, because of repeats
  const auto pilots = forty_scenes();
  CostRecord record;
  record.settings.seeds = 4;
  record.renderers.resize(3);
  record.sweeps = choose_sweeps(pilots, record.settings, kBudgetSeconds);
  for (std::size_t i = 0; i < pilots.size(); ++i) {
    record.sweeps[i].is_noise_free = pilots[i].is_noise_free;
    record.sweeps[i].seconds_per_sample =
        pilots[i].settings.empty() ? (pilots[i].seconds - pilots[i].fixed_seconds) / 8 : 1;
  }
  double seconds = 0;
  make_until_spent(
      cost_tasks(record), kBudgetSeconds, [&] { return seconds; },
      [&](const CostTask& task) {
        seconds += kLonger * seconds_of(pilots.at(task.sweep), task);
        record.renders.push_back(task.render);
        return true;
      });
  EXPECT_LE(seconds, kBudgetSeconds + 60) << "the last render may end later";
  for (const auto& sweep : record.sweeps) {
    std::map<std::string, int> renders;
    for (const auto& render : record.renders)
      if (render.target == sweep.target && render.renderer == sweep.renderer &&
          render.purpose == Purpose::Sweep)
        ++renders[render.setting];
    EXPECT_GE(renders.size(), 3) << sweep.target << ' ' << sweep.renderer;
    for (std::size_t setting = 0; setting < 3; ++setting)
      EXPECT_GE(renders[sweep.settings.at(setting).name], 2) << sweep.settings[setting].name;
  }
}

TEST(Sweep, ABudgetLeavesEveryCurveThreePoints) {
  const CostPilot slow{0, 0, 0.1, 8, 40.1, 25, 1, {}};
  const auto sweeps = choose_sweeps({slow, slow}, CostSettings{}, 1);
  for (const auto& sweep : sweeps) EXPECT_GE(sweep.settings.size(), 3);
}

namespace {

// Of one renderer that takes no seed: a render is `images` images of a run.
CostRecord one_sequence(int images, const std::vector<int>& samples) {
  CostRecord record;
  record.settings.seeds = 4;
  record.targets.push_back({"t", "M1", "", 8, 8, "", {}});
  record.renderers.push_back({"r", "1", SweepOf::Samples, "", images});
  Sweep sweep{0, 0, {}, "", ""};
  for (const int spp : samples) sweep.settings.push_back({std::to_string(spp) + " spp", spp});
  record.sweeps.push_back(sweep);
  return record;
}

}  // namespace

// With n samples, the seed s of a sequence is its s-th block of n samples: nested samples are not
// independent.
TEST(Schedule, NoTwoRendersOfASequenceShareASample) {
  for (const int images : {1, 2})
    for (const auto& samples : {std::vector<int>{4, 8, 16, 32, 64}, std::vector<int>{3, 5, 6, 100}}) {
      const auto record = one_sequence(images, samples);
      const auto rule = seed_rule(record, record.sweeps[0]);
      std::vector<std::pair<int, int>> blocks;  // of samples
      const auto add = [&](int spp, int seed) {
        const int of_render = images * ((spp + images - 1) / images);
        blocks.emplace_back((seed - 1) * of_render, seed * of_render);
      };
      add(kPilotSpp, pilot_seed(rule));
      for (const auto& task : cost_tasks(record))
        if (task.render.purpose != Purpose::FixedCost) add(task.render.spp, task.render.seed);
      EXPECT_EQ(blocks.size(), 1 + 4 * samples.size() + 4);
      std::sort(blocks.begin(), blocks.end());
      for (std::size_t i = 1; i < blocks.size(); ++i) EXPECT_LE(blocks[i - 1].second, blocks[i].first) << i;
    }
}

// The images before a seed are rendered, too, and at most 100 can be asked for.
TEST(Schedule, TheSeedsOfASequenceAreSmall) {
  auto record = one_sequence(2, {4, 8, 16, 32, 64});
  int most = 0;
  for (const auto& task : cost_tasks(record)) most = std::max(most, task.render.seed);
  EXPECT_EQ(most, 12) << "the third setting begins behind four, and is rendered twice with four seeds";
  record.renderers[0].sequence_images = 0;
  for (const auto& task : cost_tasks(record)) most = std::max(most, task.render.seed);
  EXPECT_EQ(most, 8004) << "of those that have seeds, each setting has a thousand of its own";
}

TEST(Schedule, QualitiesOfASequenceAllBeginAtTheFirstImage) {
  auto record = one_sequence(1, {1, 1, 1, 257});
  record.renderers[0].sweep = SweepOf::Settings;
  for (const auto& task : cost_tasks(record))
    EXPECT_LE(task.render.seed, task.render.purpose == Purpose::Again ? 8 : 4);
}

// Two images of 1 s each are one render, and what a process renders before them counts, too.
TEST(Schedule, TheBudgetCountsTheImagesThatARenderTakes) {
  CostPilot pilot{0, 0, 0.5, 8, 2.5, 20, 1, {}};
  pilot.sequence_images = 2;
  const auto record = one_sequence(2, {8});
  const auto& sweep = record.sweeps[0];
  CostSettings settings;
  settings.seeds = 2;
  // The pilot has the first block, so the seeds are 2 and 3: the images 3 and 4, then 5 and 6, 18 in place
  // of 4.
  EXPECT_DOUBLE_EQ(images_of_setting({2, SweepOf::Samples, 2, false}, sweep, 0), 18.0 / 4);
  EXPECT_DOUBLE_EQ(expected_seconds(pilot, sweep, settings), 4 * 0.5 + 18 * 1);
  pilot.sequence_images = 0;
  EXPECT_DOUBLE_EQ(expected_seconds(pilot, sweep, settings), 4 * 0.5 + 4 * 1);
}

// 0.5 s to start, and 2 s for each of 3.5 images. Without the start, the time of one is not known.
TEST(Schedule, TheTimeOfOneImageIsItsShareOfWhatIsAboveTheFixedCost) {
  auto record = one_sequence(2, {8});
  CostRender fixed{.purpose = Purpose::FixedCost};
  fixed.cpu_seconds = 0.5;
  fixed.wall_seconds = 0.25;
  CostRender render{.setting = "8 spp", .seed = 2, .images = 3.5};
  render.cpu_seconds = 0.5 + 3.5 * 2;
  render.wall_seconds = 0.25 + 3.5 * 1;
  record.renders = {fixed, render};
  const auto one = with_times_of_one_image(record);
  ASSERT_EQ(one.renders.size(), 2);
  EXPECT_DOUBLE_EQ(one.renders[0].cpu_seconds, 0.5);
  EXPECT_DOUBLE_EQ(one.renders[1].cpu_seconds, 2.5);
  EXPECT_DOUBLE_EQ(one.renders[1].wall_seconds, 1.25);
  record.renders = {render};
  EXPECT_TRUE(with_times_of_one_image(record).renders.empty());
}
