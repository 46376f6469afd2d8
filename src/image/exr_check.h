#pragma once

#include <string_view>

namespace orbs::image {

/// Throws InputError (the problem alone, without the file's name) unless the header of this OpenEXR file
/// holds together and asks for no more memory than a file of this length can be about. OpenEXR 3.1 believes
/// every length that it reads, and each takes part in an allocation. What the numbers mean, the library
/// checks.
void check_exr(std::string_view bytes);

}  // namespace orbs::image
