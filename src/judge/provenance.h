#pragma once

#include "image/image.h"

#include <map>
#include <string>

/// The provenance record of an image: who made it and how, in its attributes "orbs.<key>".
namespace orbs::judge {

/// The provenance by key, without the prefix.
std::map<std::string, std::string> provenance_of(const image::Image& image);

/// Hash of size, channels and pixels, independent of the order of the channels: the "image_hash" of a
/// provenance record. The attributes are not in it, as they hold this hash.
std::string image_hash(const image::Image& image);

}  // namespace orbs::judge
