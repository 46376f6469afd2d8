#include "tracer/light/emitter.h"

namespace orbs::tracer {

std::optional<EmitterPoint> sample_towards(const EmitterShape& shape, Vec3f from, float u, float v) {
  return std::visit([&](const auto& s) { return sample_towards(s, from, u, v); }, shape);
}

float pdf_towards(const EmitterShape& shape, Vec3f from, Vec3f position) {
  return std::visit([&](const auto& s) { return pdf_towards(s, from, position); }, shape);
}

EmittingPoint point_on(const EmitterShape& shape, float u, float v) {
  return std::visit([&](const auto& s) { return point_on(s, u, v); }, shape);
}

float pdf_area(const EmitterShape& shape, Vec3f position) {
  return std::visit([&](const auto& s) { return pdf_area(s, position); }, shape);
}

Vec3f normal_of(const EmitterShape& shape, Vec3f position) {
  return std::visit([&](const auto& s) { return normal_of(s, position); }, shape);
}

float rounding_of(const EmitterShape& shape) {
  return std::visit([](const auto& s) { return rounding_of(s); }, shape);
}

float area_of(const EmitterShape& shape) {
  return std::visit([](const auto& s) { return s.area; }, shape);
}

bool has_area(const EmitterShape& shape) {
  return std::visit([](const auto& s) { return s.kHasArea; }, shape);
}

namespace {

// The share of what the light emits that goes in this direction, its profile aside.
float share_of_shape(const EmitterShape& shape, Vec3f position, Vec3f to_viewer) {
  return std::visit(
      [&](const auto& s) -> float {
        if constexpr (requires { share_towards(s, to_viewer); }) return share_towards(s, to_viewer);
        return shows_bright_side(s, position, to_viewer) ? 1.0F : 0.0F;
      },
      shape);
}

}  // namespace

Radiance radiance_towards(const AreaLight& light, Vec3f position, Vec3f to) {
  const Vec3f to_viewer = to - position;
  if (const auto* environment = std::get_if<EnvironmentEmitter>(&light.shape))
    return {light.radiance.rgb * radiance_from(*environment->map, -to_viewer)};
  const float of_shape = share_of_shape(light.shape, position, to_viewer);
  if (of_shape == 0) return {};
  if (!light.ies) return {light.radiance.rgb * of_shape, light.radiance.spectrum, of_shape};
  const Vec3f d = light.ies->point_area ? to - light.centre : to_viewer;
  const Vec3f local{dot(d, light.ies_axes[0]), dot(d, light.ies_axes[1]), dot(d, light.ies_axes[2])};
  const auto& profile = *light.ies->profile;
  const auto share =
      static_cast<float>(scene::candela_towards(profile, cast<double>(local)) / profile.max_candela);
  if (share == 0) return {};
  return {light.radiance.rgb * share, light.radiance.spectrum, share};
}

std::vector<LightBounds> bounds_of(const std::vector<AreaLight>& lights,
                                   const std::vector<TriangleEmitter>& triangles,
                                   const std::vector<float>& powers) {
  std::vector<LightBounds> out;
  for (const AreaLight& light : lights) {
    const float power = powers[out.size()];
    out.push_back(std::visit([&](const auto& shape) { return bounds_of(shape, power); }, light.shape));
    if (light.ies) out.back().cos_spread = -1;  // a profile may send its light to any side
  }
  for (const TriangleEmitter& triangle : triangles) out.push_back(bounds_of(triangle, powers[out.size()]));
  return out;
}

}  // namespace orbs::tracer
