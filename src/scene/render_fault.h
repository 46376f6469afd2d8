#pragma once

#include "scene/scene.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Mistakes of renderers that no change of a finished image can make, as orbs-tracer --fault makes them on
/// purpose: a suite that is to find them must reject such images.
namespace orbs::scene {

enum class RenderFault {
  NormalsByMatrix,
  RawTextures,
  NoMisWeight,
  EmittersOnly,
  OneBounceLess,
  EnvironmentQuarterTurn,
  EnvironmentMirrored,
  RoughnessNotSquared,
  SpotFullAngles,
  LensDiameter,
  NormalMapFlipped,
  FramesWithoutSign,
  FramesWithSignOfMesh,
  OpacityInverted
};

struct RenderFaultInfo {
  RenderFault fault;
  std::string_view name;
  std::string_view what;
};

inline constexpr std::array kRenderFaults{
    RenderFaultInfo{RenderFault::NormalsByMatrix, "normals-by-matrix",
                    "vertex normals are mapped by the matrix of an instance, not by its inverse transpose"},
    RenderFaultInfo{RenderFault::RawTextures, "raw-textures",
                    "textures of 8 and 16 bits are not decoded from sRGB"},
    RenderFaultInfo{RenderFault::NoMisWeight, "no-mis-weight",
                    "light sampling and BSDF sampling both count in full, without the weights of multiple "
                    "importance sampling"},
    RenderFaultInfo{RenderFault::EmittersOnly, "emitters-only", "no surface reflects: a trace depth of 0"},
    RenderFaultInfo{RenderFault::OneBounceLess, "one-bounce-less", "the trace depth is one less"},
    RenderFaultInfo{RenderFault::EnvironmentQuarterTurn, "environment-quarter-turn",
                    "the environment map is turned about y by a quarter"},
    RenderFaultInfo{RenderFault::EnvironmentMirrored, "environment-mirrored",
                    "the environment map is mirrored from left to right"},
    RenderFaultInfo{RenderFault::RoughnessNotSquared, "roughness-not-squared",
                    "alpha is the root of what it should be: a roughness is taken for its square"},
    RenderFaultInfo{RenderFault::SpotFullAngles, "spot-full-angles",
                    "the half angles of spots are taken for full ones: cones are twice as narrow"},
    RenderFaultInfo{RenderFault::LensDiameter, "lens-diameter",
                    "the radius of the lens is taken for its diameter: half the blur"},
    RenderFaultInfo{RenderFault::NormalMapFlipped, "normal-map-flipped",
                    "the green of normal maps points towards falling v"},
    RenderFaultInfo{RenderFault::FramesWithoutSign, "frames-without-sign",
                    "in the frames of normal maps v grows to normal x u, where something mirrors them, too"},
    RenderFaultInfo{RenderFault::FramesWithSignOfMesh, "frames-with-sign-of-mesh",
                    "the frames of normal maps have the sign of the mesh, where a matrix mirrors it, too"},
    RenderFaultInfo{RenderFault::OpacityInverted, "opacity-inverted",
                    "what should let rays pass is opaque, and the reverse"}};

std::string_view name_of(RenderFault fault);
std::vector<std::string> render_fault_names();
/// Nothing for a name that there is not.
std::optional<RenderFault> render_fault_named(std::string_view name);

/// Why the fault cannot change the image: "it has no texture of 8 or 16 bits"; "" where it can.
std::string why_fault_changes_nothing(const Scene& scene, RenderFault fault);

/// The scene of which a right renderer makes the image that one with the fault makes of `scene`: other
/// normals, another trace depth. Of the faults that are made of the world or of its paths, `scene` itself, or
/// what the world asks of it: of frames with wrong signs, materials by their frames (mirrored_frames.h).
Scene with_fault(Scene scene, RenderFault fault);

}  // namespace orbs::scene
