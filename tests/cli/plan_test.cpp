// The plan of a run as a file that other machines execute.
#include "base/files.h"
#include "cli/sandbox.h"
#include "results/record.h"

#include <filesystem>

#include <gtest/gtest.h>

namespace fs = std::filesystem;
using namespace orbs;
using cli_tests::Answer;
using cli_tests::contains;
using cli_tests::replace_in;
using cli_tests::Sandbox;

namespace {

// A run whose plan.json is the plan of the tests.
Answer make_plan(const Sandbox& sandbox, const std::vector<std::string>& more = {}) {
  std::vector<std::string> words{"run", "-r", "good,noisy", "-o", "local"};
  words.insert(words.end(), more.begin(), more.end());
  return sandbox.orbs(words);
}

results::JobRecord job_of(const Sandbox& sandbox, const std::string& folder) {
  return results::read_job_file(sandbox.folder() / folder / "job.json").job;
}

}  // namespace

TEST(PlanFile, RendersEqualJobsInACopyOfTheSuiteAtAnotherPlace) {
  const Sandbox sandbox;
  make_plan(sandbox, {"--seed", "7"});
  const auto copied = sandbox.shell(
      "mkdir -p node/deeper/local && cp -r cases references configuration.json node/deeper && "
      "cp local/plan.json node/deeper/local");
  ASSERT_EQ(copied.status, 0) << copied.text;
  // The node must not look at the place where the plan was made.
  fs::rename(sandbox.folder() / "cases", sandbox.folder() / "gone");
  const auto answer = sandbox.shell(
      fmt::format("cd node && {}/orbs run --plan deeper/local/plan.json -o ../again", ORBS_BINARY_WORD));
  EXPECT_TRUE(contains(answer.text, "node/deeper/configuration.json")) << answer.text;
  for (const char* job : {"good/grey", "good/mirror", "good/v1.5", "noisy/grey"}) {
    const auto here = job_of(sandbox, std::string("local/") + job);
    const auto there = job_of(sandbox, std::string("again/") + job);
    EXPECT_EQ(there.identity.id, here.identity.id);
    EXPECT_EQ(there.identity.seed, 7);
    EXPECT_EQ(there.program.argv, here.program.argv);
    EXPECT_EQ(there.hashes.scene, here.hashes.scene);
    EXPECT_EQ(there.hashes.image, here.hashes.image);
  }
  EXPECT_FALSE(contains(sandbox.read("local/plan.json"), sandbox.folder().string()));
}

TEST(PlanFile, ItsSettingsAreThoseOfItsShards) {
  const Sandbox sandbox;
  make_plan(sandbox, {"--seed", "9", "--spp-scale", "2", "--size", "1/2", "--no-log"});
  replace_in(sandbox, "configuration.json", R"("defaults": {)",
             R"("defaults": {"seed": 3, "spp_scale": 4, )");
  for (const char* shard : {"1/2", "2/2"})
    sandbox.orbs(
        {"run", "--plan", "local/plan.json", "--shard", shard, "-o", fmt::format("part-{}", shard[0])});
  const auto folder = sandbox.has("part-1/good/grey") ? "part-1/good/grey" : "part-2/good/grey";
  const auto job = job_of(sandbox, folder);
  EXPECT_EQ(job.identity.seed, 9);
  EXPECT_EQ(job.identity.spp, 16);
  EXPECT_FALSE(sandbox.has(std::string(folder) + "/log.txt"));
  EXPECT_EQ(results::read_results_file(sandbox.folder() / "part-1/results.json").size, "1/2");
  const auto merged = sandbox.orbs({"merge", "part-1", "part-2", "-o", "merged"});
  EXPECT_TRUE(sandbox.has("merged/results.json")) << merged.text;
  EXPECT_EQ(sandbox.read("merged/plan.json"), sandbox.read("local/plan.json"));
}

TEST(PlanFile, RefusesWhatHasChangedSinceItWasMade) {
  const Sandbox sandbox;
  make_plan(sandbox);
  const auto plan = sandbox.read("local/plan.json");
  const auto refused = [&](const std::string& reason) {
    const auto answer = sandbox.orbs({"run", "--plan", "local/plan.json", "-o", "again"});
    EXPECT_EQ(answer.status, 2) << answer.text;
    EXPECT_TRUE(contains(answer.text, "what the plan was made of has changed since: " + reason))
        << answer.text;
    EXPECT_FALSE(sandbox.has("again"));
  };
  replace_in(sandbox, "cases/m1_grey/grey.json", "[0,4,1]", "[0,5,1]");
  refused("scene 'grey', or a file that it names");
  replace_in(sandbox, "cases/m1_grey/grey.json", "[0,5,1]", "[0,4,1]");
  replace_in(sandbox, "local/plan.json", R"("orbs_version": ")", R"("orbs_version": "old )");
  refused("orbs, which was old");
  sandbox.write("local/plan.json", plan);
  const auto program = plan.find("\"program\": \"") + 12;
  sandbox.write("local/plan.json", std::string(plan).replace(program, 4, "0000"));
  refused("the program of renderer 'good'");
  sandbox.write("local/plan.json", plan);
  replace_in(sandbox, "cases/m1_grey/case.json", R"("tests": "t")", R"("tests": "another")");
  refused("case 'm1_grey'");
}

TEST(PlanFile, IsExecutedAsItIs) {
  const Sandbox sandbox;
  make_plan(sandbox);
  for (const char* option : {"--seed", "--threads", "--spp-scale"}) {
    const auto answer = sandbox.orbs({"run", "--plan", "local/plan.json", option, "2", "-o", "again"});
    EXPECT_EQ(answer.status, 2);
    EXPECT_TRUE(contains(answer.text, "is part of the plan")) << answer.text;
  }
  EXPECT_EQ(sandbox.orbs({"run", "--plan", "local/plan.json", "-s", "grey"}).status, 2);
  EXPECT_TRUE(contains(sandbox.orbs({"run", "--plan", "nowhere.json"}).text, "nowhere.json"));
}

TEST(PlanFile, KeepsTheProgramThatWasNamed) {
  const Sandbox sandbox;
  fs::copy_file(fs::path(ORBS_BINARY_DIR) / "orbs-fake-renderer", sandbox.folder() / "mine");
  sandbox.orbs({"run", "-r", "good", "-s", "grey", "-e", "./mine", "-o", "local"});
  for (const auto& answer : {sandbox.orbs({"run", "--plan", "local/plan.json", "-o", "again"}),
                             sandbox.orbs({"run", "--resume", "local"})}) {
    EXPECT_EQ(answer.status, 0) << answer.text;
    EXPECT_FALSE(contains(answer.text, "has changed")) << answer.text;
  }
  EXPECT_EQ(job_of(sandbox, "again/good/grey").program.argv, job_of(sandbox, "local/good/grey").program.argv);
  EXPECT_TRUE(job_of(sandbox, "local/good/grey").program.argv.at(0).ends_with("/mine"));
}

// Each shard would make a plan of its own from what has changed.
TEST(PlanFile, AShardIsNotPlannedAgainWhenItIsResumed) {
  const Sandbox sandbox;
  sandbox.orbs({"run", "-r", "good", "--shard", "1/2", "-o", "part"});
  replace_in(sandbox, "cases/m1_grey/case.json", R"("tests": "t")", R"("tests": "another")");
  const auto answer = sandbox.orbs({"run", "--resume", "part"});
  EXPECT_EQ(answer.status, 2);
  EXPECT_TRUE(contains(answer.text, "has changed since")) << answer.text;
}

TEST(PlanFile, OfAnotherVersionIsRefused) {
  const Sandbox sandbox;
  make_plan(sandbox);
  replace_in(sandbox, "local/run.json", "orbs-run/2", "orbs-run/1");
  const auto answer = sandbox.orbs({"run", "--resume", "local"});
  EXPECT_EQ(answer.status, 2);
  EXPECT_TRUE(contains(answer.text, "another version of orbs wrote it")) << answer.text;
}
