#pragma once

#include "json/fields.h"

#include <string>
#include <vector>

namespace orbs::registry {

/// A part of the renders of a run: 3/16 is the third of sixteen. 1/1 is all of them.
struct Shard {
  int index = 1;  // from 1 to count
  int count = 1;
};

/// Reads "3/16". InputError saying what can be read.
Shard parse_shard(const std::string& text);

/// "3/16".
std::string shard_text(const Shard& shard);

/// As fields() write and read it.
inline std::string to_text(const Shard& shard) { return shard_text(shard); }
inline void from_text(const std::string& text, Shard& shard) { shard = parse_shard(text); }

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
