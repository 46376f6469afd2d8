#pragma once

#include "image/contents.h"
#include "image/image.h"

#include <string_view>

namespace orbs::image {

/// A portable float map (.pfm): "PF" or "Pf", width, height and scale, one blank or line end, and the floats
/// of all pixels, the last row first. InputError, without the name of a file, for what is none, for bytes
/// that are missing or too many, and for a scale other than 1 or -1, of which programs differ in what they
/// make.
Image decoded_pfm(std::string_view bytes, Wanted wanted);

}  // namespace orbs::image
