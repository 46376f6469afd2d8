#pragma once

#include "metrics/pair_samples.h"

#include <string>

namespace orbs::metrics {

/// The usual mistake that makes this layer of the reference the layer of the result, in words that go on
/// after "the layer 'depth' is": "along the ray and not along the axis". "" where none does. A mistake counts
/// where it leaves at most a hundredth of the squared difference, over the pixels that a surface covers and
/// whose reference shows one value but for 5 % of the layer's range.
///
/// Known are: depth along the ray (a sphere about the middle of the image: d^2 = z^2 (1 + k r^2) with one k),
/// another unit, reciprocals; values that are absolute, negated, halved and moved into [0, 1], sRGB-encoded
/// or decoded; v from the other end, u and v swapped; normals of another space (Kabsch 1976), or
/// on the far side of some surfaces.
std::string layer_fault(const PairSamples& samples, const ComparedLayer& layer);

}  // namespace orbs::metrics
