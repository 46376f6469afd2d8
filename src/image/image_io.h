#pragma once

#include "image/image.h"

#include <filesystem>

namespace orbs::image {

enum class Precision { Half, Float };

/// Any format that OpenImageIO reads, channel names and text attributes kept, values as stored (no colour
/// conversion: an 8-bit 255 is 1.0). InputError with the reason when the file is missing, torn or no image.
Image read_image(const std::filesystem::path& file);

/// OpenEXR, ZIP-compressed, attributes in the header; written beside and renamed into place.
void write_exr(const Image& image, const std::filesystem::path& file, Precision precision = Precision::Float);

/// 8-bit PNG of the first three channels (or the first, as grey), taken as values in [0, 1] that are ready to
/// show.
void write_png(const Image& image, const std::filesystem::path& file);

/// True for file formats whose numbers are display-encoded (sRGB): 8- and 16-bit integer pixels.
bool is_ldr_file(const std::filesystem::path& file);

}  // namespace orbs::image
