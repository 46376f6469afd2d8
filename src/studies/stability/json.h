#pragma once

#include "studies/stability/record.h"

#include <filesystem>
#include <string>

namespace orbs::studies {

/// "orbs-stability/1": the record, the definitions of its numbers, and the matrix that follows from it.
std::string stability_json(const StabilityRecord& record);

/// InputError if the file is missing, broken or of another format, or a step is of something that the file
/// does not list.
StabilityRecord read_stability_file(const std::filesystem::path& file);

/// True if no step broke and something was measured.
bool all_hold(const StabilityRecord& record);

}  // namespace orbs::studies
