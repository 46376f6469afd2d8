#pragma once

#include "results/record.h"

#include <string>

namespace orbs::report {

/// A hint for each renderer with images that fail by 6 dB or more (twice the error that the gate allows)
/// against references of another program: it may have misplaced the scene, which orbs probe checks. Images
/// whose tiles all have the right mean are only noisy and give no hint. "" if there is none.
std::string probe_hints(const results::RunRecord& run);

/// Where an image fails and none of the usual faults explains it: that orbs explain tries more. "" if there
/// is none.
std::string explain_hint(const results::RunRecord& run);

/// What the verdicts of a run at a reduced size do not rest on, in one line; "" at full size.
std::string size_note(const results::RunRecord& run);

}  // namespace orbs::report
