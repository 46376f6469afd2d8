#pragma once

#include "image/image.h"
#include "metrics/mask.h"

#include <optional>

namespace orbs::metrics {

/// Where an image is off by more than noise over tiles of 16 x 16 px: the size of a lost detail, a leak or a
/// shadow that is not there, which the mean of a whole image does not see.
///
/// |sum(result - reference)| - 5 standard errors, over reference tile + reference image (means, so that a
/// dark tile is measured by what is visible beside it). The standard error is that of the tile's own pixels:
/// it needs no variance channel, and what differs within a tile only makes it larger. Five, as an image has
/// thousands of tiles: one in some hundred control images would show a tile above 0, and the tolerance is
/// far from 0.
struct LocalBias {
  double value = 0;  // 0: no tile is off for sure
  Rectangle where;   // the worst tile, the first by rows
};

/// The worst of R, G, B and all tiles from the upper left corner; tiles with fewer than 64 unmasked pixels
/// are left out. Nothing when none is left, or when the reference's mean is not above 0 in any channel. The
/// images must be Comparable; InputError when the mask does not fit them.
std::optional<LocalBias> local_bias(const image::Image& result,
                                    const image::Image& reference,
                                    const Mask& mask = {});

}  // namespace orbs::metrics
