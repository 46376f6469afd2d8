#pragma once

#include "results/run_folder.h"

#include <string>

namespace orbs::report {

/// The progress of a run that goes on, as an event: how many renders are done, which ones run, how many are
/// left, and the estimated seconds until the end (null if unknown).
std::string progress_json(const results::RunView& view);

}  // namespace orbs::report
