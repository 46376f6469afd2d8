#pragma once

#include "run/plan/plan.h"

#include <optional>
#include <vector>

namespace orbs::run {

/// The file of render times that comes with the program: data/bench/render-times.json below the root of the
/// plan. It holds one suite at one size.
std::filesystem::path shipped_times_file(const Plan& plan);

/// By job: the CPU seconds that its render took on another machine, scaled to its samples. Nothing for a
/// render that is not in the file, or without the file. InputError when it cannot be read.
std::vector<std::optional<double>> shipped_cpu_seconds(const Plan& plan);

/// The same with the mean of the known ones for the others; 1 for all where none is known.
std::vector<double> estimated_cpu_seconds(const Plan& plan);

}  // namespace orbs::run
