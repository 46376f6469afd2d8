#pragma once

#include "metrics/pair_samples.h"

#include <cstddef>

namespace orbs::judge {

/// How many samples of a reference without noise must vary within their pixel before an image that equals it
/// proves anything: emitters of a few colours, seen directly, are right to the bit.
constexpr std::size_t kFewestVarying = 100;

/// Whether an image that has noise by its nature equals a reference that has none: to within four units in
/// the last place of a float in every counted pixel, of which at least kFewestVarying samples vary. A mean of
/// random samples has noise wherever the values vary. An image whose renderer draws none
/// (ResultNoise::NoiseFree) may evaluate the same formula, so nothing is said of it.
///
/// What this cannot see: a mean of the copy and an image, whose noise is merely that of more samples.
bool is_copy_of_exact_reference(const metrics::PairSamples& samples);

}  // namespace orbs::judge
