#pragma once

#include "studies/qualify/mutants.h"

#include <map>
#include <string>
#include <vector>

namespace orbs::studies {

/// A fault as renderers make it, and what the diagnosis should say of it.
struct TypicalFault {
  Fault fault;
  std::string expected;  // how the diagnosis begins: "shifted by (2, 1) px"; "" when it should know none
};

/// More than 20 kinds of the usual faults, and eight faults that are none of them. `reference` must outlive
/// the faults; `other_targets` are the references of the same case's other targets.
std::vector<TypicalFault> typical_faults(const image::Image& reference,
                                         const std::map<std::string, image::Image>& other_targets);

}  // namespace orbs::studies
