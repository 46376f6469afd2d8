#pragma once

#include "registry/cluster.h"
#include "run/plan/plan.h"

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

/// A run as an array of Slurm jobs, one task for each shard, and a job that merges them. Slurm hands out the
/// tasks; a shard whose task was lost is submitted again.
namespace orbs::run {

/// The most memory that renders of a plan took before, by job id. What was never rendered has no entry.
using MeasuredMemory = std::map<std::string, std::size_t>;

/// What is submitted; stored in the folder as slurm.json (format "orbs-slurm/3"), beside the plan.json that
/// every task executes.
struct SlurmJob {
  std::filesystem::path folder;  // absolute, on a disk that all nodes see
  std::string program;           // orbs
  int shards = 1;
  int cores = 1;                     // of a task
  std::size_t memory_megabytes = 0;  // of a task; 0: left to Slurm
  registry::SlurmSettings settings{};
  std::vector<std::string> arrays{};  // ids of the arrays that were submitted, the last one at the end
};

/// Job of a plan. Resources are those of the renders of a task: threads and memory of as many renders as run
/// at a time. `shards` 0: one for each render, but not more than kMostShards. InputError if there are more
/// shards than renders.
SlurmJob slurm_job(const registry::SlurmSettings& settings,
                   const Plan& plan,
                   const MeasuredMemory& measured_bytes,
                   const std::filesystem::path& folder,
                   int shards);

/// The memory that a task asks for: what the renders of the plan were measured to take, with a margin, but no
/// more than their limits; the limit of what was never measured. 0, which leaves it to Slurm, where a render
/// has neither.
std::size_t megabytes_of_task(const Plan& plan, const MeasuredMemory& measured_bytes);

/// Slurm allows 1001 tasks of an array where its administrator says nothing else (MaxArraySize).
inline constexpr int kMostShards = 1000;

/// Writes slurm.json and the two scripts. WriteError when the disk refuses.
void write_slurm_job(const SlurmJob& job);

/// InputError when there is none in the folder, or it is broken.
SlurmJob read_slurm_job(const std::filesystem::path& folder);

/// The shards that are not complete, counted from 1.
std::vector<int> missing_shards(const SlurmJob& job);

/// The folder of a shard in that of the job.
std::filesystem::path shard_folder(const SlurmJob& job, int shard);

/// "1-3,7".
std::string array_text(const std::vector<int>& shards);

/// The words that submit an array of these shards.
std::vector<std::string> array_words(const SlurmJob& job, const std::vector<int>& shards);

/// The words that submit the merge, to be started when these arrays have ended, however they have.
std::vector<std::string> merge_words(const SlurmJob& job, const std::vector<std::string>& array_ids);

}  // namespace orbs::run
