#pragma once

#include "base/nth.h"
#include "tracer/integrator/light_sampling.h"
#include "tracer/integrator/make_bsdf.h"
#include "tracer/integrator/path_batch.h"
#include "tracer/light/direct_light.h"
#include "tracer/numeric_fault.h"

/// What happens where the ray of a path ends: emission and environment are added, and a path that continues
/// becomes a vertex with its BSDF.
namespace orbs::tracer {

template <Transport T>
void add_emission(PathBatch<T>& batch, const World& world, PathState<T>& path, const EmissionHit& emission) {
  if (is_dark(emission.radiance)) return;
  // Light that next-event estimation samples by way of a flat mirror stays with camera paths: light paths end
  // there (shade_light_path_hit).
  if (emission.is_light_sampled && is_left_to_light_paths<T>(world, path) && !path.came_by_mirror) return;
  const float light_pdf =
      path.came_by_mirror ? emission.light_pdf * path.mirror_probability : emission.light_pdf;
  // A bsdf_pdf of zero: light sampling could not have found the emitter.
  const float weight = path.bsdf_pdf > 0 ? bsdf_weight(world.direct_light, path.bsdf_pdf, light_pdf,
                                                       path.connection_pdf * emission.emission_pdf)
                                         : 1;
  const auto light = T::radiance(world, emission.radiance, path.lambda) * weight;
  add_contribution(batch, path, T::contribute(path.throughput, light), path.events.index());
}

template <Transport T>
void add_environment(PathBatch<T>& batch, const World& world, PathState<T>& path) {
  if (!world.camera_sees_environment && path.scatterings == 0) return;
  if (world.environment_light >= 0) {
    add_emission<T>(batch, world, path,
                    emission_of_environment_map(world, path.ray.direction, path.light_sample));
    return;
  }
  if (is_dark(world.environment)) return;
  const auto light = T::radiance(world, world.environment, path.lambda);
  add_contribution(batch, path, T::contribute(path.throughput, light), path.events.index());
}

/// Records what is_left_to_light_paths needs to know of the surface at which the path is about to scatter.
template <Transport T>
void note_near_specular(PathState<T>& path,
                        const World& world,
                        const SurfaceMaterial& material,
                        int mirror_plane) {
  if (path.scatterings == 0)
    path.began_at_flat_mirror = mirror_plane >= 0 && is_in_front(nth(world.mirror_planes, mirror_plane),
                                                                 viewpoint_of(world.camera, path.ray));
  const bool is_first = is_at_first_surface(path);
  path.near_specular_beyond_first = material.is_near_specular && !is_first;
  if (is_first) path.is_reached_by_light_paths = !material.is_near_specular;
}

/// Records the density of the vertex that the path has reached, for the weights of connections to it. A delta
/// function cannot connect, nor can the camera, and near-specular surfaces are no light vertices.
template <Transport T>
void note_arrival(PathState<T>& path, const SurfaceHit& surface) {
  path.arrival_pdf = 0;
  if (!(path.bsdf_pdf > 0) || path.came_by_mirror || surface.material.is_near_specular) return;
  const float cosine = std::abs(dot(surface.point.geometric_normal, path.ray.direction));
  path.arrival_pdf = path.bsdf_pdf * cosine / (surface.hit.distance * surface.hit.distance);
}

/// Appends a vertex and returns its lane. The caller makes the BSDF.
template <Transport T>
std::size_t push_vertex(VertexLanes<T>& vertices,
                        std::uint32_t path,
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
  vertices.blocks.seeds[lane] = sample.block.seed;
  vertices.index[lane] = sample.index;
  vertices.path[lane] = path;
  vertices.mirror_plane[lane] = -1;
  vertices.own_light[lane] = -1;
  return lane;
}

/// The ray has hit a light, which may reflect as well.
template <Transport T>
void shade_light_hit(PathBatch<T>& batch,
                     const World& world,
                     VertexLanes<T>& vertices,
                     std::uint32_t index,
                     const Sample& sample,
                     const Hit& hit) {
  PathState<T>& path = batch.paths[index];
  const RenderObject& object = world.objects[hit.object];
  add_emission<T>(batch, world, path, emission_at_light(world, object, path.ray, hit, path.light_sample));
  const AreaLight& light = world.lights[object.light];
  if (light.reflectance == Vec3f{} || path.scatterings == world.trace_depth) return;
  const SurfacePoint point = light_point(light, path.ray, hit);
  const Vec3f to_viewer = -path.ray.direction;
  if (!(dot(point.geometric_normal, to_viewer) > 0)) return;  // lights are black from behind
  // note_near_specular is not needed: there are no light paths where lights reflect (supports_light_paths).
  const std::size_t lane = push_vertex(vertices, index, sample, point, to_viewer);
  vertices.bsdf[lane] =
      LambertBsdf<typename T::Value>{T::reflectance(world, {light.reflectance}, path.lambda)};
  vertices.own_light[lane] = static_cast<int>(object.light);
  vertices.samples_light[lane] = samples_lights(world);
}

/// Ends the path at the hit of its ray, or appends a vertex if it is to scatter there.
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
  const SurfaceMaterial& material = nth(world.materials, point.material);
  const SurfaceHit surface{point, material, hit};
  if (const auto* emission = std::get_if<EmissionMaterial>(&material.model)) {
    add_emission<T>(batch, world, path,
                    emission_at_surface(world, surface, *emission, path.ray, path.light_sample));
    return;
  }
  if (path.scatterings == world.trace_depth) return;
  const Vec3f to_viewer = -path.ray.direction;
  // A facet that is seen from behind at an interpolated normal in front would scatter to the far side of the
  // wall. At exactly grazing view nothing is reflected either.
  if (!sides_agree(point.geometric_normal, point.shading_normal, to_viewer)) return;
  if (has_fault(NumericFault::BackFacesBlack) && dot(point.geometric_normal, to_viewer) < 0) return;
  constexpr float kGrazing = 0.01F;
  if (has_fault(NumericFault::GrazingViewsBlack) &&
      std::abs(dot(point.geometric_normal, to_viewer)) < kGrazing)
    return;
  const float side = dot(point.shading_normal, to_viewer);
  const int mirror_plane =
      world.mirror_planes.empty() ? -1 : mirror_plane_of(world, hit.object, hit.primitive);
  note_near_specular<T>(path, world, material, mirror_plane);
  if (world.connects_light_vertices) note_arrival<T>(path, surface);
  const std::size_t lane = push_vertex(vertices, index, sample, point, to_viewer);
  vertices.mirror_plane[lane] = mirror_plane;
  const auto bounce = static_cast<std::uint32_t>(path.scatterings);
  make_bsdf<T>(vertices.bsdf[lane],
               {world, surface, side > 0, path.lambda, path.throughput, sample.block, sample.index, bounce});
  vertices.samples_light[lane] =
      samples_lights(world) && !is_delta(vertices.bsdf[lane]) && !is_left_to_light_paths<T>(world, path);
}

}  // namespace orbs::tracer
