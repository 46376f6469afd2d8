#pragma once

#include "results/verdict.h"

#include <string>

namespace orbs::report {

/// One short sentence of the reason of a verdict that fits into one line of a terminal of this width, see
/// short_sentence; 0: no limit.
std::string short_reason(const std::string& reason, int width);

/// What a line of the terminal says: the short reason of what numbers have decided, or left open. Why a
/// render has no image is said whole. Of news about a known failure, what is news is said whole.
std::string line_reason(results::Verdict verdict,
                        results::Expectation expectation,
                        const std::string& reason,
                        int width);

}  // namespace orbs::report
