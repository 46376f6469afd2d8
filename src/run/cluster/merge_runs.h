#pragma once

#include "results/record.h"

#include <filesystem>
#include <string>
#include <vector>

namespace orbs::run {

/// Puts the shards of one plan together as the run that one machine would have made, in the new folder
/// `merged`: images, copies of references and records, with commands that name the new place. Every shard may
/// lie anywhere, and one may hold jobs of another one again. Times stay those of the machines that rendered;
/// the time of the whole is that of the longest shard. InputError that names each job that is missing and
/// each contradiction: shards of another plan or by another version of orbs or of a renderer, two different
/// images of one job, two different references. WriteError when the disk refuses.
results::RunRecord merge_runs(const std::vector<std::filesystem::path>& shards,
                              const std::filesystem::path& merged,
                              const std::vector<std::string>& command_line);

}  // namespace orbs::run
