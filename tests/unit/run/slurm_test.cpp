#include "run/cluster/slurm.h"

#include "base/error.h"
#include "base/files.h"
#include "run/cluster/slurm_calls.h"
#include "structure/source_files.h"

#include <gtest/gtest.h>

using namespace orbs;
using structure::TestFolder;

namespace {

run::SlurmJob job_in(const std::filesystem::path& folder) {
  run::SlurmJob job;
  job.folder = folder;
  job.program = "/opt/orbs suite/orbs";
  job.shards = 12;
  job.cores = 8;
  job.memory_megabytes = 16384;
  job.settings = {"long", "group", "2:00:00", {"--constraint=avx2"}};
  job.arrays = {"11", "12"};
  return job;
}

}  // namespace

TEST(Slurm, ArraysAreWrittenAsRanges) {
  EXPECT_EQ(run::array_text({1, 2, 3, 7, 9, 10}), "1-3,7,9-10");
  EXPECT_EQ(run::array_text({4}), "4");
}

TEST(Slurm, TheCallNamesResourcesAndSettings) {
  EXPECT_EQ(run::array_words(job_in("/shared/run"), {1, 2, 5}),
            (std::vector<std::string>{
                "sbatch", "--parsable", "--job-name=orbs", "--chdir=/shared/run", "--array=1-2,5",
                "--cpus-per-task=8", "--mem=16384", "--output=/shared/run/shard-%a.log", "--partition=long",
                "--account=group", "--time=2:00:00", "--constraint=avx2", "/shared/run/array.sh"}));
  const auto merge = run::merge_words(job_in("/shared/run"), {"77", "79"});
  EXPECT_EQ(merge[4], "--dependency=afterany:77:79");
}

// Slurm would write 100%j of a folder with the number of the job.
TEST(Slurm, PercentSignsOfTheFolderAreDoubledInPatternsAlone) {
  const auto words = run::array_words(job_in("/shared/100%job"), {1});
  const auto has = [&](const char* word) {
    return std::find(words.begin(), words.end(), word) != words.end();
  };
  EXPECT_TRUE(has("--output=/shared/100%%job/shard-%a.log"));
  EXPECT_TRUE(has("--chdir=/shared/100%job"));
  EXPECT_TRUE(has("/shared/100%job/array.sh"));
  EXPECT_EQ(run::merge_words(job_in("/shared/100%job"), {"7"})[5], "--output=/shared/100%%job/merge.log");
}

TEST(Slurm, ATaskAsksForWhatWasMeasuredOrForTheLimit) {
  constexpr std::size_t kMegabyte = 1 << 20;
  run::Plan plan;
  plan.settings.jobs = 2;
  plan.renderers.resize(1);
  auto& limit = plan.renderers[0].entry.limits.memory_bytes;
  limit = 16384 * kMegabyte;
  plan.jobs.resize(2);
  plan.jobs[0].id = "a";
  plan.jobs[1].id = "b";
  EXPECT_EQ(run::megabytes_of_task(plan, {}), 2 * 16384U);
  EXPECT_EQ(run::megabytes_of_task(plan, {{"a", 100 * kMegabyte}}), 2 * 16384U) << "b was never measured";
  EXPECT_EQ(run::megabytes_of_task(plan, {{"a", 100 * kMegabyte}, {"b", 400 * kMegabyte}}), 2 * (600 + 256U));
  limit = 500 * kMegabyte;
  EXPECT_EQ(run::megabytes_of_task(plan, {{"a", 100 * kMegabyte}, {"b", 400 * kMegabyte}}), 2 * 500U);
  limit.reset();
  EXPECT_EQ(run::megabytes_of_task(plan, {{"a", 100 * kMegabyte}}), 0U) << "left to Slurm";
  EXPECT_EQ(run::megabytes_of_task(plan, {{"a", 100 * kMegabyte}, {"b", 400 * kMegabyte}}), 2 * (600 + 256U));
}

TEST(Slurm, TheQueueIsReadLineByLine) {
  EXPECT_EQ(run::queue_words({"12", "15"}),
            (std::vector<std::string>{"squeue", "--noheader", "--array", "--jobs=12,15", "--format=%F_%K"}));
  const auto queued = run::queued_in("12_3\n12_10\n15_3\n\n");
  EXPECT_EQ(queued.tasks, (std::vector<int>{3, 10}));
  EXPECT_EQ(queued.arrays, (std::vector<std::string>{"12", "15"}));
  EXPECT_TRUE(run::queued_in("").tasks.empty());
  EXPECT_THROW(run::queued_in("squeue: something else"), InputError);
}

TEST(Slurm, AJobIsReadAsItWasWritten) {
  const TestFolder folder("slurm");
  run::write_slurm_job(job_in(folder.path()));
  const auto read = run::read_slurm_job(folder.path());
  EXPECT_EQ(run::array_words(read, {1}), run::array_words(job_in(folder.path()), {1}));
  EXPECT_EQ(read.arrays, (std::vector<std::string>{"11", "12"}));
  const auto script = read_file(folder.path() / "array.sh");
  EXPECT_NE(script.find("'/opt/orbs suite/orbs' run --plan plan.json --shard \"$part/12\""),
            std::string::npos)
      << script;
  EXPECT_EQ(run::missing_shards(read).size(), 12U);
  EXPECT_THROW(run::read_slurm_job(folder.path() / "nowhere"), InputError);
}
