#pragma once

#include "results/record.h"

#include <string>

namespace orbs::report {

/// What the verdicts of a run at a reduced size do not rest on, in one line; "" at full size.
std::string size_note(const results::RunRecord& run);

}  // namespace orbs::report
