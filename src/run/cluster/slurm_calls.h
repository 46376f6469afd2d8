#pragma once

#include <string>
#include <vector>

/// Calls of the programs of Slurm.
namespace orbs::run {

/// Calls sbatch and returns the id of the job that it made. InputError with the output of sbatch if it fails,
/// or if there is none.
std::string submit(const std::vector<std::string>& words);

/// The words that ask which tasks of these arrays wait, run or are being ended: a line "<array>_<task>" each.
std::vector<std::string> queue_words(const std::vector<std::string>& arrays);

/// What Slurm has not done with.
struct Queued {
  std::vector<std::string> arrays{};  // sorted, each once
  std::vector<int> tasks{};           // of all of these, likewise
};

/// What such lines name. InputError for another line.
Queued queued_in(const std::string& lines);

/// What of these arrays waits, runs or is being ended. Nothing of arrays that Slurm has forgotten. InputError
/// if it cannot be asked: what still waits must not be submitted twice.
Queued ask_queue(const std::vector<std::string>& arrays);

}  // namespace orbs::run
