#pragma once

#include "results/verdict.h"

#include <string_view>

namespace orbs::results {

/// The colour that a verdict has on a terminal: green for what is as it should be, red for a failure, yellow
/// for what noise left open, faint for what was not judged.
std::string_view state_colour(Verdict verdict, Expectation expectation);

}  // namespace orbs::results
