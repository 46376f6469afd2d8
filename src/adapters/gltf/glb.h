#pragma once

#include <string>
#include <string_view>

namespace orbs::adapters::gltf {

/// A JSON and the buffer that it describes, which may be empty, as one file (.glb). InputError when it would
/// have more than 4 GiB, which the format cannot count.
std::string glb(std::string_view json, std::string_view buffer);

}  // namespace orbs::adapters::gltf
