#pragma once

#include "image/image.h"
#include "results/qualification.h"
#include "runner/judge.h"
#include "studies/missing_light.h"

#include <map>
#include <string>
#include <vector>

namespace orbs::studies {

/// All that the gate of one image is tried with.
struct GateTrial {
  const registry::Case& one_case;
  std::string image;
  runner::Reference reference;  // there
  image::Image control;
  const std::map<std::string, image::Image>& others;  // references of the suite, by name
  const std::vector<MissingLight>& dark;
  std::string no_dark;  // why `dark` is empty
};

/// Judges the control image, all mutants, and looks for the smallest faults; the rest of the record is the
/// caller's. By what judges the images of a run, and nothing else.
results::GateRecord try_gate(const GateTrial& trial);

}  // namespace orbs::studies
