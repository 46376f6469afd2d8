#pragma once

#include "image/image.h"

#include <string>

namespace orbs::cli {

/// Renames the channels of one image that are to be compared to R, G and B: those of the layer `wanted`
/// ("ViewLayer.Combined", of whose channel "ViewLayer.Combined.R" is one) or three times its channel of that
/// name; without, its own R, G and B, the only colours or the only grey that it has, or of several layers the
/// one that `other` has too, or that programs call the whole. Returns a sentence that says which they are;
/// "" for R, G and B. InputError with the names that there are when nothing decides. `file` is for messages.
std::string choose_channels(image::Image& image,
                            const image::Image& other,
                            const std::string& wanted,
                            const std::string& file);

}  // namespace orbs::cli
