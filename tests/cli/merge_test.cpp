// Shards of a run, and what orbs merge makes of them.
#include "base/text.h"
#include "cli/sandbox.h"

#include <filesystem>
#include <regex>

#include <gtest/gtest.h>

namespace fs = std::filesystem;
using orbs::cli_tests::contains;
using orbs::cli_tests::replace_in;
using orbs::cli_tests::Sandbox;

namespace {

// "noisy" has no difference that passes, "good" has one; both have three scenes.
std::vector<std::string> run(const std::vector<std::string>& more) {
  std::vector<std::string> words{"run", "-r", "good,noisy,wrong-size", "--seed", "7"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

void run_shards(const Sandbox& sandbox, int count) {
  for (int i = 1; i <= count; ++i)
    sandbox.orbs(run({"--shard", fmt::format("{}/{}", i, count), "-o", fmt::format("part-{}", i)}));
}

// What differs between two equal runs: times, loads and the memory that was used, dates, the command.
std::string without_times(std::string text, const std::string& folder) {
  for (auto at = text.find(folder); at != std::string::npos; at = text.find(folder))
    text.replace(at, folder.size(), "FOLDER");
  static const std::regex lines(
      R"re(\n *"(started|load|wall_seconds|cpu_seconds|peak_rss_bytes|user_seconds)": [^\n]*)re");
  text = std::regex_replace(text, lines, "");
  static const std::regex command(R"re("command_line": \[[^\]]*\])re");
  return std::regex_replace(text, command, "");
}

}  // namespace

TEST(Merge, OfAllShardsIsTheLocalRunToTheBitButForTimes) {
  const Sandbox sandbox;
  const auto local = sandbox.orbs(run({"-o", "local"}));
  run_shards(sandbox, 3);
  const auto merged = sandbox.orbs({"merge", "part-3", "part-1", "part-2", "-o", "merged"});
  EXPECT_EQ(merged.status, local.status) << merged.text;
  EXPECT_EQ(without_times(sandbox.read("merged/results.json"), (sandbox.folder() / "merged").string()),
            without_times(sandbox.read("local/results.json"), (sandbox.folder() / "local").string()));
  int images = 0;
  for (const auto& entry : fs::recursive_directory_iterator(sandbox.folder() / "local")) {
    if (!entry.is_regular_file()) continue;
    const auto file = entry.path().lexically_relative(sandbox.folder() / "local").string();
    EXPECT_TRUE(sandbox.has("merged/" + file)) << file;
    if (!file.ends_with(".exr") && !file.ends_with(".png")) continue;
    ++images;
    EXPECT_EQ(sandbox.read("merged/" + file), sandbox.read("local/" + file)) << file;
  }
  EXPECT_GT(images, 20);
}

TEST(Merge, ShardsRenderEachJobOnce) {
  const Sandbox sandbox;
  run_shards(sandbox, 3);
  std::size_t jobs = 0;
  for (const char* part : {"part-1", "part-2", "part-3"})
    for (const auto& entry : fs::recursive_directory_iterator(sandbox.folder() / part))
      if (entry.path().filename() == "job.json") ++jobs;
  EXPECT_EQ(jobs, 9U);
}

TEST(Merge, NamesWhatIsMissingAndResumeCompletesIt) {
  const Sandbox sandbox;
  const auto local = sandbox.orbs(run({"-o", "local"}));
  run_shards(sandbox, 2);
  const auto half = sandbox.orbs({"merge", "part-2", "-o", "merged"});
  EXPECT_EQ(half.status, 2);
  EXPECT_TRUE(contains(half.text, "the runs lack (")) << half.text;
  EXPECT_TRUE(contains(half.text, ": not rendered (job ")) << half.text;
  EXPECT_FALSE(sandbox.has("merged"));
  // What a killed run leaves: records of all renders, and no folder of the one that was running.
  fs::remove_all(sandbox.folder() / "part-1" / "noisy" / "v1.5");
  fs::remove_all(sandbox.folder() / "part-2" / "noisy" / "v1.5");
  for (const char* part : {"part-1", "part-2"}) sandbox.orbs({"run", "--resume", part});
  EXPECT_EQ(sandbox.orbs({"merge", "part-1", "part-2", "-o", "merged"}).status, local.status);
}

TEST(Merge, RefusesShardsOfAnotherPlan) {
  const Sandbox sandbox;
  sandbox.orbs(run({"--shard", "1/2", "-o", "part-1"}));
  sandbox.orbs({"run", "-r", "good,noisy,wrong-size", "--seed", "8", "--shard", "2/2", "-o", "part-2"});
  const auto answer = sandbox.orbs({"merge", "part-1", "part-2"});
  EXPECT_EQ(answer.status, 2);
  EXPECT_TRUE(contains(answer.text, "is of another plan than")) << answer.text;
}

TEST(Merge, RefusesTwoImagesOfOneRender) {
  const Sandbox sandbox;
  run_shards(sandbox, 2);
  replace_in(sandbox, "configuration.json", "--grey\", \"0.5\"", "--grey\", \"0.4\"");
  sandbox.orbs(run({"--shard", "1/2", "-o", "again"}));
  const auto answer = sandbox.orbs({"merge", "part-1", "part-2", "again"});
  EXPECT_EQ(answer.status, 2);
  EXPECT_TRUE(contains(answer.text, "have different files of this render")) << answer.text;
}

TEST(Merge, RefusesWhatWasDamagedOnTheWay) {
  const Sandbox sandbox;
  run_shards(sandbox, 1);
  const auto image = sandbox.folder() / "part-1/good/grey/result.exr";
  ASSERT_TRUE(fs::exists(image));
  const auto whole = sandbox.read("part-1/good/grey/result.exr");
  sandbox.write("part-1/good/grey/result.exr", whole.substr(0, whole.size() - 1));
  const auto torn = sandbox.orbs({"merge", "part-1", "-o", "merged"});
  EXPECT_EQ(torn.status, 2);
  EXPECT_TRUE(contains(torn.text, "good/grey/result.exr: is not the image that was judged")) << torn.text;
  fs::remove(image);
  EXPECT_TRUE(contains(sandbox.orbs({"merge", "part-1", "-o", "merged"}).text, "there is no such file"));
  EXPECT_FALSE(sandbox.has("merged"));
}

// Shards may come from somebody else's machine.
TEST(Merge, TakesNoFilesFromOutsideOfTheShards) {
  const Sandbox sandbox;
  run_shards(sandbox, 1);
  sandbox.write("private/key", "secret");
  fs::rename(sandbox.folder() / "part-1/wrong-size/grey", sandbox.folder() / "part-1/moved");
  fs::create_symlink("../../private", sandbox.folder() / "part-1/wrong-size/grey");
  const auto link = sandbox.orbs({"merge", "part-1", "-o", "merged"});
  EXPECT_EQ(link.status, 2);
  EXPECT_TRUE(contains(link.text, "expected a folder of the run")) << link.text;
  const auto whole = sandbox.read("part-1/results.json");
  const std::string folder = R"("folder": "wrong-size/grey")";
  ASSERT_TRUE(contains(whole, folder));
  for (const char* path : {"../private", "/etc"}) {
    auto text = whole;
    text.replace(text.find(folder), folder.size(), fmt::format(R"("folder": "{}")", path));
    sandbox.write("part-1/results.json", text);
    const auto answer = sandbox.orbs({"merge", "part-1", "-o", "merged"});
    EXPECT_EQ(answer.status, 2);
    EXPECT_TRUE(contains(answer.text, "leads out of the folder of this file")) << answer.text;
  }
  EXPECT_FALSE(sandbox.has("merged"));
}

TEST(Merge, SaysThatATargetOfUnknownRendersWasNotJudged) {
  const Sandbox sandbox;
  run_shards(sandbox, 1);
  auto text = sandbox.read("part-1/plan.json");
  const auto targets = text.rfind("\"targets\": [");
  ASSERT_NE(targets, std::string::npos);
  sandbox.write("part-1/plan.json",
                text.insert(text.find('[', targets) + 1,
                            R"({"case": "m1_grey", "target": "lost", "renderer": "good", "jobs": ["0"]},)"));
  const auto answer = sandbox.orbs({"merge", "part-1", "-o", "merged"});
  EXPECT_EQ(answer.status, 2);
  EXPECT_TRUE(contains(answer.text, "good lost of m1_grey: not judged")) << answer.text;
}

TEST(Merge, AMergedRunCanBeResumed) {
  const Sandbox sandbox;
  const auto local = sandbox.orbs(run({"-o", "local"}));
  run_shards(sandbox, 2);
  sandbox.orbs({"merge", "part-1", "part-2", "-o", "merged"});
  fs::remove_all(sandbox.folder() / "part-1");
  const auto answer = sandbox.orbs({"run", "--resume", "merged"});
  EXPECT_EQ(answer.status, local.status);
  EXPECT_FALSE(contains(answer.text, "has changed")) << answer.text;
}

TEST(Shard, WhatIsNoPartIsRefused) {
  const Sandbox sandbox;
  for (const char* part : {"0/2", "3/2", "1", "a/b", "1/2/3"})
    EXPECT_EQ(sandbox.orbs({"run", "--shard", part}).status, 2) << part;
  const auto empty = sandbox.orbs({"run", "-r", "good", "--shard", "9/9", "--dry-run"});
  EXPECT_EQ(empty.status, 2);
  EXPECT_TRUE(contains(empty.text, "shard 9/9 has nothing to render: the plan has 3 renders")) << empty.text;
}
