#pragma once

#include "base/vec.h"
#include "tracer/geometry/transforms.h"

#include <cstdint>
#include <limits>

namespace orbs::tracer {

/// One scattering event of a path, for transports that need more than its factor. All directions point away
/// from the surface.
template <typename Bsdf>
struct Scattering {
  const Bsdf& bsdf;
  Frame frame;  // from the local frame of the BSDF to the world
  Vec3f to_viewer;
  Vec3f wo;  // to_viewer in the local frame
  Vec3f wi;  // towards the light, in the local frame
};

/// The events of Heckbert's light-path notation, as ORB.S REQ_A2 to A4 use it.
enum class Event : std::uint8_t { Diffuse, Specular, Glossy };

/// A sampled direction. Directions are in the local frame (z = shading normal on the viewer's side) and point
/// away from the surface.
template <typename Value>
struct BsdfSample {
  Vec3f wi{};
  Value weight{};  // f |cos| / pdf
  float pdf = 0;   // per solid angle; meaningless for delta functions
  bool is_transmitted = false;
  /// The part of `weight` that is the compression of radiance by 1 / eta^2, which refraction out of the
  /// medium undoes. Russian roulette divides it out (pbrt's etaScale).
  float radiance_scale = 1;
};

/// f |cos wi| and the pdf with which sample() chooses wi.
template <typename Value>
struct BsdfValue {
  Value f_cos{};
  float pdf = 0;
};

/// Names the BSDFs of a material, from which the variant of all BSDFs is made (materials.h).
template <typename... Bsdfs>
struct BsdfList {};

/// What lobe_alpha() says of materials without a specular or glossy lobe.
constexpr float kNoLobe = std::numeric_limits<float>::infinity();

/// What it says of materials that have a delta function beside or in place of other parts: no lobe is
/// narrower.
constexpr float kPartlyDelta = std::numeric_limits<float>::min();

}  // namespace orbs::tracer
