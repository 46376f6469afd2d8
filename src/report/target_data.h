#pragma once

#include "results/run_folder.h"

#include <cstddef>
#include <string>

namespace orbs::report {

/// The data of one target beyond the overview: its record, its images, and the records of its renders with
/// the ends of their logs. `index` is that of run.targets.
std::string target_json(const results::RunView& view, std::size_t index);

}  // namespace orbs::report
