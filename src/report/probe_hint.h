#pragma once

#include "results/record.h"

#include <string>

namespace orbs::report {

/// A line for each renderer with images that fail by 6 dB or more (half of what the gate allows in each
/// value) against references of another program: whether it has the scene where it should be is then the
/// first question, and orbs probe answers it. "" when there is none.
std::string probe_hints(const results::RunRecord& run);

}  // namespace orbs::report
