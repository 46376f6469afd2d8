// Sequential verdicts: a render gets samples until its targets are decided.
#include "cli/sandbox.h"
#include "image/image_io.h"
#include "results/record.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

using namespace orbs;
using namespace orbs::cli_tests;

namespace {

class LooksSandbox : public Sandbox {
 public:
  LooksSandbox() {
    replace_in(*this, "configuration.json", "\"fixed_samples\": true", "\"fixed_samples\": false");
  }
  results::JobFile job(const std::string& run, const std::string& renderer) const {
    return results::read_job_file(folder() / run / renderer / "grey" / "job.json");
  }
};

}  // namespace

// A sample is off by 0.2 around 0.5: 96 pixels of n samples leave 0.04 / sqrt(n) of their mean, and a pass
// needs 0.0019 of it, which are 480 samples, or 512. The case asks for 8 of them.
TEST(Looks, ANoisyImageGetsTheSamplesThatDecideIt) {
  const LooksSandbox sandbox;
  const auto answer = sandbox.orbs({"run", "-r", "noisy", "-s", "grey", "-c", "m1*", "-o", "out"});
  EXPECT_EQ(answer.status, 0) << answer.text;
  const auto [job, targets] = sandbox.job("out", "noisy");
  EXPECT_GE(job.identity.spp, 512);
  EXPECT_LE(job.identity.spp, 2048);
  EXPECT_EQ(job.sampling.end, "decided");
  ASSERT_EQ(targets.size(), 1U);
  ASSERT_EQ(targets[0].looks.size(), static_cast<std::size_t>(job.sampling.looks));
  EXPECT_EQ(targets[0].looks.front().spp, 16);
  EXPECT_EQ(targets[0].looks.front().verdict, results::Verdict::Inconclusive);
  EXPECT_TRUE(results::passes(targets[0].looks.back().verdict));
  // Its line and the table show the image's own PSNR. It meets the gate with its noise: nothing stands beside
  // it.
  const auto own = fmt::format("{:.2f}", *results::psnr_db(targets[0]));
  EXPECT_TRUE(contains(answer.text, own + " dB")) << answer.text;
  EXPECT_TRUE(contains(answer.text, own + " pass")) << answer.text;
  EXPECT_FALSE(contains(answer.text, "without noise")) << answer.text;
  const auto image = image::read_image(sandbox.folder() / "out/noisy/grey/result.exr");
  double mean = 0;
  for (std::size_t pixel = 0; pixel < image.pixel_count(); ++pixel)
    mean += static_cast<double>(image.at(static_cast<int>(pixel % 12), static_cast<int>(pixel / 12), 0)) / 96;
  EXPECT_NEAR(mean, 0.5, 0.004);
}

// By its mean, which is certain when a few looks agree on what noise does to it.
TEST(Looks, AWrongImageIsRefusedSoon) {
  const LooksSandbox sandbox;
  const auto answer = sandbox.orbs({"run", "-r", "noisy-dark", "-s", "grey", "-c", "m1*", "-o", "out"});
  EXPECT_EQ(answer.status, 1) << answer.text;
  const auto [job, targets] = sandbox.job("out", "noisy-dark");
  EXPECT_LE(job.sampling.looks, 5);
  EXPECT_EQ(targets.at(0).verdict, results::Verdict::Fail) << targets.at(0).reason;
}

TEST(Looks, FixedSamplesAreThoseOfTheCase) {
  const LooksSandbox sandbox;
  const auto answer = sandbox.orbs({"run", "-r", "noisy", "-s", "grey", "--fixed-samples", "-o", "out"});
  EXPECT_EQ(answer.status, 1) << answer.text;
  const auto [job, targets] = sandbox.job("out", "noisy");
  EXPECT_EQ(job.identity.spp, 8);
  EXPECT_EQ(job.sampling.looks, 0);
  EXPECT_TRUE(targets.at(0).looks.empty());
}

// What the budget ends says what it needs, and goes on from there when it gets more.
TEST(Looks, ABudgetEndsThemAndAResumedRunGoesOn) {
  const LooksSandbox sandbox;
  const auto few = sandbox.orbs(
      {"run", "-v", "-r", "noisy", "-s", "grey", "-c", "m1*", "--target-budget", "0.000002m", "-o", "out"});
  EXPECT_EQ(few.status, 1) << few.text;
  EXPECT_TRUE(contains(few.text, "undecided: its noise: about")) << few.text;
  EXPECT_EQ(sandbox.job("out", "noisy").job.sampling.looks, 1);
  EXPECT_EQ(sandbox.job("out", "noisy").job.sampling.end, "budget");
  const auto rest = sandbox.orbs({"run", "--resume", "out"});
  EXPECT_EQ(rest.status, 0) << rest.text;
  ASSERT_EQ(sandbox.orbs({"run", "-r", "noisy", "-s", "grey", "-c", "m1*", "-o", "whole"}).status, 0);
  EXPECT_EQ(sandbox.job("out", "noisy").targets.at(0).looks.size(),
            sandbox.job("whole", "noisy").targets.at(0).looks.size());
  for (const char* file : {"result.exr", "halves.exr"})
    EXPECT_EQ(sandbox.read(std::string("out/noisy/grey/") + file),
              sandbox.read(std::string("whole/noisy/grey/") + file))
        << file;
}

// Both scenes have the noise of the same seeds, so it is not in their difference.
TEST(Looks, ADifferenceGetsThemForBothOfItsScenes) {
  const LooksSandbox sandbox;
  const auto answer = sandbox.orbs({"run", "-r", "noisy", "-c", "m3*", "-o", "out"});
  const auto run = results::read_results_file(sandbox.folder() / "out/results.json");
  for (const auto& target : run.targets) {
    EXPECT_NE(target.verdict, results::Verdict::Inconclusive) << target.target << ": " << target.reason;
    EXPECT_FALSE(target.looks.empty()) << target.target;
  }
}

// More seeds are no more samples for it: the two renders are equal.
TEST(Looks, ARendererThatIgnoresItsSeedRendersAllSamplesAtOnce) {
  const LooksSandbox sandbox;
  const auto answer = sandbox.orbs({"run", "-r", "good", "-s", "grey", "-c", "m1*", "-o", "out"});
  EXPECT_EQ(answer.status, 0) << answer.text;
  const auto [job, targets] = sandbox.job("out", "good");
  EXPECT_EQ(job.sampling.looks, 0);
  EXPECT_EQ(job.identity.spp, 8);
  EXPECT_TRUE(targets.at(0).looks.empty());
}

// The first thing to say of it, since all that is said of noise would mislead.
TEST(Looks, EqualRendersAreSaidFirst) {
  const LooksSandbox sandbox;
  const auto answer = sandbox.orbs({"run", "-v", "-r", "dark", "-s", "grey", "-c", "m1*", "-o", "out"});
  EXPECT_EQ(answer.status, 1) << answer.text;
  const auto [job, targets] = sandbox.job("out", "dark");
  EXPECT_TRUE(targets.at(0).reason.starts_with("renders with different seeds are equal to the bit"))
      << targets.at(0).reason;
  EXPECT_TRUE(job.sampling.has_equal_seeds);
}
