#pragma once

#include "scene/scene.h"

#include <filesystem>
#include <string>
#include <vector>

/// Scenes turned into images of where things are. Nothing in them needs light, so what a renderer makes of
/// them shows how it understood camera, geometry, matrices and material lists, and nothing else.
namespace orbs::studies {

/// What a probe tells apart: one material on one instance, or a light.
struct Thing {
  std::string name;  // "instance 'teapot', material 'mirror'", "light 'lamp'"
  Vec3d radiance;    // that it emits
};

/// Material i of the scene belongs to things[i]; the lights' things come behind these.
struct ProbeScene {
  scene::Scene scene;
  std::vector<Thing> things;
};

/// The scene with a camera of at most `most_px` pixels on the longer side, and each thing emitting a flat
/// colour of its own. A mesh with several instances gets its materials by remap lists.
ProbeScene coloured_by_thing(const scene::Scene& original, int most_px);

/// Side of the image that coordinates are read from, in texels.
inline constexpr int kRampSize = 256;

/// Writes an image of kRampSize^2 texels whose colour is the coordinate of the texel's centre: R = u, G = v,
/// B = 1.
void write_ramp(const std::filesystem::path& file);

/// `probe` with all materials emitting `ramp` in place of their colour: red is the fraction of u, green that
/// of v. Lights are black.
scene::Scene coloured_by_coordinates(const ProbeScene& probe, const std::filesystem::path& ramp);

}  // namespace orbs::studies
