#pragma once

#include "json/writer.h"
#include "scene/scene.h"

#include <string>

namespace orbs::adapters::obj {

/// The file of a lamp's IES profile beside the scene: "scene-lamp0.ies".
std::string profile_file(std::size_t lamp, const std::string& stem);

/// One lamp as an object of the description: its shape, size and matrix as the scene has them, and where that
/// is in the world.
void write_lamp(json::Writer& out, const scene::Light& light, std::size_t index, const std::string& stem);

}  // namespace orbs::adapters::obj
