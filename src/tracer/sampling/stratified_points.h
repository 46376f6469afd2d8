#pragma once

#include "tracer/sampling/sample_dimension.h"

#include <array>
#include <cstdint>

namespace orbs::tracer {

/// Point `index` of `count` jittered points (Cook, Porter and Carpenter 1984), four numbers in [0, 1): the
/// numbers that are used as a pair (pixel, point on a light, direction) have a grid of cells, with about as
/// many rows as columns, and the others one interval per point. Each pair and number visits its strata in its
/// own random order, as in pbrt's StratifiedSampler. If the grid has more cells than there are points,
/// a random choice of cells stays empty. `seed` is well mixed.
std::array<float, 4> stratified_point(std::uint32_t seed,
                                      std::uint32_t index,
                                      std::uint32_t count,
                                      SampleDimension dimension);

}  // namespace orbs::tracer
