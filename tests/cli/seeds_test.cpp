// Renderers that do not know their noise: it is known from the scatter of several seeds.
#include "metrics/seeds.h"

#include "cli/sandbox.h"
#include "image/image_io.h"
#include "results/record.h"

#include <gtest/gtest.h>

using namespace orbs;
using cli_tests::contains;
using cli_tests::Sandbox;

namespace {

results::JobRecord job_of(const Sandbox& sandbox, const std::string& renderer) {
  return results::read_job_file(sandbox.folder() / "out" / renderer / "grey" / "job.json").job;
}

}  // namespace

// 8 samples of +-0.2 have a standard error of 0.07 around the grey of the reference: 20 dB.
TEST(Seeds, ANoisyImageIsInconclusiveAndSaysWhatItNeeds) {
  const Sandbox sandbox;
  const auto answer = sandbox.orbs({"run", "-v", "-r", "noisy", "-s", "grey", "-o", "out"});
  EXPECT_TRUE(contains(answer.text, "but noise alone gives")) << answer.text;
  EXPECT_TRUE(contains(answer.text, "times the samples")) << answer.text;
  const auto image = image::read_image(sandbox.folder() / "out/noisy/grey/result.exr");
  EXPECT_GE(image::channel_index(image, "variance.G"), 0);
}

TEST(Seeds, AWrongImageFailsHoweverNoisyItIs) {
  const Sandbox sandbox;
  const auto answer = sandbox.orbs({"run", "-r", "noisy-dark", "-s", "grey", "-o", "out"});
  EXPECT_EQ(answer.status, 1);
  EXPECT_TRUE(contains(answer.text, "fail")) << answer.text;
  EXPECT_FALSE(contains(answer.text, "but noise alone gives")) << answer.text;
}

// The case asks for 8 samples: 2 for each of 4 seeds.
TEST(Seeds, ShareTheSamplesAndAddUpTheirTimes) {
  const Sandbox sandbox;
  const auto dry = sandbox.orbs({"run", "-r", "noisy", "-s", "grey", "--dry-run"});
  for (const char* seed : {"--spp 2 --seed 1", "--spp 2 --seed 2", "--spp 2 --seed 3", "--spp 2 --seed 4"})
    EXPECT_TRUE(contains(dry.text, seed)) << dry.text;
  EXPECT_FALSE(contains(dry.text, "--seed 5")) << dry.text;
  sandbox.orbs({"run", "-r", "noisy", "-s", "grey", "-o", "out"});
  const auto job = job_of(sandbox, "noisy");
  EXPECT_EQ(job.identity.spp, 8);
  EXPECT_EQ(job.identity.seeds, 4);
  EXPECT_EQ(job.cost.render_seconds, 4 * 0.25);
  EXPECT_TRUE(contains(job.program.shell, "--seed 4")) << job.program.shell;
  EXPECT_FALSE(sandbox.has("out/noisy/grey/seed-1.exr"));
  const auto log = sandbox.read("out/noisy/grey/log.txt");
  std::size_t said = 0;
  for (auto at = log.find("render_seconds"); at != std::string::npos; at = log.find("render_seconds", at + 1))
    ++said;
  EXPECT_EQ(said, 4U) << log;
}

TEST(Seeds, ABadImageOfOneOfThemIsTheVerdict) {
  const Sandbox sandbox;
  const auto answer = sandbox.orbs({"run", "-r", "noisy-nan", "-s", "grey", "-o", "out"});
  EXPECT_EQ(answer.status, 1);
  const auto job = job_of(sandbox, "noisy-nan");
  EXPECT_EQ(job.end.outcome, results::JobOutcome::InvalidPixels);
  EXPECT_TRUE(contains(job.end.reason, "1 pixels are NaN")) << job.end.reason;
  EXPECT_TRUE(contains(job.files.image, "seed-2.exr")) << job.files.image;
  EXPECT_FALSE(sandbox.has("out/noisy-nan/grey/result.exr"));
}

// A renderer that ignores its seed, or a scene without noise: nothing is known, and nothing is made up.
TEST(Seeds, EqualImagesHaveNoVariance) {
  const auto grey = image::make_image(3, 2, {"R", "G", "B"});
  auto other = grey;
  EXPECT_TRUE(metrics::are_equal({grey, grey}));
  other.at(1, 1, 2) = 1e-7F;
  EXPECT_FALSE(metrics::are_equal({grey, other}));
}
