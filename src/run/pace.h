#pragma once

#include <algorithm>

namespace orbs::run {

/// What the renders of one look took: wall seconds, for so many samples of all renders together.
struct LookTime {
  double seconds = 0;
  int spp = 0;
};

/// How a renderer goes on: it takes its time to start, and then its time for each sample. A renderer that
/// starts in a second and renders 16 samples in a hundredth would otherwise be said to need an hour for what
/// takes it half a minute.
struct Pace {
  double seconds_per_look = 0;  // for the starts of its two renders
  double seconds_per_spp = 0;
};

/// The pace from the last two looks of different length, the longer one second; from one alone, or from two
/// of which the longer one took less time, it is all samples.
inline Pace pace_of(const LookTime& shorter, const LookTime& longer) {
  const Pace samples_alone{0, longer.spp > 0 ? longer.seconds / longer.spp : 0.0};
  if (shorter.spp <= 0 || longer.spp <= shorter.spp || longer.seconds <= shorter.seconds)
    return samples_alone;
  const double of_a_sample = (longer.seconds - shorter.seconds) / (longer.spp - shorter.spp);
  return {std::max(0.0, longer.seconds - of_a_sample * longer.spp),
          std::min(of_a_sample, samples_alone.seconds_per_spp)};
}

/// The time of one more look of so many samples.
inline double seconds_for(const Pace& pace, double spp) {
  return pace.seconds_per_look + pace.seconds_per_spp * spp;
}

}  // namespace orbs::run
