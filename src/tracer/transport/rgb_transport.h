#pragma once

#include "tracer/bsdf/materials.h"
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
  static constexpr std::size_t kWavelengths = 1;
  static constexpr bool kHasAppearance = false;
  static constexpr bool kFluoresces = false;
  static constexpr bool kHasStokes = false;
  /// RGB is rendered where indices do not depend on the wavelength, or where effects may be lost: then the
  /// middle of the visible range stands for all.
  static std::array<float, 1> wavelengths_nm(Lambda) { return {550}; }
  static Lambda sample_lambda(const auto&) { return {}; }
  static void terminate_secondary(Lambda, const Throughput&) {}
  static Value reflectance(const World&, const Colour& colour, Lambda) { return colour.rgb; }
  static Value radiance(const World&, const Radiance& radiance, Lambda) { return radiance.rgb; }
  static Throughput start(const Camera&, const Ray&) { return {1, 1, 1}; }
  static Throughput chain(Throughput path, Value factor, const auto&) { return path * factor; }
  static Throughput scaled(Throughput path, float factor) { return path * factor; }
  static Contribution contribute(Throughput path, Value light) { return path * light; }
  static Contribution add(Contribution a, Contribution b) { return a + b; }
  static float magnitude(Throughput path) { return largest(path); }
  static Vec3f to_rgb(Contribution light, Lambda) { return light; }
};
static_assert(Transport<RgbTransport>);

/// The same for scenes with appearance materials.
struct RgbBoundaryTransport : RgbTransport {
  static constexpr bool kHasAppearance = true;
  using Bsdf = AnyBsdf<Vec3f, kWavelengths>;
};
static_assert(Transport<RgbBoundaryTransport>);

}  // namespace orbs::tracer
