#pragma once

#include "results/record.h"

#include <string>

namespace orbs::report {

/// What is said where the times of a renderer's renders contradict each other: its processes used nearly no
/// CPU for as long as they ran, or it states far less or more rendering than they took. "" where they agree.
/// All times on cards and in rankings are those that orbs measured.
std::string clocks_text(const results::RunRecord& run, const std::string& renderer);

/// Whether its processes used so little CPU that CPU time says nothing of what its images cost: it waits, or
/// something that orbs did not start renders for it.
bool renders_elsewhere(const results::RunRecord& run, const std::string& renderer);

}  // namespace orbs::report
