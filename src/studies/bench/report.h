#pragma once

#include "studies/bench/bench.h"

#include <string>
#include <vector>

namespace orbs::studies {

/// The record with every single time as JSON (format "orbs-bench/1"), each number with its definition. What
/// could not be measured is null.
std::string bench_json(const BenchRecord& record);

/// The table for people: a line per number, a column per renderer, medians with the least and the most of the
/// rounds.
std::string bench_table(const BenchRecord& record);

}  // namespace orbs::studies
