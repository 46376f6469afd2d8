#pragma once

#include "studies/cost/record.h"
#include "studies/cost/render.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace orbs::studies {

/// What a pilot render says of a curve before its settings are chosen.
struct CostPilot {
  std::size_t target = 0;
  std::size_t renderer = 0;
  double fixed_seconds = 0;            // wall clock of the fixed cost
  int spp = 1;                         // of the pilot
  double seconds = 0;                  // its wall clock on an idle machine
  double psnr_srgb8 = 0;               // its error
  int least_spp = 1;                   // the fewest samples of a point
  std::vector<SweepSetting> settings;  // the settings that the configuration lists; none: samples
  /// Wall clock of the settings that were tried, the first of the list; the study has no more of them.
  std::vector<double> setting_seconds = {};
  bool is_noise_free = false;
  int sequence_images = 0;  // see CostRenderer
};

/// Renders of each setting: without random samples, every further image would be the same, and its time is
/// measured twice.
int renders_per_setting(const CostPilot& pilot, const CostSettings& settings);

/// Whether all renders of one more setting are expected to fit into this share of the budget, in seconds. The
/// times of settings are not known before they are rendered: each is expected to take as much longer than the
/// one before as that one did. The first is always tried.
bool may_try_next_setting(const CostPilot& pilot, const CostSettings& settings, double share_seconds);

/// The wall clock that all renders of the sweep are expected to take, those of the fixed cost included.
double expected_seconds(const CostPilot& pilot, const Sweep& sweep, const CostSettings& settings);

/// The sweeps of all pilots. The last sample count is enough to be past the target, for an error whose
/// square falls as 1 / samples; each has half the samples of the next. Where all together would exceed the
/// budget, in seconds of wall clock, all sweeps first get fewer points, down to the four that a fit needs;
/// then the one whose samples take the longest gets half of them, again and again, and says so in its note;
/// not beyond where its start takes longer, and not if it takes half of an even share of the budget at most.
/// What is still too long is for the schedule to leave out.
std::vector<Sweep> choose_sweeps(const std::vector<CostPilot>& pilots,
                                 const CostSettings& settings,
                                 double budget_seconds);

/// Sweeps of these sample counts at every curve, however long they take.
std::vector<Sweep> given_sweeps(const std::vector<CostPilot>& pilots, const std::vector<int>& samples);

/// Renders a pilot of every scene by every renderer that renders it, and chooses the sweeps of a study of
/// `budget_seconds` of wall clock, the pilots included, unless the request gives them. A renderer that fails
/// on a scene gets a sweep without settings, with the reason in its note. False when the user interrupts.
bool find_sweeps(CostMeasurement& study, double budget_seconds);

}  // namespace orbs::studies
