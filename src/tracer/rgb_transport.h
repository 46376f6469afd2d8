#pragma once

#include "tracer/scatter/bsdf.h"
#include "tracer/scatter/interface_bsdf.h"
#include "tracer/transport.h"

namespace orbs::tracer {

struct NoWavelengths {};

/// Three channels of linear Rec.709 and nothing else.
struct RgbTransport {
  using Value = Vec3f;
  using Weight = Vec3f;
  using Light = Vec3f;
  using Lambda = NoWavelengths;
  using Bsdf = OrbsBsdf<Vec3f>;
  static constexpr bool kHasStokes = false;
  static Lambda sample_lambda(const auto&) { return {}; }
  static Value reflectance(const World&, const Colour& colour, Lambda) { return colour.rgb; }
  static Value radiance(const World&, const Radiance& radiance, Lambda) { return radiance.rgb; }
  static Weight start(const PinholeCamera&, const Ray&) { return {1, 1, 1}; }
  static Weight chain(Weight path, Value factor, const auto&) { return path * factor; }
  static Weight scaled(Weight weight, float factor) { return weight * factor; }
  static Light contribute(Weight path, Value light) { return path * light; }
  static Light add(Light a, Light b) { return a + b; }
  static float magnitude(Weight weight) { return largest(weight); }
  static Vec3f to_rgb(Light light, Lambda) { return light; }
};
static_assert(Transport<RgbTransport>);

/// The same for scenes with the interfaces of the appearance materials, whose indices are then the same at
/// all wavelengths.
struct RgbInterfaceTransport : RgbTransport {
  static constexpr std::size_t kWavelengths = 1;
  using Bsdf = InterfaceBsdf<Vec3f, kWavelengths>;
};
static_assert(Transport<RgbInterfaceTransport>);

}  // namespace orbs::tracer
