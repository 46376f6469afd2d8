#pragma once

#include <string>
#include <string_view>

namespace orbs::image {

/// The PNG file `bytes` reduced to what its pixels need (IHDR, PLTE, tRNS, IDAT, IEND), after checking that
/// it is whole: signature, plausible header, every length inside the file, every CRC right. InputError with
/// the reason otherwise. libpng prints each of these faults, and its doubts about colour profiles, to stderr
/// on its own; it is not asked.
std::string pixel_chunks(std::string_view bytes);

}  // namespace orbs::image
