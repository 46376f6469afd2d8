#pragma once

#include "studies/cost/record.h"

#include <filesystem>
#include <string>

namespace orbs::studies {

/// The record and all numbers that follow from it, each with its definition (format "orbs-cost/1").
std::string cost_json(const CostRecord& record);

/// Reads what was measured; everything else is computed anew. InputError with file, line and key.
CostRecord read_cost_file(const std::filesystem::path& file);

/// One line per render, with a header; numbers in full precision.
std::string cost_csv(const CostRecord& record);

}  // namespace orbs::studies
