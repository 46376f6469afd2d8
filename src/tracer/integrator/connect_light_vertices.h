#pragma once

#include "base/nth.h"
#include "tracer/integrator/light_vertex.h"
#include "tracer/integrator/make_bsdf.h"
#include "tracer/integrator/path_batch.h"
#include "tracer/integrator/sample_direct_light.h"
#include "tracer/light/direct_light.h"

/// Connections of camera paths to the first hits of light paths: a third way to sample the last two segments
/// of a path, beside BSDF sampling followed by light sampling or by BSDF sampling. All three share the camera
/// path up to its vertex, so their densities differ in the last two segments alone, and the weights of MIS
/// need no other part of the path (Veach 1997, eq. 10.9 with all but the last factors cancelled).
namespace orbs::tracer {

/// The light vertex as the camera path's vertex in the unit direction `to_viewer` sees it.
template <Transport T>
struct LightVertexScattering {
  typename T::Value f_cos{};            // from the light to the viewer
  typename T::Throughput throughput{};  // of the camera path, whose wavelengths dispersion may end
  typename T::Value emitted{};          // radiance that arrives from the light
  float bsdf_pdf = 0;                   // of to_light, per solid angle
  float light_pdf = 0;                  // of light sampling there
  Event event = Event::Diffuse;
  bool is_transmitted = false;
};

template <Transport T>
std::optional<LightVertexScattering<T>> scattering_at(const World& world,
                                                      const LightVertex& vertex,
                                                      const PathState<T>& path,
                                                      Vec3f to_viewer) {
  const SurfacePoint& point = vertex.point;
  const float side = dot(point.shading_normal, to_viewer);
  if (!sides_agree(point.geometric_normal, point.shading_normal, to_viewer) ||
      !sides_agree(point.geometric_normal, point.shading_normal, vertex.to_light))
    return std::nullopt;
  const Frame frame = frame_around(side > 0 ? point.shading_normal : -point.shading_normal);
  const SurfaceMaterial& material = nth(world.materials, point.material);
  const Vec3f wo = frame.to_local(to_viewer);
  const Vec3f wi = frame.to_local(vertex.to_light);
  if (!(wo.z > 0)) return std::nullopt;  // by rounding at grazing angles
  LightVertexScattering<T> out;
  out.throughput = path.throughput;
  auto lambda = path.lambda;
  typename T::Bsdf bsdf;
  // No sample block: only fluorescence draws random numbers here, and it connects to no light paths.
  make_bsdf<T>(bsdf, {world, {point, material, vertex.hit}, side > 0, lambda, out.throughput, {}});
  const auto value = evaluate(bsdf, wo, wi);
  if (!(value.pdf > 0)) return std::nullopt;
  out.f_cos = value.f_cos;
  out.emitted = T::radiance(world, vertex.radiance, lambda);
  out.bsdf_pdf = value.pdf;
  out.event = event_of(bsdf);
  out.is_transmitted = wi.z < 0;
  const Vec3f normal = out.event == Event::Diffuse ? frame.z : Vec3f{};
  out.light_pdf = light_pdf(world, {point.position, normal}, vertex.emitter, vertex.light_position);
  return out;
}

/// The local frame of a vertex, and the direction to its viewer in it.
struct LocalView {
  Frame frame;
  Vec3f wo;
};

/// Appends a shadow ray from the vertex of this lane to a light vertex.
template <Transport T>
void connect_light_vertex(PathBatch<T>& batch,
                          const World& world,
                          const VertexLanes<T>& vertices,
                          std::size_t lane,
                          const LocalView& view,
                          const SelectedVertex& selected) {
  const LightVertex& vertex = selected.vertex;
  const PathState<T>& path = batch.paths[vertices.path[lane]];
  const Vec3f position = lane_of(vertices.position, lane);
  const Vec3f d = vertex.point.position - position;
  const float distance2 = dot(d, d);
  if (!(distance2 > 0)) return;
  const Vec3f direction = d / std::sqrt(distance2);
  const Vec3f geometric_normal = lane_of(vertices.geometric_normal, lane);
  if (!sides_agree(geometric_normal, view.frame.z, direction)) return;
  const Vec3f wi = view.frame.to_local(direction);
  const auto value = evaluate(vertices.bsdf[lane], view.wo, wi);
  const float cos_arrival = std::abs(dot(vertex.point.geometric_normal, direction));
  if (!(value.pdf > 0) || !(cos_arrival > 0)) return;
  const auto there = scattering_at<T>(world, vertex, path, -direction);
  if (!there) return;
  const float area_over_angle = cos_arrival / distance2;
  const float pdf = connection_pdf(vertex.emission_pdf, vertex.cos_light, value.pdf * area_over_angle);
  const float share = static_cast<float>(batch.light_vertices.vertices.size()) /
                      static_cast<float>(batch.light_vertices.traced);
  const float factor = selected.weight * share * mis_weight(pdf, there->light_pdf, there->bsdf_pdf) *
                       area_over_angle * kPi / (vertex.emission_pdf * vertex.cos_light);
  PathClass events = path.events;
  events.append(event_of(vertices.bsdf[lane]), wi.z < 0);
  events.append(there->event, there->is_transmitted);
  const auto throughput = T::chain(there->throughput, value.f_cos, [&] {
    return Scattering<typename T::Bsdf>{vertices.bsdf[lane], view.frame, lane_of(vertices.to_viewer, lane),
                                        view.wo, wi};
  });
  const Vec3f from = offset_origin(position, vertices.position_error[lane], geometric_normal, direction);
  const Vec3f to = offset_origin(vertex.point.position, vertex.point.position_error,
                                 vertex.point.geometric_normal, -direction);
  batch.shadow_rays.push_back({from, to - from, 1});
  batch.shadow_payloads.push_back({T::contribute(throughput, there->f_cos * there->emitted * factor),
                                   vertices.path[lane], events.index()});
}

template <Transport T>
void connect_light_vertices(PathBatch<T>& batch,
                            const World& world,
                            const VertexLanes<T>& vertices,
                            const FrameOf<Vec8>& frame,
                            Vec8 wo,
                            int bounce) {
  if (batch.light_vertices.vertices.empty() || bounce + 2 > world.trace_depth) return;
  for (std::size_t lane = 0; lane < vertices.count; ++lane) {
    if (is_delta(vertices.bsdf[lane])) continue;
    const auto selected = select_vertex(batch.light_vertices, light_sample_context(vertices, lane),
                                        vertices.path[lane], bounce);
    if (!selected) continue;
    const Frame lane_frame{lane_of(frame.x, lane), lane_of(frame.y, lane), lane_of(frame.z, lane)};
    connect_light_vertex<T>(batch, world, vertices, lane, {lane_frame, lane_of(wo, lane)}, *selected);
  }
}

}  // namespace orbs::tracer
