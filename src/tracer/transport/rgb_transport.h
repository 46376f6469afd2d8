#pragma once

#include "tracer/bsdf/bsdf.h"
#include "tracer/bsdf/boundary_bsdf.h"
#include "tracer/transport/transport.h"

namespace orbs::tracer {

struct NoWavelengths {};

/// Three channels of linear Rec.709 and nothing else.
struct RgbTransport {
  using Value = Vec3f;
  using Throughput = Vec3f;
  using Contribution = Vec3f;
  using Lambda = NoWavelengths;
  using Bsdf = OrbsBsdf<Vec3f>;
  static constexpr bool kHasStokes = false;
  static Lambda sample_lambda(const auto&) { return {}; }
  static Value reflectance(const World&, const Colour& colour, Lambda) { return colour.rgb; }
  static Value radiance(const World&, const Radiance& radiance, Lambda) { return radiance.rgb; }
  static Throughput start(const PinholeCamera&, const Ray&) { return {1, 1, 1}; }
  static Throughput chain(Throughput path, Value factor, const auto&) { return path * factor; }
  static Throughput scaled(Throughput weight, float factor) { return weight * factor; }
  static Contribution contribute(Throughput path, Value light) { return path * light; }
  static Contribution add(Contribution a, Contribution b) { return a + b; }
  static float magnitude(Throughput weight) { return largest(weight); }
  static Vec3f to_rgb(Contribution light, Lambda) { return light; }
};
static_assert(Transport<RgbTransport>);

/// The same for scenes with the interfaces of the appearance materials, whose indices are then the same at
/// all wavelengths.
struct RgbBoundaryTransport : RgbTransport {
  static constexpr std::size_t kWavelengths = 1;
  using Bsdf = BoundaryBsdf<Vec3f, kWavelengths>;
};
static_assert(Transport<RgbBoundaryTransport>);

}  // namespace orbs::tracer
