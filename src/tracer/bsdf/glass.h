#pragma once

#include "tracer/bsdf/fresnel.h"
#include "tracer/bsdf/bsdf_sample.h"

#include <array>
#include <optional>

namespace orbs::tracer {

/// ORB.S REQ_M8: reflection or refraction, chosen by the Fresnel reflectance. `eta` = index beyond the
/// surface over the index on the viewer's side, so that both sides follow physics. Radiance grows by eta^2
/// where light enters the denser side (Veach 1997, 5.2), hence 1 / eta^2 on a path from the camera.
template <typename Value>
struct GlassBsdf {
  static constexpr bool kIsDelta = true;
  static constexpr Event kEvent = Event::Specular;
  Value colour{};
  float eta = 1;
};

template <typename Value>
BsdfValue<Value> evaluate(const GlassBsdf<Value>&, Vec3f, Vec3f) {
  return {};
}

template <typename Value>
std::optional<BsdfSample<Value>> sample(const GlassBsdf<Value>& bsdf,
                                        Vec3f wo,
                                        const std::array<float, 4>& u) {
  BsdfSample<Value> out{.weight = bsdf.colour};
  if (u[2] < fresnel_dielectric(wo.z, bsdf.eta)) {
    out.wi = {-wo.x, -wo.y, wo.z};
    return out;
  }
  const auto wi = refracted(wo, {0, 0, 1}, bsdf.eta);
  if (!wi) return std::nullopt;  // grazing by rounding: Fresnel said less than total reflection
  out.wi = *wi;
  out.is_transmitted = true;
  out.radiance_scale = 1 / (bsdf.eta * bsdf.eta);
  out.weight = bsdf.colour * out.radiance_scale;
  return out;
}

}  // namespace orbs::tracer
