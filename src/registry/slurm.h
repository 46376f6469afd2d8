#pragma once

#include "json/fields.h"

#include <string>
#include <vector>

namespace orbs::registry {

/// What a user's Slurm wants to know of a job, see sbatch(1). "" leaves it to Slurm.
struct SlurmSettings {
  std::string partition{};
  std::string account{};
  std::string time{};                  // limit of each task: "2:00:00"
  std::vector<std::string> options{};  // further words for sbatch
};

template <class Visitor, json::RecordOf<SlurmSettings> Settings>
void fields(Visitor& visit, Settings& slurm) {
  visit("partition", slurm.partition, {.help = "As `--partition` of sbatch"});
  visit("account", slurm.account, {.help = "As `--account` of sbatch"});
  visit("time", slurm.time, {.help = "Limit of each task, as sbatch takes it"});
  visit("options", slurm.options, {.help = "Further options of sbatch, such as `--constraint=avx2`"});
}

/// InputError, with file, line and key, for an option that is none. `in` is the object that holds "slurm", if
/// it has any.
void check_slurm(json::ObjectReader& in, const SlurmSettings& settings);

}  // namespace orbs::registry
