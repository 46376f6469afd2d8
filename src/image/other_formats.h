#pragma once

#include "image/contents.h"
#include "image/image.h"

#include <filesystem>
#include <string>

namespace orbs::image {

/// What is read of a file, and whether its numbers are display-encoded (8- or 16-bit integers).
struct Contents {
  Image image;
  bool is_ldr = false;
};

/// A file of one of the formats that are rare here, by the shared module of image/format_module.h: it is
/// loaded by the first such file, because loading OpenImageIO with its 260 libraries takes half a second.
/// Errors say what is wrong, without the file's name. InputError as read_image, and when the module is not
/// beside the program.
Contents read_other_format(const std::filesystem::path& file, const std::string& format, Wanted wanted);

}  // namespace orbs::image
