#pragma once

#include "image/contents.h"
#include "image/image.h"

#include <string>
#include <string_view>

/// PNG files by libpng. Errors say what is wrong, without the file's name.
namespace orbs::image {

/// The file `bytes`: "Y" or "R", "G", "B", and "A"; palettes as their colours, integers as shares of the
/// largest, alpha not multiplied in, no gamma applied. Without pixels when only the header is wanted.
/// InputError as read_image.
Image decoded_png(std::string_view bytes, Wanted wanted);

/// The file that write_png writes. InputError for NaN.
std::string encoded_png(const Image& image);

}  // namespace orbs::image
