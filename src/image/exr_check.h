#pragma once

#include <string_view>

namespace orbs::image {

/// Throws InputError (the problem alone, without the file's name) unless the header of this OpenEXR file
/// holds together, asks for no more memory than a file of this length can be about, and states no other
/// primaries than Rec.709's and no other pixels than square ones. OpenEXR 3.1 believes
/// every length that it reads, and each takes part in an allocation.
void check_exr(std::string_view bytes);

/// No format of ours packs more values into a byte. The densest is an OpenEXR file of one colour with DWA
/// compression: 4 bytes for each 8 x 8 block, by deflate at best 1032 times shorter, are 16512 values a byte.
constexpr double kMostValuesPerByte = 32768;

}  // namespace orbs::image
