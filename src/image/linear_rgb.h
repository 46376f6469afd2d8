#pragma once

#include "image/image.h"

#include <filesystem>

namespace orbs::image {

/// An image that serves as a texture, as channels R, G, B in linear values: 8- and 16-bit files are sRGB and
/// decoded per pixel, float files are linear already; an image of one channel, with or without
/// alpha ("A"), is grey. InputError as read_image, and for two colours.
Image read_linear_rgb(const std::filesystem::path& file);

}  // namespace orbs::image
