#pragma once

#include "json/object_reader.h"

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

/// Reads the object "slurm" of configuration.json. InputError with file, line and key.
SlurmSettings load_slurm(json::ObjectReader in);

}  // namespace orbs::registry
