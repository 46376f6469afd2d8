#include "base/error.h"
#include "base/files.h"
#include "runner/slurm.h"
#include "structure/source_files.h"

#include <gtest/gtest.h>

using namespace orbs;
using structure::TestFolder;

namespace {

runner::SlurmJob job_in(const std::filesystem::path& folder) {
  runner::SlurmJob job;
  job.folder = folder;
  job.program = "/opt/orbs suite/orbs";
  job.run = {"--suite", "orbs", "--case", "m*"};
  job.shards = 12;
  job.cores = 8;
  job.memory_megabytes = 16384;
  job.settings = {"long", "group", "2:00:00", {"--constraint=avx2"}};
  return job;
}

}  // namespace

TEST(Slurm, ArraysAreWrittenAsRanges) {
  EXPECT_EQ(runner::array_text({1, 2, 3, 7, 9, 10}), "1-3,7,9-10");
  EXPECT_EQ(runner::array_text({4}), "4");
}

TEST(Slurm, TheCallNamesResourcesAndSettings) {
  EXPECT_EQ(
      runner::array_words(job_in("/shared/run"), {1, 2, 5}),
      (std::vector<std::string>{"sbatch", "--parsable", "--job-name=orbs", "--chdir=/shared/run",
                                "--partition=long", "--account=group", "--time=2:00:00", "--constraint=avx2",
                                "--array=1-2,5", "--cpus-per-task=8", "--mem=16384",
                                "--output=/shared/run/shard-%a.log", "/shared/run/array.sh"}));
  const auto merge = runner::merge_words(job_in("/shared/run"), "77");
  EXPECT_EQ(merge[merge.size() - 3], "--dependency=afterany:77");
}

TEST(Slurm, AJobIsReadAsItWasWritten) {
  const TestFolder folder("slurm");
  runner::write_slurm_job(job_in(folder.path()));
  const auto read = runner::read_slurm_job(folder.path());
  EXPECT_EQ(runner::array_words(read, {1}), runner::array_words(job_in(folder.path()), {1}));
  EXPECT_EQ(read.run, job_in("").run);
  const auto script = read_file(folder.path() / "array.sh");
  EXPECT_NE(script.find("'/opt/orbs suite/orbs' run --suite orbs --case 'm*' --shard \"$part/12\""),
            std::string::npos)
      << script;
  EXPECT_EQ(runner::missing_shards(read).size(), 12U);
  EXPECT_THROW(runner::read_slurm_job(folder.path() / "nowhere"), InputError);
}
