#pragma once

#include "registry/cluster.h"
#include "run/plan/plan.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// A run as an array of Slurm jobs, one task for each shard, and a job that merges them. Slurm hands out the
/// tasks; a shard whose task was lost is submitted again.
namespace orbs::run {

/// What is submitted; stored in the folder as slurm.json (format "orbs-slurm/2"), beside the plan.json that
/// every task executes.
struct SlurmJob {
  std::filesystem::path folder;  // absolute, on a disk that all nodes see
  std::string program;           // orbs
  int shards = 1;
  int cores = 1;                     // of a task
  std::size_t memory_megabytes = 0;  // of a task; 0: left to Slurm
  registry::SlurmSettings settings{};
};

/// Job of a plan. Resources are those of the renders of a task: threads and memory limits of as many renders
/// as run at a time. `shards` 0: one for each render, but not more than kMostShards. InputError if there are
/// more shards than renders.
SlurmJob slurm_job(const registry::SlurmSettings& settings,
                   const Plan& plan,
                   const std::filesystem::path& folder,
                   int shards);

/// Slurm allows 1001 tasks of an array where its administrator says nothing else (MaxArraySize).
inline constexpr int kMostShards = 1000;

/// Writes slurm.json and the two scripts. WriteError when the disk refuses.
void write_slurm_job(const SlurmJob& job);

/// InputError when there is none in the folder, or it is broken.
SlurmJob read_slurm_job(const std::filesystem::path& folder);

/// The shards that are not complete, counted from 1.
std::vector<int> missing_shards(const SlurmJob& job);

/// "1-3,7".
std::string array_text(const std::vector<int>& shards);

/// The words that submit an array of these shards.
std::vector<std::string> array_words(const SlurmJob& job, const std::vector<int>& shards);

/// The words that submit the merge, to be started when the array has ended, however it has.
std::vector<std::string> merge_words(const SlurmJob& job, const std::string& array_id);

/// Calls sbatch and returns the id of the job that it made. InputError with the output of sbatch if it fails,
/// or if there is none.
std::string submit(const std::vector<std::string>& words);

}  // namespace orbs::run
