#pragma once

#include "results/record.h"
#include "run/plan/plan.h"
#include "scene/scene.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace orbs::run {

/// The effects that the scene calls for, as results and `orbs effects` show them.
results::SceneRecord scene_record(const std::string& name, const scene::Scene& scene);

/// Hash that changes whenever the image may: all of the scene's text, the camera that was chosen, its meshes,
/// and the files of its textures, IES profiles and tables of spectra.
std::uint64_t scene_content_hash(const scene::Scene& scene, const std::filesystem::path& file);

/// Reads the scenes of the plan's cases, each once, at their full size.
void load_scenes(Plan& plan);

/// Notes the hashes of the scenes by whose references the plan's scenes are judged. `all` cases of the suite,
/// because a scene may be judged by the reference of one that is not chosen.
void hash_references(const std::vector<registry::Case>& all, Plan& plan);

}  // namespace orbs::run
