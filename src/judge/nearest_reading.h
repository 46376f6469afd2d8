#pragma once

#include "image/image.h"

#include <optional>

namespace orbs::judge {

/// An image that came as a Radiance picture, as it is judged: what its format cannot say is not held against
/// it. Nothing for any other image, which has no channels image::kRgbeSteps.
///
/// Its writer cut off what does not fit into a mantissa, or rounded it: of these two readings the one that is
/// nearer to the reference as a whole counts. The half step that is uncertain in each pixel then goes towards
/// the reference, but for a sixteenth of it, so that no image becomes its reference to the bit.
std::optional<image::Image> nearest_reading(const image::Image& result, const image::Image& reference);

}  // namespace orbs::judge
