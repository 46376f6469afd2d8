#pragma once

#include "results/qualification.h"

#include <string>
#include <vector>

namespace orbs::studies {

/// A line per gate: how many faults are rejected, the smallest ones; then a reason for each that is not.
std::string qualification_text(const std::vector<results::GateRecord>& gates);

}  // namespace orbs::studies
