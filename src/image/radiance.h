#pragma once

#include "image/contents.h"
#include "image/image.h"

#include <array>
#include <string_view>

namespace orbs::image {

/// Channels that say how far the numbers that a pixel of a Radiance picture can hold lie from each other: its
/// colours share one exponent, and have 8 bits each. Programs that write them cut off what does not fit, as
/// Radiance's own does, or round, and no file says which.
inline constexpr std::array kRgbeSteps{"rgbe_step.R", "rgbe_step.G", "rgbe_step.B"};

/// A Radiance picture (.hdr, RGBE) in the order that its resolution says, divided by its EXPOSURE and
/// COLORCORR, as the format asks. Each number is mantissa * 2^(exponent - 136), as other programs read it.
/// InputError, without the name of a file, for what is none, and for bytes that are missing or too many.
Image decoded_radiance(std::string_view bytes, Wanted wanted);

/// The same with the channels kRgbeSteps: how far the numbers that its pixel can hold lie from each other.
Image decoded_radiance_with_steps(std::string_view bytes);

}  // namespace orbs::image
