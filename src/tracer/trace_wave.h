#pragma once

#include "tracer/mirrored_light.h"

#include <span>

/// The path tracer: unidirectional, with next-event estimation and multiple importance sampling (Kajiya 1986;
/// Veach 1997, ch. 9). A wave of paths advances together, one scattering at a time, so that rays reach the
/// accelerator in full packets and scatter in full lanes. The result of a path does not depend on its
/// companions.
namespace orbs::tracer {

template <Transport T>
void add_emission(Wave<T>& wave, const World& world, PathState<T>& path, const MetEmission& met) {
  if (is_dark(met.radiance)) return;
  if (met.is_emitter && is_left_to_light_paths<T>(world, path) && !path.came_by_mirror) return;
  const float light_pdf = path.came_by_mirror ? met.light_pdf * path.mirror_chance : met.light_pdf;
  const float weight = path.scatter_pdf > 0 ? mis_weight(path.scatter_pdf, light_pdf) : 1;
  const auto light = T::radiance(world, met.radiance, path.lambda) * weight;
  add_light(wave, path, T::contribute(path.weight, light), path.events.index());
}

template <Transport T>
void add_environment(Wave<T>& wave, const World& world, PathState<T>& path) {
  if (is_dark(world.environment)) return;
  const auto light = T::radiance(world, world.environment, path.lambda);
  add_light(wave, path, T::contribute(path.weight, light), path.events.index());
}

/// Where the light that the path's ray meets was asked for, if it was.
template <Transport T>
Vec3f pdf_origin(const PathState<T>& path) {
  return path.came_by_mirror ? path.mirror_image : path.ray.origin;
}

/// What is_left_to_light_paths needs to know of the surface that the path is about to scatter at.
template <Transport T>
void note_sharpness(PathState<T>& path,
                    const World& world,
                    const SurfaceMaterial& material,
                    int mirror_plane) {
  if (path.scatterings == 0)
    path.began_at_flat_mirror =
        mirror_plane >= 0 &&
        is_before(world.mirror_planes[static_cast<std::size_t>(mirror_plane)], world.camera.position);
  const bool is_first = is_at_first_surface(path);
  path.met_sharp_beyond_first = material.is_sharp && !is_first;
  if (is_first) path.is_met_by_light_paths = !material.is_sharp;
}

/// Gives the path a lane, its scattering function left open.
template <Transport T>
std::size_t take_lane(VertexLanes<T>& vertices,
                      std::uint32_t index,
                      const Sample& sample,
                      const SurfacePoint& point,
                      Vec3f to_viewer) {
  const std::size_t lane = vertices.count++;
  const float side = dot(point.shading_normal, to_viewer);
  set_lane(vertices.position, lane, point.position);
  set_lane(vertices.geometric_normal, lane, point.geometric_normal);
  set_lane(vertices.shading_normal, lane, side > 0 ? point.shading_normal : -point.shading_normal);
  set_lane(vertices.to_viewer, lane, to_viewer);
  vertices.position_error[lane] = point.position_error;
  vertices.block[lane] = sample.block.seed;
  vertices.index[lane] = sample.index;
  vertices.path[lane] = index;
  vertices.mirror_plane[lane] = -1;
  vertices.own_light[lane] = -1;
  return lane;
}

/// What the path has met is a light, which may reflect as well.
template <Transport T>
void meet_light(Wave<T>& wave,
                const World& world,
                VertexLanes<T>& vertices,
                std::uint32_t index,
                const Sample& sample,
                const Hit& hit) {
  PathState<T>& path = wave.paths[index];
  const Part& part = world.parts[hit.part];
  add_emission<T>(wave, world, path, met_light(world, part, path.ray, hit, pdf_origin(path)));
  const AreaLight& light = world.lights[part.light];
  if (light.reflectance == Vec3f{} || path.scatterings == world.trace_depth) return;
  const SurfacePoint point = light_point(light, path.ray, hit);
  const Vec3f to_viewer = -path.ray.direction;
  if (!(dot(point.geometric_normal, to_viewer) > 0)) return;  // black from behind
  // No note_sharpness: where lights reflect there are no light paths (has_use_for_light_paths).
  const std::size_t lane = take_lane(vertices, index, sample, point, to_viewer);
  vertices.bsdf[lane] =
      LambertBsdf<typename T::Value>{T::reflectance(world, {light.reflectance}, path.lambda)};
  vertices.own_light[lane] = static_cast<int>(part.light);
  vertices.wants_light[lane] = !world.emitters.empty();
}

/// Handles what the path's ray has met. A path that is to scatter takes a lane; the others have ended.
template <Transport T>
void meet(Wave<T>& wave,
          const World& world,
          VertexLanes<T>& vertices,
          std::uint32_t index,
          const Sample& sample,
          const Hit& hit) {
  PathState<T>& path = wave.paths[index];
  if (hit.part == kNothing) {
    add_environment<T>(wave, world, path);
    return;
  }
  if (world.parts[hit.part].kind == PartKind::Light) {
    meet_light<T>(wave, world, vertices, index, sample, hit);
    return;
  }
  const SurfacePoint point = surface_point(world, path.ray, hit);
  const SurfaceMaterial& material = world.materials[static_cast<std::size_t>(point.material)];
  const MetSurface met{point, material, hit};
  if (material.model == Model::Emission) {
    add_emission<T>(wave, world, path, met_emissive_surface(world, met, path.ray, pdf_origin(path)));
    return;
  }
  if (path.scatterings == world.trace_depth) return;
  const Vec3f to_viewer = -path.ray.direction;
  const float side = dot(point.shading_normal, to_viewer);
  if (side == 0) return;  // exactly edge-on to the shading normal: nothing is reflected towards the viewer
  const int mirror_plane = world.mirror_planes.empty() ? -1 : mirror_plane_of(world, hit.part, hit.primitive);
  note_sharpness<T>(path, world, material, mirror_plane);
  const std::size_t lane = take_lane(vertices, index, sample, point, to_viewer);
  vertices.mirror_plane[lane] = mirror_plane;
  const auto bounce = static_cast<std::uint32_t>(path.scatterings);
  place_bsdf<T>(vertices.bsdf[lane], world, met, side > 0,
                {path.lambda, path.weight, sample.block, sample.index, bounce});
  vertices.wants_light[lane] =
      !world.emitters.empty() && !is_delta(vertices.bsdf[lane]) && !is_left_to_light_paths<T>(world, path);
}

template <Transport T>
void start_paths(Wave<T>& wave, const World& world, std::span<const Sample> samples) {
  wave.paths.resize(samples.size());
  wave.active.resize(samples.size());
  wave.classed.clear();
  for (std::uint32_t i = 0; i < samples.size(); ++i) {
    const auto u = draw(samples[i].block, samples[i].index, 0, Purpose::PixelAndFirstLight);
    PathState<T>& path = wave.paths[i];
    path = {};
    path.sample = i;
    path.first_light = {u[2], u[3]};
    path.ray = camera_ray(world.camera, static_cast<float>(samples[i].x) + u[0],
                          static_cast<float>(samples[i].y) + u[1]);
    path.weight = T::start(world.camera, path.ray);
    path.lambda =
        T::sample_lambda([&] { return draw(samples[i].block, samples[i].index, 0, Purpose::Wavelength)[0]; });
    wave.active[i] = i;
  }
}

template <Transport T>
void settle_shadows(Wave<T>& wave, const World& world) {
  wave.blocked.resize(wave.shadow_rays.size());
  timed_traversal(wave, [&] { world.accel->occluded(wave.shadow_rays, wave.blocked); });
  for (std::size_t i = 0; i < wave.shadows.size(); ++i)
    if (wave.blocked[i] == 0)
      add_light(wave, wave.paths[wave.shadows[i].path], wave.shadows[i].light, wave.shadows[i].path_class);
}

/// All paths of the lanes have scattered `bounce` times before.
template <Transport T>
void scatter_lanes(Wave<T>& wave, const World& world, const VertexLanes<T>& vertices, int bounce) {
  const auto frame = frame_around(vertices.shading_normal);
  const Vec8 wo = frame.to_local(vertices.to_viewer);
  ask_for_direct_light(wave, world, vertices, frame, wo, bounce);
  ask_for_mirrored_light(wave, world, vertices, frame, bounce);
  scatter(wave, world, vertices, frame, wo, bounce);
}

/// What the rays of all active paths have met, eight scatterings at a time.
template <Transport T>
void advance_all(Wave<T>& wave, const World& world, std::span<const Sample> samples, int bounce) {
  VertexLanes<T> vertices;
  for (std::size_t i = 0; i < wave.active.size(); ++i) {
    meet<T>(wave, world, vertices, wave.active[i], samples[wave.active[i]], wave.hits[i]);
    const bool is_last = i + 1 == wave.active.size();
    if (vertices.count < kLanes && !(is_last && vertices.count > 0)) continue;
    scatter_lanes<T>(wave, world, vertices, bounce);
    vertices.count = 0;
  }
}

/// Traces one path per sample. wave.paths[i].light is what samples[i] saw.
template <Transport T>
void trace_wave(Wave<T>& wave, const World& world, std::span<const Sample> samples) {
  start_paths(wave, world, samples);
  for (int bounce = 0; !wave.active.empty(); ++bounce) {
    wave.rays.clear();
    for (const std::uint32_t path : wave.active) wave.rays.push_back(wave.paths[path].ray);
    wave.hits.resize(wave.rays.size());
    timed_traversal(wave, [&] { world.accel->intersect(wave.rays, wave.hits); });
    wave.shadow_rays.clear();
    wave.shadows.clear();
    wave.survivors.clear();
    advance_all(wave, world, samples, bounce);
    wave.active.swap(wave.survivors);
    reflect_mirror_queries(wave, world);
    settle_shadows(wave, world);
  }
}

}  // namespace orbs::tracer
