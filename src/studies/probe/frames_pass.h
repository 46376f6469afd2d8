#pragma once

#include "studies/probe/compare.h"

#include <filesystem>
#include <optional>

/// The frames of normal maps: whether they lie along the texture coordinates. A point of light at the eye
/// shows all that the camera sees without a shadow; a map leans all normals to u or to v, and how much
/// brighter or darker a pixel becomes by it says where to they lean.
namespace orbs::studies {

/// Where the map leans all normals to.
enum class Lean { U, V };

/// Writes the map: PNG of 8 bits, 30 degrees and a part of one from the normal.
void write_leaning_map(Lean lean, const std::filesystem::path& file);

/// White surfaces and that light, with the map where the coordinates give directions, or without one. Nothing
/// where no surface has directions, or none is seen.
std::optional<scene::Scene> make_frames_pass(const ProbeScene& probe,
                                             const std::vector<VisibleSurface>& surfaces,
                                             const std::filesystem::path& map);

/// Compares the image with the map with that without. A pixel counts if one object covers it and a lean to
/// the other side would change it by far. Room is left for a tenth of the light, and for terms that soften
/// shadows on turned normals.
ProbeFindings compare_frames(const ProbeScene& probe,
                             const std::vector<VisibleSurface>& surfaces,
                             const image::Image& plain,
                             const image::Image& leaning,
                             Lean lean);

}  // namespace orbs::studies
