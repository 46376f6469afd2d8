#pragma once

#include "studies/cost_record.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace orbs::studies {

/// What a pilot render says of a curve before its rungs are chosen.
struct CostPilot {
  std::size_t target = 0;
  std::size_t renderer = 0;
  double fixed_seconds = 0;        // wall clock of the fixed cost
  int spp = 1;                     // of the pilot
  double seconds = 0;              // its wall clock on an idle machine
  double psnr_srgb8 = 0;           // its error
  int least_spp = 1;               // the fewest samples of a rung
  std::vector<CostRung> settings;  // the rungs that the configuration lists; none: samples
};

/// The wall clock that all renders of the ladder are expected to take, those of the fixed cost included.
/// Nothing for settings, whose times are not known before they are rendered.
std::optional<double> expected_seconds(const CostPilot& pilot,
                                       const CostLadder& ladder,
                                       const CostSettings& settings);

/// The ladders of all pilots. The last rung has enough samples to be past the target, for an error whose
/// square falls as 1 / samples; each has half the samples of the next. Where all together would exceed the
/// budget, in seconds of wall clock, all ladders first get fewer rungs, down to the four that a fit needs;
/// then the one whose samples take the longest gets half of them, again and again, and says so in its note.
std::vector<CostLadder> choose_ladders(const std::vector<CostPilot>& pilots,
                                       const CostSettings& settings,
                                       double budget_seconds);

/// Ladders with these samples at every curve, whatever they cost.
std::vector<CostLadder> given_ladders(const std::vector<CostPilot>& pilots, const std::vector<int>& samples);

}  // namespace orbs::studies
