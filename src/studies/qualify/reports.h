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

/// Of the control images, a line for each kind of noise that is known: "orbs,1/4,two seeds,240,12,0", which
/// are suite, size, noise, and how many were judged, inconclusive, and called wrong (rejected, or with a
/// remark).
std::string controls_csv(const std::string& suite,
                         const std::string& size,
                         const std::vector<JudgedImage>& images);
inline constexpr const char* kControlsCsvHead = "suite,size,noise,comparisons,inconclusive,called_wrong\n";

}  // namespace orbs::studies
