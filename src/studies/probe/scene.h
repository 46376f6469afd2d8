#pragma once

#include "scene/scene.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// Id pass and uv pass of a scene, as scenes that any renderer can render. Surfaces only emit, so the images
/// depend on camera, geometry, matrices, material lists and texture coordinates, and on nothing else.
namespace orbs::studies {

/// An object with its own id: one material on one instance, or a light.
struct ProbeObject {
  std::string name;  // "instance 'teapot', material 'mirror'", "light 'lamp'"
  Vec3d radiance;    // the emitted colour, which is the id
};

/// Material i of the scene belongs to objects[i]; the lights' objects follow.
struct ProbeScene {
  scene::Scene scene;
  std::vector<ProbeObject> objects;
};

/// Reduces the image to at most `most_px` pixels at the longer side, with about its shape; a smaller one
/// stays.
void fit_camera(scene::Camera& camera, int most_px);

/// The scene with a camera of at most `most_px` pixels on the longer side, where each object emits a
/// different flat colour. A mesh with several instances gets its materials by remap lists. What moves rests
/// where it is as the shutter opens.
ProbeScene make_id_pass(const scene::Scene& original, int most_px);

/// Side of the ramp texture in texels.
inline constexpr int kRampSize = 256;

/// Writes the ramp texture of kRampSize^2 texels. The colour of a texel is the coordinate of its centre:
/// R = u, G = v, B = 1. An EXR of floats without compression: who writes a renderer reads it in a few lines;
/// and, for those that read no EXR, a PNG of 8 bits, encoded as sRGB.
void write_ramps(const std::filesystem::path& exr, const std::filesystem::path& png);

/// What 8 bits take off a value of the ramp at most: half the last step of sRGB's curve.
inline constexpr double kStepOfPng = 0.0045;

/// `probe` with all materials emitting the texture `ramp` instead of their ids: red is the fractional part of
/// u, green that of v. Lights are black. At the second coordinates (uv_set 1), what has none of them is
/// black.
scene::Scene make_uv_pass(const ProbeScene& probe, const std::filesystem::path& ramp, int uv_set = 0);

/// The same for renderers whose emission has no textures: the surfaces reflect the ramp diffusely, in a white
/// environment alone. How much of it a point sees is the same for all channels.
scene::Scene make_reflecting_uv_pass(const ProbeScene& probe,
                                     const std::filesystem::path& ramp,
                                     int uv_set = 0);

/// The probe with second coordinates in the place of the first: 0 everywhere on meshes that have none, which
/// is not compared. Nothing where no mesh has them.
std::optional<ProbeScene> at_second_coordinates(const ProbeScene& probe);

}  // namespace orbs::studies
