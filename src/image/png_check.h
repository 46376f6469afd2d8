#pragma once

#include <string_view>

namespace orbs::image {

/// Checks that the PNG file `bytes` is whole: signature, possible header, every length inside the file, every
/// CRC right, critical chunks known and in order. InputError with the reason otherwise. libpng would find
/// each of these faults too, but prints it to stderr on its own; so it is asked only about files without
/// them.
void check_png(std::string_view bytes);

}  // namespace orbs::image
