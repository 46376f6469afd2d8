#pragma once

#include "image/image.h"
#include "studies/primary_visibility.h"
#include "studies/probe_scene.h"

#include <string>
#include <vector>

namespace orbs::studies {

/// Pixels that should show a thing (or nothing) and do not.
struct Mismatch {
  int thing = kNoThing;  // that is expected
  int pixels = 0;
  int x = 0;  // the first of them
  int y = 0;
  std::string instead;  // what most of them show
};

struct ProbeFindings {
  int compared = 0;  // pixels that one thing covers whole; the others say nothing without doubt
  std::vector<Mismatch> mismatches;  // the worst first
};

/// Compares the image of coloured_by_thing. A pixel counts where all its surfaces see one thing, so that a
/// filter of one pixel can only give that thing's colour.
ProbeFindings compare_things(const ProbeScene& probe,
                             const std::vector<VisibleSurface>& surfaces,
                             const image::Image& image);

/// Compares the image of coloured_by_coordinates, where the coordinates of a pixel's surfaces stay within one
/// period of the ramp and do not change too fast.
ProbeFindings compare_coordinates(const ProbeScene& probe,
                                  const std::vector<VisibleSurface>& surfaces,
                                  const image::Image& image);

}  // namespace orbs::studies
