#include "run/looks.h"

#include <array>
#include <limits>
#include <memory>
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

TEST(Looks, BeginWithFewSamples) {
  const Plan plan;
  auto renderer = seeded();
  EXPECT_EQ(first_look_spp(plan, renderer), 16);
  renderer.sampling.least_spp = 48;
  EXPECT_EQ(first_look_spp(plan, renderer), 128) << "two renders of 64";
}

TEST(Looks, AreNotTakenWhereMoreRendersAreNoMoreSamples) {
  Plan plan;
  auto renderer = seeded();
  renderer.sampling.is_noise_free = true;
  EXPECT_EQ(first_look_spp(plan, renderer), 0);
  renderer = seeded();
  renderer.sampling.has_fixed_samples = true;
  EXPECT_EQ(first_look_spp(plan, renderer), 0);
  renderer = seeded();
  renderer.command.words = {"r", "{spp}"};
  EXPECT_EQ(first_look_spp(plan, renderer), 0);
  plan.settings.fixed_samples = true;
  EXPECT_EQ(first_look_spp(plan, seeded()), 0);
}

namespace {

Plan plan_of(const registry::Renderer& renderer, int side_px) {
  Plan plan;
  plan.renderers.emplace_back();
  plan.renderers[0].entry = renderer;
  auto scene = std::make_shared<scene::Scene>();
  scene->camera.width_px = scene->camera.height_px = side_px;
  plan.scenes.push_back({.name = "a", .file = {}, .scene = scene});
  return plan;
}

PlannedJob job_from(int first_spp) {
  PlannedJob job;
  job.first_spp = first_spp;
  return job;
}

}  // namespace

// Each look as many samples as are there: no seed twice, and none of a reference.
TEST(Looks, DoubleTheSamplesAndUseNoSeedTwice) {
  const auto plan = plan_of(seeded(), 64);
  const auto job = job_from(32);
  std::set<int> seeds;
  int samples = 0;
  for (int looks = 0; looks < kMostLooks; ++looks) {
    const int after = looks == 0 ? 32 : samples_after_next(plan, job, looks, samples, {2, 1});
    const auto look = next_look(plan, job, looks, samples, after);
    for (const int seed : look.seeds) {
      EXPECT_TRUE(seeds.insert(seed).second);
      EXPECT_GE(seed, 1);
      EXPECT_LE(seed, 2048);
    }
    samples += 2 * look.spp;
    EXPECT_EQ(samples, after);
  }
  EXPECT_EQ(samples, 32 << (kMostLooks - 1));
  auto other = plan;
  other.settings.seed = 2;
  EXPECT_NE(first_look(plan, job).seeds, first_look(other, job).seeds);
}

// What is needed at best is rendered at once, up to 16 times what is there.
TEST(Looks, GoAsFarAsIsNeededAtBest) {
  const auto plan = plan_of(seeded(), 64);
  const auto job = job_from(16);
  EXPECT_EQ(samples_after_next(plan, job, 1, 16, {2, 0.5}), 32);
  EXPECT_EQ(samples_after_next(plan, job, 1, 16, {2, 3.9}), 32);
  EXPECT_EQ(samples_after_next(plan, job, 1, 16, {2, 4}), 64);
  EXPECT_EQ(samples_after_next(plan, job, 1, 16, {2, 15}), 128);
  EXPECT_EQ(samples_after_next(plan, job, 1, 16, {2, 1e9}), 256);
  EXPECT_EQ(next_look(plan, job, 1, 16, 256).spp, 120);
}

// Long renders that are nearly decided: in two steps what doubling takes in one, so never more samples.
TEST(Looks, TakeHalfAsManyAgainWhereThatIsLikelyToDo) {
  const auto plan = plan_of(seeded(), 64);
  const auto job = job_from(16);
  EXPECT_EQ(samples_after_next(plan, job, 1, 4096, {1.2, 1}), 6144);
  EXPECT_EQ(samples_after_next(plan, job, 1, 6144, {1.2, 1}), 8192);
  EXPECT_EQ(samples_after_next(plan, job, 1, 6144, {9, 9}), 8192);
  EXPECT_EQ(samples_after_next(plan, job, 1, 4096, {1.6, 1}), 8192);
  EXPECT_EQ(samples_after_next(plan, job, 1, 64, {1.2, 1}), 128) << "what starts twice for little";
}

// With n samples, the seed s is the s-th block of n samples of one sequence. No sample is rendered twice.
TEST(Looks, OfAnImageSequenceGoOnWhereTheLastOneEnded) {
  registry::Renderer renderer;
  renderer.command.words = {"r", "{spp}", "{images}"};
  EXPECT_EQ(first_look_spp({}, renderer), 0);
  renderer.command.sequence.words = {"-cam_id", "0"};
  EXPECT_EQ(first_look_spp({}, renderer), 16);
  auto plan = plan_of(renderer, 64);
  const auto job = job_from(32);
  int samples = 0;
  for (int looks = 0; looks < kMostLooks; ++looks) {
    const int after = looks == 0 ? 32 : samples_after_next(plan, job, looks, samples, {1, 100});
    const auto look = next_look(plan, job, looks, samples, after);
    for (const int seed : look.seeds) {
      EXPECT_EQ((seed - 1) * look.spp, samples);
      EXPECT_LE(seed, 4);
      samples += look.spp;
    }
  }
  plan.settings.seed = 2;
  EXPECT_EQ(next_look(plan, job, 1, 32, 64).seeds, (std::array<int, 2>{7, 8}));
}

// What a clock says differs from machine to machine; what a scene needs does not.
TEST(Looks, EndByTheirSamples) {
  const auto after = [](const judge::Look& look, int looks, int spp) {
    return end_after(look, {.looks = looks, .spp = spp, .most_spp = 4096, .seconds = 1e9}).name;
  };
  EXPECT_EQ(after({}, 1, 16), "decided");
  EXPECT_EQ(after(open_look(4, 1), 1, 16), "");
  EXPECT_EQ(after(open_look(4, 1), 8, 2048), "");
  EXPECT_EQ(after(open_look(4, 1), 9, 4096), "looks");
  EXPECT_EQ(after(open_look(4, 1), kMostLooks, 16), "looks");
  // Far beyond even at best: told at the third look, or at once where it is out of all bounds.
  EXPECT_EQ(after(open_look(4000, 2000), 2, 16), "");
  EXPECT_EQ(after(open_look(4000, 2000), 3, 16), "looks");
  EXPECT_EQ(after(open_look(1e9, 1e8), 1, 16), "looks");
  auto look = open_look(4, 1);
  look.need.is_edge = true;
  EXPECT_EQ(after(look, 1, 16), "edge");
  look = open_look(std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity());
  look.need.is_reference = true;
  EXPECT_EQ(after(look, 3, 16), "reference");
}

TEST(Looks, EndByTheTimeThatTheUserSets) {
  LooksSoFar progress{
      .looks = 1, .spp = 16, .most_spp = 16, .seconds = 10, .pace = {0, 10.0 / 16}, .budget_seconds = 100};
  EXPECT_EQ(end_after(open_look(4, 1), progress).name, "") << "the usual number of samples is no limit then";
  progress.seconds = 95;
  EXPECT_EQ(end_after(open_look(4, 1), progress).name, "budget");
  progress.seconds = 10;
  progress.looks = 3;
  EXPECT_EQ(end_after(open_look(40, 21), progress).name, "budget");
  EXPECT_EQ(end_after(open_look(40, 21), progress).text,
            "its noise: about 40 times the samples (7 min) would decide it");
}

// Four minutes' worth of starts are no rate: two looks of unlike length tell the two apart.
TEST(Looks, TellTheStartOfARendererFromItsRate) {
  const auto pace = pace_of({2.0, 16}, {2.5, 112});
  EXPECT_NEAR(pace.seconds_per_spp, 0.5 / 96, 1e-12);
  EXPECT_NEAR(seconds_for(pace, 112), 2.5, 1e-12);
  EXPECT_EQ(seconds_for(pace_of({}, {2, 16}), 32), 4) << "one look: all of it may be samples";
  EXPECT_EQ(seconds_for(pace_of({2, 16}, {1.5, 32}), 64), 3) << "a disturbed one";
}

TEST(Looks, SmallImagesGetMoreSamples) {
  const auto job = job_from(16);
  EXPECT_EQ(most_spp(plan_of(seeded(), 512), job), 4096);
  EXPECT_EQ(most_spp(plan_of(seeded(), 128), job), 16384);
  EXPECT_EQ(most_spp(plan_of(seeded(), 32), job), 262144);
}

// At 1/8 of 256 px the samples of twelve looks that double were an eighth of the paths of full size, and some
// ended with "12 looks have not decided it".
TEST(Looks, ReachTheirMostSamplesByTheLast) {
  const auto job = job_from(16);
  for (const int side : {16, 32, 64, 512}) {
    const auto plan = plan_of(seeded(), side);
    int samples = 16;
    for (int looks = 1; looks < kMostLooks; ++looks)
      if (samples < most_spp(plan, job)) samples = samples_after_next(plan, job, looks, samples, {2, 1});
    EXPECT_GE(samples, most_spp(plan, job)) << side << " px";
  }
}

TEST(Looks, TheFirstGuessIsTheNearestPowerOfTwo) {
  PlannedJob job;
  for (const auto& [spp, guess] : {std::pair{1, 1}, {160, 128}, {182, 256}, {256, 256}, {56, 64}}) {
    job.spp = spp;
    EXPECT_EQ(first_guess_spp(job), guess) << spp;
  }
}
