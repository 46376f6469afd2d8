#pragma once

#include "base/nth.h"
#include "spectra/wavelengths.h"
#include "tracer/integrator/camera_connection.h"
#include "tracer/world/nearest_hits.h"

#include <cstdint>
#include <optional>

/// Light tracing, for paths that camera paths sample badly: the light first meets a near-specular surface
/// (SurfaceMaterial::is_near_specular), and the surface that the camera sees, directly or in a flat mirror,
/// is not near-specular or scatters in the tail of its lobe (kTailPdf). Camera paths skip exactly these paths
/// (is_left_to_light_paths), but for those that next-event estimation by way of a flat mirror samples. No
/// light path is traced if World::caustic_casters is empty. Particle tracing with the adjoint of the camera
/// paths' BSDFs (Veach 1997, ch. 4 and 5).
namespace orbs::tracer {

/// Russian roulette with the throughput as the survival probability, so that the surviving paths carry as
/// much light as at their start.
template <TracesFromLights T>
bool survives_light_roulette(LightPath<T>& path, const World& world, float u) {
  if (!world.roulette) return T::magnitude(path.throughput) > 0;
  const float probability = T::magnitude(path.throughput);
  if (probability >= 1) return true;
  if (u >= probability) return false;
  path.throughput = T::scaled(path.throughput, 1 / probability);
  return true;
}

/// Samples the BSDF at a hit; true if the path continues with a new ray.
template <TracesFromLights T>
bool scatter_light(LightPath<T>& path, SampleBlock block, const World& world, const SurfaceHit& surface) {
  const SurfacePoint& point = surface.point;
  const Vec3f to_light = -path.ray.direction;
  const float side = dot(point.shading_normal, to_light);
  if (!sides_agree(point.geometric_normal, point.shading_normal, to_light)) return false;
  const Frame frame = frame_around(side > 0 ? point.shading_normal : -point.shading_normal);
  const Vec3f from = frame.to_local(to_light);
  if (!(from.z > 0)) return false;  // by rounding at grazing angles
  const auto bounce = static_cast<std::uint32_t>(path.scatterings);
  typename T::Bsdf bsdf;
  make_bsdf<T>(bsdf, {world, surface, side > 0, path.lambda, path.throughput, block, path.index, bounce});
  const auto u = draw(block, path.index, bounce, SampleDimension::Scatter);
  const auto chosen = sample(bsdf, from, u);
  if (!chosen) return false;
  const Vec3f direction = frame.to_world(chosen->wi);
  if (!sides_agree(point.geometric_normal, point.shading_normal, direction)) return false;
  // The adjoint BSDF over the BSDF for shading normals (Veach 1997, eq. 5.19). Radiance is not compressed by
  // refraction on a light path, so that factor is divided out.
  const float adjoint = surface_cosine(point, direction) * from.z /
                        (std::abs(chosen->wi.z) * surface_cosine(point, to_light) * chosen->radiance_scale);
  path.throughput = path.throughput * (chosen->weight * adjoint);
  path.events.prepend(event_of(bsdf), chosen->is_transmitted);
  path.ray = {offset_origin(point.position, point.position_error, point.geometric_normal, direction),
              direction};
  ++path.scatterings;
  return survives_light_roulette<T>(path, world, u[3]);  // free: sample() uses three numbers at most
}

/// Connects the hit of the path's ray to the camera and scatters; true if the path continues with a new ray.
template <TracesFromLights T>
bool shade_light_path_hit(
    LightPathBatch<T>& batch, const World& world, std::uint32_t index, SampleBlock block, const Hit& hit) {
  LightPath<T>& path = batch.paths[index];
  if (hit.object == kNoHit || world.objects[hit.object].kind == ObjectKind::Light) return false;
  const SurfacePoint point = surface_point(world, path.ray, hit);
  const SurfaceMaterial& material = nth(world.materials, point.material);
  const bool is_emissive = std::holds_alternative<EmissionMaterial>(material.model);
  if (is_emissive || path.scatterings == world.trace_depth) return false;
  if (path.scatterings == 0) {
    if (!material.is_near_specular) return false;  // camera paths carry this light
    const Radiance radiance = emitted_towards(world, path.start, point.position);
    if (is_dark(radiance)) return false;
    path.emitted = T::radiance(world, radiance, path.lambda) * path.start.weight;
    path.began_at_flat_mirror = mirror_plane_of(world, hit.object, hit.primitive) >= 0;
  }
  // Camera paths sample this light themselves, by way of the mirror (sample_mirrored_light.h).
  if (path.scatterings == 1 && path.began_at_flat_mirror && !material.is_delta) return false;
  if (path.scatterings > 0 && !material.is_delta) {
    std::optional<Camera> at_lens;
    if (has_lens(world.camera)) {
      const auto u = draw(block, path.index, 0, SampleDimension::Lens);
      at_lens = seen_through(world.camera, u[0], u[1]);
    }
    const Camera& camera = at_lens ? *at_lens : world.camera;
    connect_to_camera<T>(batch, world, camera, path, block, {point, material, hit});
    connect_to_camera_by_mirrors<T>(batch, world, camera, index, block, {point, material, hit});
  }
  return scatter_light<T>(path, block, world, {point, material, hit});
}

template <TracesFromLights T>
void start_light_paths(LightPathBatch<T>& batch,
                       const World& world,
                       SampleBlock block,
                       std::uint32_t first,
                       std::uint32_t count) {
  batch.paths.assign(count, {});
  batch.active.clear();
  for (std::uint32_t i = 0; i < count; ++i) {
    LightPath<T>& path = batch.paths[i];
    path.index = first + i;
    // Light paths have their own random numbers (kLightSeed), so these two dimensions are free.
    path.start = emit(world, draw(block, path.index, 0, SampleDimension::PixelAndFirstLight),
                      draw(block, path.index, 0, SampleDimension::LightPick));
    path.ray = path.start.ray;
    path.throughput = T::start(world.camera, path.ray);  // 1: plain factors depend on neither
    path.lambda = T::sample_lambda([&] {
      const auto point = draw(block, path.index, 0, SampleDimension::Wavelength);
      return spectra::wavelength_number(point[0], point[1]);
    });
    if (path.start.weight > 0) batch.active.push_back(i);
  }
}

/// Traces the points [first, first + count) of the sample block and appends to batch.splats.
template <TracesFromLights T>
void trace_light_batch(LightPathBatch<T>& batch,
                       const World& world,
                       SampleBlock block,
                       std::uint32_t first,
                       std::uint32_t count) {
  start_light_paths(batch, world, block, first, count);
  while (!batch.active.empty()) {
    batch.rays.clear();
    for (const std::uint32_t path : batch.active) batch.rays.push_back(batch.paths[path].ray);
    batch.hits.resize(batch.rays.size());
    timed_traversal(batch, [&] { nearest_hits(world, batch.rays, batch.hits); });
    std::size_t alive = 0;
    for (std::size_t i = 0; i < batch.active.size(); ++i)
      if (shade_light_path_hit<T>(batch, world, batch.active[i], block, batch.hits[i]))
        batch.active[alive++] = batch.active[i];
    batch.active.resize(alive);
    resolve_mirror_rays(batch, world);
    resolve_shadow_rays(batch, world);
  }
}

}  // namespace orbs::tracer
