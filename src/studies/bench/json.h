#pragma once

#include "studies/bench/bench.h"

#include <string>
#include <vector>

namespace orbs::studies {

/// The record with every single time as JSON (format "orbs-bench/1"), each number with its definition. What
/// could not be measured is null.
std::string bench_json(const BenchRecord& record);

}  // namespace orbs::studies
