#include "run/looks.h"

#include <limits>
#include <set>

#include <gtest/gtest.h>

using namespace orbs;
using namespace orbs::run;

namespace {

registry::Renderer seeded() {
  registry::Renderer renderer;
  renderer.command.words = {"r", "{spp}", "{seed}"};
  return renderer;
}

judge::Look open_look(double samples, double at_best) {
  judge::Look look;
  look.is_open = true;
  look.need = {samples, at_best};
  return look;
}

}  // namespace

TEST(Looks, BeginWithAQuarterOfTheCaseAsAPowerOfTwo) {
  const Plan plan;
  auto renderer = seeded();
  EXPECT_EQ(first_look_spp(plan, renderer, 1), 16);
  EXPECT_EQ(first_look_spp(plan, renderer, 127), 16);
  EXPECT_EQ(first_look_spp(plan, renderer, 128), 32);
  EXPECT_EQ(first_look_spp(plan, renderer, 1000), 128);
  renderer.sampling.least_spp = 48;
  EXPECT_EQ(first_look_spp(plan, renderer, 128), 128) << "two renders of 64";
}

TEST(Looks, AreNotTakenWhereMoreRendersAreNoMoreSamples) {
  Plan plan;
  auto renderer = seeded();
  renderer.sampling.is_noise_free = true;
  EXPECT_EQ(first_look_spp(plan, renderer, 128), 0);
  renderer = seeded();
  renderer.sampling.has_fixed_samples = true;
  EXPECT_EQ(first_look_spp(plan, renderer, 128), 0);
  renderer = seeded();
  renderer.command.words = {"r", "{spp}"};
  EXPECT_EQ(first_look_spp(plan, renderer, 128), 0);
  plan.settings.fixed_samples = true;
  EXPECT_EQ(first_look_spp(plan, seeded(), 128), 0);
}

// Sum over all looks: no seed twice, each look as many samples as are there, and none of a reference.
TEST(Looks, DoubleTheSamplesAndUseNoSeedTwice) {
  PlannedJob job;
  job.first_spp = 32;
  std::set<int> seeds;
  int samples = 0;
  for (int looks = 0; looks < kMostLooks; ++looks) {
    EXPECT_EQ(samples, samples_after(job, looks));
    const auto look = next_look(job, looks, 1);
    for (const int seed : look.seeds) {
      EXPECT_TRUE(seeds.insert(seed).second);
      EXPECT_GE(seed, 1);
      EXPECT_LE(seed, 2048);
    }
    samples += 2 * look.spp;
  }
  EXPECT_EQ(samples, 32 << (kMostLooks - 1));
  EXPECT_NE(next_look(job, 0, 1).seeds, next_look(job, 0, 2).seeds);
}

// With n samples, the seed s is the s-th block of n samples of one sequence. No sample is rendered twice.
TEST(Looks, OfAnImageSequenceGoOnWhereTheLastOneEnded) {
  Plan plan;
  plan.renderers.emplace_back();
  auto& command = plan.renderers[0].entry.command;
  command.words = {"r", "{spp}", "{images}"};
  EXPECT_EQ(first_look_spp(plan, plan.renderers[0].entry, 128), 0);
  command.sequence.words = {"-cam_id", "0"};
  EXPECT_EQ(first_look_spp(plan, plan.renderers[0].entry, 128), 32);
  PlannedJob job;
  job.first_spp = 32;
  int samples = 0;
  for (int looks = 0; looks < kMostLooks; ++looks) {
    const auto look = next_look(plan, job, looks);
    for (const int seed : look.seeds) {
      EXPECT_EQ((seed - 1) * look.spp, samples);
      EXPECT_LE(seed, 4);
      samples += look.spp;
    }
  }
  plan.settings.seed = 2;
  EXPECT_EQ(next_look(plan, job, 1).seeds, (std::array<int, 2>{7, 8}));
  command.sequence.words.clear();
  EXPECT_EQ(next_look(plan, job, 1).seeds, next_look(job, 1, 2).seeds);
}

TEST(Looks, EndWhenDecidedOrBeyondTheBudget) {
  EXPECT_EQ(end_after({}, 1, 1, 100).name, "decided");
  EXPECT_EQ(end_after(open_look(4, 1), 1, 10, 100).name, "");
  // The next look takes as long as all before.
  EXPECT_EQ(end_after(open_look(4, 1), 1, 51, 100).name, "budget");
  // 21 times as long, at best: told at the third look.
  EXPECT_EQ(end_after(open_look(40, 21), 2, 10, 100).name, "");
  EXPECT_EQ(end_after(open_look(40, 21), 3, 10, 100).name, "budget");
  EXPECT_EQ(end_after(open_look(40, 21), 3, 10, 100).text,
            "its noise: about 40 times the samples (7 min) would decide it");
  EXPECT_EQ(end_after(open_look(4, 1), kMostLooks, 1, 100).name, "looks");
  auto look = open_look(4, 1);
  look.need.is_edge = true;
  EXPECT_EQ(end_after(look, 1, 1, 100).name, "edge");
  look = open_look(std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity());
  look.need.is_reference = true;
  EXPECT_EQ(end_after(look, 2, 1, 100).name, "");
  EXPECT_EQ(end_after(look, 3, 1, 100).name, "reference");
}

TEST(Looks, ATargetsBudgetGrowsWithTheImage) {
  registry::RunSettings settings;
  settings.size_divisor = registry::QuarterSize;
  EXPECT_EQ(target_budget_seconds(settings), 120);
  settings.size_divisor = registry::EighthSize;
  EXPECT_EQ(target_budget_seconds(settings), 120);
  settings.size_divisor = registry::FullSize;
  EXPECT_EQ(target_budget_seconds(settings), 16 * 120);
  settings.target_budget_seconds = 7;
  EXPECT_EQ(target_budget_seconds(settings), 7);
}

TEST(Looks, TheFirstGuessIsTheNearestPowerOfTwo) {
  PlannedJob job;
  for (const auto& [spp, guess] : {std::pair{1, 1}, {160, 128}, {182, 256}, {256, 256}, {56, 64}}) {
    job.spp = spp;
    EXPECT_EQ(first_guess_spp(job), guess) << spp;
  }
}
