#pragma once

#include "studies/qualify/mutants.h"

#include <vector>

namespace orbs::studies {

/// Faults near the size at which noise begins to hide them: slight gradients, wrong shadows and colours,
/// fractions of a pixel, filters, quantisation, patterns, patches and spots of several sizes. Each leaves the
/// variances as they are, as an error in shading or in the film does. `reference` is without noise as far as
/// there is one; what depends on the image's brightness is decided by it.
std::vector<Fault> subtle_faults(const image::Image& reference);

}  // namespace orbs::studies
