#pragma once

#include "adapters/exporter.h"
#include "scene/scene.h"

#include <filesystem>
#include <string>
#include <vector>

namespace orbs::adapters {

/// Writes the scene as glTF 2.0, all of it in one file (.glb). Instances share meshes; lights with an
/// area and the environment become meshes that shine (lights_as_meshes.h), points and directional light those
/// of KHR_lights_punctual; samples and seed come from the reader's command line, and
/// what glTF has no word for stands in the extras of the scene (gltf/document.h). Lower the scene first;
/// gltf_limits must be empty. InputError when a file cannot be read or written.
void write_gltf(const scene::Scene& scene, const std::filesystem::path& file);

/// glTF's row in the table of exporters.
Exporter gltf_exporter();

/// One reason for each thing in the scene that glTF cannot say as ORB.S means it; empty when there is none.
/// Reads textures; InputError when one cannot be read. Not among the limits: the specification's appendix B
/// has Schlick's formula in the place of Fresnel's for glass, as one way to compute what the index means.
std::vector<std::string> gltf_limits(const scene::Scene& scene);

}  // namespace orbs::adapters
