#include "tracer/irradiance_cache/record.h"

#include <algorithm>
#include <cmath>

namespace orbs::tracer {

namespace {

// Rounding only: the exact value is not negative.
float one_minus_cosine(Vec3f a, Vec3f b) { return std::max(0.0F, 1 - dot(a, b)); }

bool is_ward(const scene::IrradianceCache& settings) { return settings.metric == scene::CacheMetric::Ward; }

}  // namespace

float unbounded_reach(const scene::IrradianceCache& settings, float distance) {
  return is_ward(settings) ? static_cast<float>(settings.error) * distance
                           : distance / (2 * static_cast<float>(settings.kappa));
}

float reach(const scene::IrradianceCache& settings, const IrradianceRecord& record) {
  // R- and R+ bound R_i / 2 of Tabellion and Lamorlette, before kappa divides it.
  const float unit = is_ward(settings) ? 1 : 1 / static_cast<float>(settings.kappa);
  return std::clamp(unbounded_reach(settings, record.distance), record.least_spacing * unit,
                    record.most_spacing * unit);
}

float relative_error(const scene::IrradianceCache& settings,
                     const IrradianceRecord& record,
                     const SurfaceElement& at) {
  const float by_distance = length(at.position - record.at.position) / reach(settings, record);
  const float by_angle = std::sqrt(one_minus_cosine(at.normal, record.at.normal));
  if (is_ward(settings)) return by_distance + by_angle / static_cast<float>(settings.error);
  constexpr float kOneMinusCos10Deg = 0.015192247F;
  return std::max(by_distance, static_cast<float>(settings.kappa) * by_angle / std::sqrt(kOneMinusCos10Deg));
}

bool is_behind(const IrradianceRecord& record, const SurfaceElement& at) {
  // On a sphere (p - p_i) (n + n_i) is zero. Facets with interpolated normals deviate by a part of the angle
  // between two facets: 1 degree is that of 360 facets around.
  constexpr float kDip = 0.0175F;
  const Vec3f from_record = at.position - record.at.position;
  const float height = dot(from_record, at.normal + record.at.normal) / 2;
  return height < -(kDip * length(from_record) + at.position_error + record.at.position_error);
}

float record_weight(const scene::IrradianceCache& settings, float relative_error) {
  return is_ward(settings) ? 1 / relative_error - 1 : 1 - relative_error;
}

Vec3f extrapolated(const IrradianceRecord& record, const SurfaceElement& at) {
  const Vec3f moved = at.position - record.at.position;
  const Vec3f turned = cross(record.at.normal, at.normal);
  const auto change = [&](std::size_t channel) {
    return dot(turned, record.rotation_gradient[channel]) + dot(moved, record.translation_gradient[channel]);
  };
  return record.irradiance + Vec3f{change(0), change(1), change(2)};
}

void limit_by_gradient(const scene::IrradianceCache& settings, IrradianceRecord& record) {
  auto& gradient = record.translation_gradient;
  const float steepness = length(gradient[0] + gradient[1] + gradient[2]);
  const float irradiance = record.irradiance.x + record.irradiance.y + record.irradiance.z;
  if (steepness * record.distance > irradiance) record.distance = irradiance / steepness;
  // Where the least spacing reaches farther than the distance allows, as in a corner whose rays are a
  // micrometre long, the gradient alone would lead to any value.
  const float most = irradiance * unbounded_reach(settings, 1);
  const float change = steepness * reach(settings, record);
  if (change > most)
    for (Vec3f& channel : gradient) channel *= most / change;
}

}  // namespace orbs::tracer
