#pragma once

#include "results/qualification.h"
#include "studies/qualify/sensitivity.h"

#include <string>
#include <vector>

namespace orbs::studies {

/// A line per gate: how many faults are rejected, the smallest ones; then a reason for each that is not.
std::string qualification_text(const std::vector<results::GateRecord>& gates);

/// Tables of the mutants by fault and knowledge, and of the control images; each mutant that passed silently.
std::string sensitivity_text(const std::vector<JudgedImage>& images);

}  // namespace orbs::studies
