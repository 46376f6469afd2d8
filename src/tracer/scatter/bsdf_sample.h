#pragma once

#include "base/vec.h"

#include <cstdint>

namespace orbs::tracer {

enum class Event : std::uint8_t { Diffuse, Specular, Glossy };

/// A direction that a surface chose. Directions are in the local frame (z = shading normal on the viewer's
/// side) and point away from the surface.
template <typename Value>
struct BsdfSample {
  Vec3f wi{};
  Value weight{};  // f |cos| / pdf
  float pdf = 0;   // per solid angle; without meaning for delta functions
  bool is_transmitted = false;
  /// How much of `weight` is the change of radiance with the refractive index, which the way out of the
  /// medium undoes: Russian roulette looks at weight / radiance_scale.
  float radiance_scale = 1;
};

/// f |cos wi| and the pdf with which sample() would have chosen wi.
template <typename Value>
struct BsdfValue {
  Value f_cos{};
  float pdf = 0;
};

}  // namespace orbs::tracer
