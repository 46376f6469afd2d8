#pragma once

#include "studies/qualify/sensitivity.h"

#include <string>
#include <vector>

namespace orbs::studies {

/// Tables of the mutants by fault and knowledge, and of the control images; each mutant that passed silently.
std::string sensitivity_text(const std::vector<JudgedImage>& images);

}  // namespace orbs::studies
