#pragma once

#include "studies/bench/bench.h"

#include <string>

namespace orbs::studies {

/// The table for people: a line per number, a column per renderer, medians with the least and the most of the
/// rounds.
std::string bench_table(const BenchRecord& record);

}  // namespace orbs::studies
