#pragma once

#include "base/error.h"
#include "base/text.h"
#include "json/fields.h"

#include <string>
#include <vector>

#include <fmt/format.h>

namespace orbs::registry {

/// A part of the renders of a run: 3/16 is the third of sixteen. 1/1 is all of them.
struct Shard {
  int index = 1;  // from 1 to count
  int count = 1;
};

/// Reads "3/16". InputError saying what can be read.
inline Shard parse_shard(const std::string& text) {
  constexpr long long kMost = 100'000;
  const auto parts = split(text, '/');
  const bool is_pair = parts.size() == 2;
  const long long index = is_pair ? to_integer(parts[0]).value_or(0) : 0;
  const long long count = is_pair ? to_integer(parts[1]).value_or(0) : 0;
  if (index < 1 || count < index || count > kMost)
    throw InputError(
        fmt::format("'{}' is no part of a run; write such as 3/16 for the third of sixteen", text));
  return {static_cast<int>(index), static_cast<int>(count)};
}

/// "3/16".
inline std::string shard_text(const Shard& shard) { return fmt::format("{}/{}", shard.index, shard.count); }

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
inline void check_slurm(json::ObjectReader& in, const SlurmSettings& settings) {
  for (std::size_t i = 0; i < settings.options.size(); ++i)
    if (!settings.options[i].starts_with("-"))
      in.object("slurm").fail_at(
          "options", i,
          fmt::format("must be an option of sbatch such as --constraint=avx2, is '{}'", settings.options[i]));
}

}  // namespace orbs::registry
