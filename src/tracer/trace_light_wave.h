#pragma once

#include "tracer/eye_queries.h"
#include "tracer/materials.h"
#include "tracer/trace_wave.h"

#include <cstdint>
#include <vector>

/// Paths from the lights: what they leave at a surface towards the camera is what World::light_path_targets
/// promises. Particle tracing with the adjoint of the camera paths' scattering (Veach 1997, ch. 4 and 5).
namespace orbs::tracer {

/// The path continues with the chance of what is left of its weight, so that the survivors carry as much
/// light as they began with.
template <TracesFromLights T>
bool survives_light_roulette(LightPath<T>& path, float u) {
  const float chance = T::magnitude(path.weight);
  if (chance >= 1) return true;
  if (u >= chance) return false;
  path.weight = T::scaled(path.weight, 1 / chance);
  return true;
}

template <TracesFromLights T>
bool scatter_light(LightPath<T>& path, SampleBlock block, const World& world, const MetSurface& met) {
  const SurfacePoint& point = met.point;
  const Vec3f to_light = -path.ray.direction;
  const float side = dot(point.shading_normal, to_light);
  if (side == 0 || !sides_agree(point.geometric_normal, point.shading_normal, to_light)) return false;
  const Frame frame = frame_around(side > 0 ? point.shading_normal : -point.shading_normal);
  const Vec3f from = frame.to_local(to_light);
  if (!(from.z > 0)) return false;
  const auto bounce = static_cast<std::uint32_t>(path.scatterings);
  typename T::Bsdf bsdf;
  place_bsdf<T>(bsdf, world, met, side > 0, {path.lambda, path.weight, block, path.index, bounce});
  const auto u = draw(block, path.index, bounce, Purpose::Scatter);
  const auto chosen = sample(bsdf, from, u);
  if (!chosen) return false;
  const Vec3f direction = frame.to_world(chosen->wi);
  // The eye's f |cos| over the light's: Veach 1997, eq. 5.19; and light does not change with the index of
  // refraction as radiance does.
  const float adjoint = surface_cosine(point, direction) * from.z /
                        (std::abs(chosen->wi.z) * surface_cosine(point, to_light) * chosen->radiance_scale);
  path.weight = path.weight * (chosen->weight * adjoint);
  path.events.add_before(event_of(bsdf), chosen->is_transmitted);
  path.ray = {offset_origin(point.position, point.position_error, point.geometric_normal, direction),
              direction};
  ++path.scatterings;
  return survives_light_roulette<T>(path, u[3]);
}

/// Handles what the path's ray has met; true when the path goes on with a new ray.
template <TracesFromLights T>
bool advance_light(
    LightWave<T>& wave, const World& world, std::uint32_t index, SampleBlock block, const Hit& hit) {
  LightPath<T>& path = wave.paths[index];
  if (hit.part == kNothing || world.parts[hit.part].kind == PartKind::Light) return false;
  const SurfacePoint point = surface_point(world, path.ray, hit);
  const SurfaceMaterial& material = world.materials[static_cast<std::size_t>(point.material)];
  if (material.model == Model::Emission || path.scatterings == world.trace_depth) return false;
  if (path.scatterings == 0) {
    if (!material.is_sharp) return false;  // camera paths bring this light
    const Radiance radiance = emitted_towards(world, path.start, point.position);
    if (is_dark(radiance)) return false;
    path.emitted = T::radiance(world, radiance, path.lambda) * path.start.weight;
    path.began_at_flat_mirror = mirror_plane_of(world, hit.part, hit.primitive) >= 0;
  }
  // Camera paths ask flat mirrors for light from wherever they can (mirrored_light.h).
  const bool is_specular = is_smooth(material);
  if (path.scatterings == 1 && path.began_at_flat_mirror && !is_specular) return false;
  if (path.scatterings > 0 && !is_specular) {
    ask_for_eye<T>(wave, world, path, {point, material, hit});
    ask_for_mirrored_eye<T>(wave, world, index, {point, material, hit});
  }
  return scatter_light<T>(path, block, world, {point, material, hit});
}

template <TracesFromLights T>
void start_light_paths(
    LightWave<T>& wave, const World& world, SampleBlock block, std::uint32_t first, std::uint32_t count) {
  wave.paths.assign(count, {});
  wave.active.clear();
  for (std::uint32_t i = 0; i < count; ++i) {
    LightPath<T>& path = wave.paths[i];
    path.index = first + i;
    path.start = emit(world, draw(block, path.index, 0, Purpose::PixelAndFirstLight),
                      draw(block, path.index, 0, Purpose::LightPick));
    path.ray = path.start.ray;
    path.weight = T::start(world.camera, path.ray);
    path.lambda = T::sample_lambda([&] { return draw(block, path.index, 0, Purpose::Wavelength)[0]; });
    if (path.start.weight > 0) wave.active.push_back(i);
  }
}

/// Traces the points [first, first + count) of the block and appends to wave.splats.
template <TracesFromLights T>
void trace_light_wave(
    LightWave<T>& wave, const World& world, SampleBlock block, std::uint32_t first, std::uint32_t count) {
  start_light_paths(wave, world, block, first, count);
  while (!wave.active.empty()) {
    wave.rays.clear();
    for (const std::uint32_t path : wave.active) wave.rays.push_back(wave.paths[path].ray);
    wave.hits.resize(wave.rays.size());
    timed_traversal(wave, [&] { world.accel->intersect(wave.rays, wave.hits); });
    wave.eye_rays.clear();
    wave.queries.clear();
    std::size_t alive = 0;
    for (std::size_t i = 0; i < wave.active.size(); ++i)
      if (advance_light<T>(wave, world, wave.active[i], block, wave.hits[i]))
        wave.active[alive++] = wave.active[i];
    wave.active.resize(alive);
    reflect_eye_queries(wave, world);
    settle_eye_queries(wave, world);
  }
}

}  // namespace orbs::tracer
