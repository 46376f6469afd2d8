#pragma once

#include "studies/cost/record.h"

#include <cstddef>

/// Which seeds the renders of a sweep have, so that no two settings share random numbers: nested samples are
/// not independent. And what that costs where seeds count the images of a run (registry::ImageSequence),
/// since those before a seed are rendered, too.
namespace orbs::studies {

/// The sample counts that each curve gets before any curve gets more: fewer show neither a slope nor a bend.
inline constexpr std::size_t kPointsOfEach = 3;

/// Samples per pixel of the pilot of a sweep by samples. Enough: the error of an image is a mean over all its
/// pixels.
inline constexpr int kPilotSpp = 8;

/// What the seeds of a sweep depend on.
struct SeedRule {
  int sequence_images = 0;  // that one render takes of a run, see CostRenderer; 0: it has seeds
  SweepOf varies = SweepOf::Samples;
  int seeds = 4;          // renders of each setting
  bool is_again = false;  // one of the settings is rendered again, for a comparison with itself
};

SeedRule seed_rule(const CostRecord& record, const Sweep& sweep);

/// The setting of a sweep that is rendered again, where any is: the last of those that each curve gets.
std::size_t setting_of_again(const Sweep& sweep);

int pilot_seed(const SeedRule& rule);

/// The seed before the first one of a setting. With n samples, the seed s of a sequence is its s-th block of
/// n samples, so each setting begins behind the samples of the pilot and of all settings before it: where
/// each has twice the samples of the one before, that takes hardly more than as many images as it has
/// renders. Different qualities (SweepOf::Settings) draw their random numbers differently, and all begin at
/// the first.
int seed_before(const SeedRule& rule, const Sweep& sweep, std::size_t setting);

/// Likewise of the renders that are made again.
int seed_before_again(const SeedRule& rule, const Sweep& sweep);

/// How many images the renders of a setting take for each one that counts, in the mean. 1 without a sequence.
double images_of_setting(const SeedRule& rule, const Sweep& sweep, std::size_t setting);

/// What a render of one image takes, by a process that rendered so many for each that counts: they are equal
/// but for their random numbers, so each took the same share of all that is above the fixed cost.
double seconds_of_one_image(double seconds, double fixed_seconds, double images);

/// The record with the times of single images in place of those of whole processes. Where the fixed cost of a
/// sweep is not known, neither is the time of one image, and its renders of several are left out.
CostRecord with_times_of_one_image(CostRecord record);

}  // namespace orbs::studies
