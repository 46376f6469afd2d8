#pragma once

#include "scene/scene.h"

#include <cstdint>
#include <filesystem>

namespace orbs::run {

/// Hash that changes whenever the image may: all of the scene's text, the camera that was chosen, its meshes,
/// and the files of its textures, IES profiles and tables of spectra.
std::uint64_t scene_content_hash(const scene::Scene& scene, const std::filesystem::path& file);

}  // namespace orbs::run
