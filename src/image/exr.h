#pragma once

#include "image/contents.h"
#include "image/image.h"

#include <string>
#include <string_view>

/// OpenEXR files by the OpenEXR library. Errors say what is wrong, without the file's name.
namespace orbs::image {

/// The first part of the file `bytes`, "R", "G", "B" first in each layer; without pixels when only the header
/// is wanted. `name` is for the library's messages. InputError as read_image.
Image decoded_exr(const std::string& name, std::string_view bytes, Wanted wanted);

/// The file that write_exr writes. The channels are named, each once; with halves no value is beyond them.
std::string encoded_exr(const Image& image, Precision precision, Compression compression);

}  // namespace orbs::image
