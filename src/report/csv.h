#pragma once

#include "results/record.h"

#include <string>

namespace orbs::report {

/// CSV (RFC 4180) in long form: one row per target and renderer.
std::string results_csv(const results::RunRecord& run);

}  // namespace orbs::report
