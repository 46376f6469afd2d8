#include "run/cluster/slurm.h"

#include "base/error.h"
#include "base/files.h"
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
  return job;
}

}  // namespace

TEST(Slurm, ArraysAreWrittenAsRanges) {
  EXPECT_EQ(run::array_text({1, 2, 3, 7, 9, 10}), "1-3,7,9-10");
  EXPECT_EQ(run::array_text({4}), "4");
}

TEST(Slurm, TheCallNamesResourcesAndSettings) {
  EXPECT_EQ(
      run::array_words(job_in("/shared/run"), {1, 2, 5}),
      (std::vector<std::string>{"sbatch", "--parsable", "--job-name=orbs", "--chdir=/shared/run",
                                "--partition=long", "--account=group", "--time=2:00:00", "--constraint=avx2",
                                "--array=1-2,5", "--cpus-per-task=8", "--mem=16384",
                                "--output=/shared/run/shard-%a.log", "/shared/run/array.sh"}));
  const auto merge = run::merge_words(job_in("/shared/run"), "77");
  EXPECT_EQ(merge[merge.size() - 3], "--dependency=afterany:77");
}

TEST(Slurm, AJobIsReadAsItWasWritten) {
  const TestFolder folder("slurm");
  run::write_slurm_job(job_in(folder.path()));
  const auto read = run::read_slurm_job(folder.path());
  EXPECT_EQ(run::array_words(read, {1}), run::array_words(job_in(folder.path()), {1}));
  const auto script = read_file(folder.path() / "array.sh");
  EXPECT_NE(script.find("'/opt/orbs suite/orbs' run --plan plan.json --shard \"$part/12\""),
            std::string::npos)
      << script;
  EXPECT_EQ(run::missing_shards(read).size(), 12U);
  EXPECT_THROW(run::read_slurm_job(folder.path() / "nowhere"), InputError);
}
