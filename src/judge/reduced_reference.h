#pragma once

#include "image/image.h"

namespace orbs::judge {

/// The reference for images of 1/divisor of the width and height, see image::reduced_image. Its provenance
/// record gets "averaged_over", and the hash of its own pixels and its own noise in place of those of the
/// full size. The hash of the scene stays: the reference is current or stale as the full one is. InputError
/// when the size cannot be divided.
image::Image reduced_reference(const image::Image& reference, int divisor);

}  // namespace orbs::judge
