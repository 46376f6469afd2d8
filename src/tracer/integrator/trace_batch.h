#pragma once

#include "tracer/integrator/mirrored_light.h"

#include <span>

/// The path tracer: unidirectional, with next-event estimation and multiple importance sampling (Kajiya 1986;
/// Veach 1997, ch. 9). A batch of paths advances together, one scattering at a time, so that rays reach the
/// accelerator in full packets and scatter in full lanes. The result of a path does not depend on its
/// companions.
namespace orbs::tracer {

template <Transport T>
void add_emission(PathBatch<T>& batch, const World& world, PathState<T>& path, const EmissionHit& emission) {
  if (is_dark(emission.radiance)) return;
  if (emission.is_emitter && is_left_to_light_paths<T>(world, path) && !path.came_by_mirror) return;
  const float light_pdf = path.came_by_mirror ? emission.light_pdf * path.mirror_probability : emission.light_pdf;
  const float weight = path.bsdf_pdf > 0 ? mis_weight(path.bsdf_pdf, light_pdf) : 1;
  const auto light = T::radiance(world, emission.radiance, path.lambda) * weight;
  add_contribution(batch, path, T::contribute(path.throughput, light), path.events.index());
}

template <Transport T>
void add_environment(PathBatch<T>& batch, const World& world, PathState<T>& path) {
  if (is_dark(world.environment)) return;
  const auto light = T::radiance(world, world.environment, path.lambda);
  add_contribution(batch, path, T::contribute(path.throughput, light), path.events.index());
}

/// Where the light that the path's ray meets was asked for, if it was.
template <Transport T>
Vec3f pdf_origin(const PathState<T>& path) {
  return path.came_by_mirror ? path.mirrored_vertex : path.ray.origin;
}

/// What is_left_to_light_paths needs to know of the surface that the path is about to scatter at.
template <Transport T>
void note_near_specular(PathState<T>& path,
                    const World& world,
                    const SurfaceMaterial& material,
                    int mirror_plane) {
  if (path.scatterings == 0)
    path.began_at_flat_mirror =
        mirror_plane >= 0 &&
        is_before(world.mirror_planes[static_cast<std::size_t>(mirror_plane)], world.camera.position);
  const bool is_first = is_at_first_surface(path);
  path.near_specular_beyond_first = material.is_near_specular && !is_first;
  if (is_first) path.is_reached_by_light_paths = !material.is_near_specular;
}

/// Gives the path a lane, its scattering function left open.
template <Transport T>
std::size_t push_vertex(VertexLanes<T>& vertices,
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
void shade_light_hit(PathBatch<T>& batch,
                const World& world,
                VertexLanes<T>& vertices,
                std::uint32_t index,
                const Sample& sample,
                const Hit& hit) {
  PathState<T>& path = batch.paths[index];
  const RenderObject& object = world.objects[hit.object];
  add_emission<T>(batch, world, path, emission_at_light(world, object, path.ray, hit, pdf_origin(path)));
  const AreaLight& light = world.lights[object.light];
  if (light.reflectance == Vec3f{} || path.scatterings == world.trace_depth) return;
  const SurfacePoint point = light_point(light, path.ray, hit);
  const Vec3f to_viewer = -path.ray.direction;
  if (!(dot(point.geometric_normal, to_viewer) > 0)) return;  // black from behind
  // No note_near_specular: where lights reflect there are no light paths (has_use_for_light_paths).
  const std::size_t lane = push_vertex(vertices, index, sample, point, to_viewer);
  vertices.bsdf[lane] =
      LambertBsdf<typename T::Value>{T::reflectance(world, {light.reflectance}, path.lambda)};
  vertices.own_light[lane] = static_cast<int>(object.light);
  vertices.wants_light[lane] = !world.emitters.empty();
}

/// Handles what the path's ray has met. A path that is to scatter takes a lane; the others have ended.
template <Transport T>
void shade_hit(PathBatch<T>& batch,
          const World& world,
          VertexLanes<T>& vertices,
          std::uint32_t index,
          const Sample& sample,
          const Hit& hit) {
  PathState<T>& path = batch.paths[index];
  if (hit.object == kNoHit) {
    add_environment<T>(batch, world, path);
    return;
  }
  if (world.objects[hit.object].kind == ObjectKind::Light) {
    shade_light_hit<T>(batch, world, vertices, index, sample, hit);
    return;
  }
  const SurfacePoint point = surface_point(world, path.ray, hit);
  const SurfaceMaterial& material = world.materials[static_cast<std::size_t>(point.material)];
  const SurfaceHit surface{point, material, hit};
  if (material.model == Model::Emission) {
    add_emission<T>(batch, world, path, emission_at_surface(world, surface, path.ray, pdf_origin(path)));
    return;
  }
  if (path.scatterings == world.trace_depth) return;
  const Vec3f to_viewer = -path.ray.direction;
  const float side = dot(point.shading_normal, to_viewer);
  if (side == 0) return;  // exactly edge-on to the shading normal: nothing is reflected towards the viewer
  const int mirror_plane = world.mirror_planes.empty() ? -1 : mirror_plane_of(world, hit.object, hit.primitive);
  note_near_specular<T>(path, world, material, mirror_plane);
  const std::size_t lane = push_vertex(vertices, index, sample, point, to_viewer);
  vertices.mirror_plane[lane] = mirror_plane;
  const auto bounce = static_cast<std::uint32_t>(path.scatterings);
  make_bsdf<T>(vertices.bsdf[lane], world, surface, side > 0,
                {path.lambda, path.throughput, sample.block, sample.index, bounce});
  vertices.wants_light[lane] =
      !world.emitters.empty() && !is_delta(vertices.bsdf[lane]) && !is_left_to_light_paths<T>(world, path);
}

template <Transport T>
void start_paths(PathBatch<T>& batch, const World& world, std::span<const Sample> samples) {
  batch.paths.resize(samples.size());
  batch.active.resize(samples.size());
  batch.classed.clear();
  for (std::uint32_t i = 0; i < samples.size(); ++i) {
    const auto u = draw(samples[i].block, samples[i].index, 0, SampleDimension::PixelAndFirstLight);
    PathState<T>& path = batch.paths[i];
    path = {};
    path.sample = i;
    path.first_light_sample = {u[2], u[3]};
    path.ray = camera_ray(world.camera, static_cast<float>(samples[i].x) + u[0],
                          static_cast<float>(samples[i].y) + u[1]);
    path.throughput = T::start(world.camera, path.ray);
    path.lambda =
        T::sample_lambda([&] { return draw(samples[i].block, samples[i].index, 0, SampleDimension::Wavelength)[0]; });
    batch.active[i] = i;
  }
}

template <Transport T>
void resolve_shadow_rays(PathBatch<T>& batch, const World& world) {
  batch.blocked.resize(batch.shadow_rays.size());
  timed_traversal(batch, [&] { world.accel->occluded(batch.shadow_rays, batch.blocked); });
  for (std::size_t i = 0; i < batch.shadows.size(); ++i)
    if (batch.blocked[i] == 0)
      add_contribution(batch, batch.paths[batch.shadows[i].path], batch.shadows[i].light, batch.shadows[i].path_class);
}

/// All paths of the lanes have scattered `bounce` times before.
template <Transport T>
void scatter_vertices(PathBatch<T>& batch, const World& world, const VertexLanes<T>& vertices, int bounce) {
  const auto frame = frame_around(vertices.shading_normal);
  const Vec8 wo = frame.to_local(vertices.to_viewer);
  sample_direct_light(batch, world, vertices, frame, wo, bounce);
  sample_mirrored_light(batch, world, vertices, frame, bounce);
  scatter(batch, world, vertices, frame, wo, bounce);
}

/// What the rays of all active paths have met, eight scatterings at a time.
template <Transport T>
void shade_batch(PathBatch<T>& batch, const World& world, std::span<const Sample> samples, int bounce) {
  VertexLanes<T> vertices;
  for (std::size_t i = 0; i < batch.active.size(); ++i) {
    shade_hit<T>(batch, world, vertices, batch.active[i], samples[batch.active[i]], batch.hits[i]);
    const bool is_last = i + 1 == batch.active.size();
    if (vertices.count < kLanes && !(is_last && vertices.count > 0)) continue;
    scatter_vertices<T>(batch, world, vertices, bounce);
    vertices.count = 0;
  }
}

/// Traces one path per sample. batch.paths[i].light is what samples[i] saw.
template <Transport T>
void trace_batch(PathBatch<T>& batch, const World& world, std::span<const Sample> samples) {
  start_paths(batch, world, samples);
  for (int bounce = 0; !batch.active.empty(); ++bounce) {
    batch.rays.clear();
    for (const std::uint32_t path : batch.active) batch.rays.push_back(batch.paths[path].ray);
    batch.hits.resize(batch.rays.size());
    timed_traversal(batch, [&] { world.accel->intersect(batch.rays, batch.hits); });
    batch.shadow_rays.clear();
    batch.shadows.clear();
    batch.survivors.clear();
    shade_batch(batch, world, samples, bounce);
    batch.active.swap(batch.survivors);
    resolve_mirror_rays(batch, world);
    resolve_shadow_rays(batch, world);
  }
}

}  // namespace orbs::tracer
