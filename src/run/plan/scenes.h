#pragma once

#include "results/record.h"
#include "run/plan/plan.h"
#include "scene/scene.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

/// A run at a reduced size: every scene is seen by its own camera with fewer pixels, so that an image of a
/// renderer with a box filter is, up to noise, the full image averaged over blocks of pixels.

namespace orbs::run {

/// The effects that the scene calls for, as results and `orbs effects` show them.
results::SceneRecord scene_record(const std::string& name, const scene::Scene& scene);

/// Hash that changes whenever the image may: all of the scene's text, the camera that was chosen, its meshes,
/// and the files of its textures, IES profiles and tables of spectra.
std::uint64_t scene_content_hash(const scene::Scene& scene, const std::filesystem::path& file);

/// Reads the scenes of the plan's cases, each once, at their full size.
void load_scenes(Plan& plan);

/// The scene that a target of the case shows, of a difference the first; nullptr where the plan has none.
const PlannedScene* scene_of_target(const Plan& plan,
                                    const registry::Case& one_case,
                                    const std::string& target);

/// Notes the hashes of the scenes by whose references the plan's scenes are judged. `all` cases of the suite,
/// because a scene may be judged by the reference of one that is not chosen.
void hash_references(const std::vector<registry::Case>& all, Plan& plan);

/// Divides the cameras of the plan's scenes and the regions of its cases for the run's size, each image by
/// what registry::divisor_of_image says.
void reduce_size(Plan& plan);

/// The samples per pixel of the scene's case, or more where at a reduced size its few pixels would get fewer
/// camera paths than their means need. A renderer without noise has no use for more.
int enough_spp(const PlannedScene& scene, const registry::Renderer& renderer);

/// Why the renderer's image of a target of the case, made from `scenes`, cannot be measured at the size of
/// the run; "" if it can. To be asked after reduce_size.
std::string why_not_at_size(const Plan& plan,
                            const registry::Renderer& renderer,
                            const registry::Case& one_case,
                            const std::string& target,
                            const std::vector<std::string>& scenes);

}  // namespace orbs::run
