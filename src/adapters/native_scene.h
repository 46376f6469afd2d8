#pragma once

#include "registry/configuration.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

/// Scenes written by hand for one renderer, with all files that they need beside them: <folder of the neutral
/// scene>/<renderer>/<scene>.<native_scenes of its entry>.
namespace orbs::adapters {

/// The place of the renderer's own version of the scene; "" when its entry allows none.
std::filesystem::path native_scene_file(const registry::Renderer& renderer,
                                        const std::filesystem::path& neutral_file,
                                        const std::string& scene_name);

/// native_scene_file where it is there, else "".
std::filesystem::path native_scene(const registry::Renderer& renderer,
                                   const std::filesystem::path& neutral_file,
                                   const std::string& scene_name);

/// Hash of the names and bytes of all files in the folder of the scene: the scene may include any of them.
std::uint64_t native_scene_hash(const std::filesystem::path& native);

/// Copies the folder of the scene into `folder`, where it is rendered like an exported one. InputError for a
/// symbolic link or a device, which may lead out of the suite, and for a name that the render needs itself.
void copy_native_scene(const std::filesystem::path& native, const std::filesystem::path& folder);

}  // namespace orbs::adapters
