#pragma once

#include "cli/action.h"
#include "studies/context.h"

#include <cstdio>

namespace orbs::cli {

/// The surroundings of a study: its progress goes to `stream` line by line, and from now on an interrupt only
/// sets the context's flag.
studies::StudyContext study_context(const Program& program, std::FILE* stream);

}  // namespace orbs::cli
