#pragma once

#include "tracer/frame.h"
#include "tracer/path_class.h"
#include "tracer/sampler.h"
#include "tracer/sampling.h"
#include "tracer/surface.h"
#include "tracer/transport.h"
#include "tracer/world.h"

#include <algorithm>
#include <cassert>
#include <chrono>
#include <cstdint>
#include <span>
#include <vector>

/// The path tracer: unidirectional, with next-event estimation and multiple importance sampling (Kajiya 1986;
/// Veach 1997, ch. 9). A wave of paths advances together, one scattering at a time, so that rays reach the
/// accelerator in full packets. The result of a path does not depend on its companions.
namespace orbs::tracer {

/// One camera sample.
struct Sample {
  int x = 0;
  int y = 0;
  SampleBlock block;
  std::uint32_t index = 0;  // within the block
};

/// Where a part of a sample's radiance came from, for --split-paths.
struct ClassedLight {
  std::uint32_t sample = 0;
  int path_class = 0;
  Vec3f radiance;
};

template <Transport T>
struct PathState {
  typename T::Weight weight = T::one();
  typename T::Light light{};
  [[no_unique_address]] typename T::Lambda lambda{};
  Ray ray;
  std::uint32_t sample = 0;
  float scatter_pdf = 0;  // of ray.direction; 0 where light sampling could not have found what the ray meets
  float radiance_scale = 1;  // see BsdfSample
  int scatterings = 0;
  bool first_is_sharp = false;  // of the surfaces that the path has scattered at
  bool last_is_sharp = false;
  PathClass events;
  Vec2f first_light;  // the half of the first set of numbers that the pixel position leaves
};

template <Transport T>
struct ShadowQuery {
  typename T::Light light{};  // arrives when nothing is in between
  std::uint32_t path = 0;
  int path_class = 0;
};

/// Scratch memory of a wave, reused from wave to wave.
template <Transport T>
struct Wave {
  std::vector<PathState<T>> paths;
  std::vector<std::uint32_t> active;
  std::vector<Ray> rays;
  std::vector<Hit> hits;
  std::vector<Ray> shadow_rays;
  std::vector<ShadowQuery<T>> shadows;
  std::vector<std::uint8_t> blocked;
  std::vector<ClassedLight> classed;  // filled when split_paths
  bool split_paths = false;
  double traversal_seconds = 0;  // spent inside the accelerator, all waves together
};

template <Transport T>
void add_light(Wave<T>& wave, PathState<T>& path, const typename T::Light& light, int path_class) {
  path.light = T::add(path.light, light);
  if (wave.split_paths) wave.classed.push_back({path.sample, path_class, T::to_rgb(light, path.lambda)});
}

/// The scattering function of a material at a point, seen from outside (where the vertex normal points) or
/// inside.
template <Transport T>
Bsdf<typename T::Value> bsdf_at(const World& world,
                                const SurfaceMaterial& material,
                                const Hit& hit,
                                bool is_outside,
                                const typename T::Lambda& lambda) {
  using Value = typename T::Value;
  Vec3f rgb = material.colour;
  if (material.texture >= 0)
    rgb *= lookup(world.textures[static_cast<std::size_t>(material.texture)],
                  apply(material.uv, texture_coordinates(world, hit)));
  const Value colour = T::from_rgb(rgb, lambda);
  const float eta = is_outside ? material.ior : 1 / material.ior;
  switch (material.model) {
    case Model::Lambert:
      return LambertBsdf<Value>{colour};
    case Model::OrenNayar:
      return make_oren_nayar(colour, material.roughness);
    case Model::Mirror:
      return MirrorBsdf<Value>{colour};
    case Model::Glass:
      return GlassBsdf<Value>{colour, eta};
    case Model::Ggx:
      return GgxBsdf<Value>{colour, material.alpha};
    case Model::RoughGlass:
      return RoughGlassBsdf<Value>{colour, eta, material.alpha};
    case Model::Emission:
      break;
  }
  assert(false && "emissive surfaces end the path before they scatter");
  return LambertBsdf<Value>{};
}

/// Radiance that the surface met by the path's ray sends back along it, and the chance per solid angle that
/// light sampling at the ray's origin would have picked that direction.
struct MetEmission {
  Vec3f radiance;
  float light_pdf = 0;
};

MetEmission met_light(const World& world, const Part& part, const Ray& ray, const Hit& hit);
MetEmission met_emissive_surface(const World& world,
                                 const SurfacePoint& point,
                                 const SurfaceMaterial& material,
                                 const Ray& ray,
                                 const Hit& hit);

/// Light that comes out of a sharp surface and reaches the camera from one that is not: light paths bring it
/// (see World::light_path_targets).
template <Transport T>
bool is_left_to_light_paths(const World& world, const PathState<T>& path) {
  return path.last_is_sharp && !path.first_is_sharp && !world.light_path_targets.empty();
}

template <Transport T>
void add_emission(Wave<T>& wave, PathState<T>& path, const MetEmission& met) {
  if (met.radiance == Vec3f{}) return;
  const float weight = path.scatter_pdf > 0 ? mis_weight(path.scatter_pdf, met.light_pdf) : 1;
  const auto light = T::unpolarised(T::from_rgb(met.radiance * weight, path.lambda));
  add_light(wave, path, T::contribute(path.weight, light), path.events.index());
}

/// A light sample as the shading point sees it.
struct DirectLight {
  Vec3f radiance;
  Vec3f target;   // end of the shadow ray, off the light's surface
  float pdf = 0;  // per solid angle, choice of the light included
};

std::optional<DirectLight> sample_light(const World& world, Vec3f from, float pick, float u, float v);

/// Numbers for choosing a light and a point on it. The first point shares its set with the pixel position:
/// stratifying the four together is what keeps the fast convergence of direct light.
template <Transport T>
std::array<float, 3> light_numbers(const World& world, const PathState<T>& path, const Sample& sample) {
  const auto bounce = static_cast<std::uint32_t>(path.scatterings);
  if (bounce == 0) {
    const float pick =
        world.emitters.size() > 1 ? draw(sample.block, sample.index, 0, Purpose::LightPick)[0] : 0;
    return {pick, path.first_light.x, path.first_light.y};
  }
  const auto u = draw(sample.block, sample.index, bounce, Purpose::Light);
  return {u[0], u[1], u[2]};
}

/// Where a path scatters.
struct Vertex {
  SurfacePoint point;
  Frame frame;  // z = shading normal on the viewer's side
  Vec3f wo;     // local
};

/// True where a direction lies on the same side of the real surface as of the shading normal: the others
/// would pass through an opaque surface, or count as reflection what goes through.
inline bool sides_agree(const SurfacePoint& point, Vec3f shading_normal, Vec3f direction) {
  const float along_geometry = dot(point.geometric_normal, direction) *
                               (dot(point.geometric_normal, shading_normal) < 0 ? -1.0F : 1.0F);
  return along_geometry * dot(shading_normal, direction) > 0;
}

template <Transport T, typename B>
void ask_for_direct_light(Wave<T>& wave,
                          const World& world,
                          std::uint32_t index,
                          const Sample& sample,
                          const Vertex& vertex,
                          const B& bsdf) {
  const PathState<T>& path = wave.paths[index];
  const auto [pick, u, v] = light_numbers<T>(world, path, sample);
  const auto light = sample_light(world, vertex.point.position, pick, u, v);
  if (!light) return;
  const Vec3f direction = normalised(light->target - vertex.point.position);
  const Vec3f wi = vertex.frame.to_local(direction);
  const auto value = evaluate(bsdf, vertex.wo, wi);
  if (!(value.pdf > 0) || !sides_agree(vertex.point, vertex.frame.z, direction)) return;
  PathClass events = path.events;
  events.add(B::kEvent, wi.z < 0);
  const auto emitted = T::unpolarised(
      T::from_rgb(light->radiance * (mis_weight(light->pdf, value.pdf) / light->pdf), path.lambda));
  const auto through = T::chain(path.weight, T::depolarising(value.f_cos));
  const Vec3f origin = offset_origin(vertex.point, direction);
  wave.shadow_rays.push_back({origin, light->target - origin, 1});
  wave.shadows.push_back({T::contribute(through, emitted), index, events.index()});
}

/// From the second scattering on, the path continues with a chance of the square root of its weight, and
/// carries the share of those that do not. The weight itself as the chance ends so many paths in rooms of
/// medium albedo that the noise grows by more than the time saved: by 0.4 to 1 dB at equal time on scenes
/// 101, 201 and 224.
template <Transport T>
bool survives_roulette(PathState<T>& path, float u) {
  if (path.scatterings < 2) return true;
  const float chance = std::sqrt(T::magnitude(path.weight) / path.radiance_scale);
  if (chance >= 1) return true;
  if (u >= chance) return false;
  path.weight = T::scaled(path.weight, 1 / chance);
  return true;
}

template <Transport T, typename B>
bool scatter(PathState<T>& path, const Sample& sample_of_path, const Vertex& vertex, const B& bsdf) {
  const auto u = draw(sample_of_path.block, sample_of_path.index,
                      static_cast<std::uint32_t>(path.scatterings), Purpose::Scatter);
  const auto chosen = sample(bsdf, vertex.wo, u);
  if (!chosen) return false;
  const Vec3f direction = vertex.frame.to_world(chosen->wi);
  if (!sides_agree(vertex.point, vertex.frame.z, direction)) return false;
  path.weight = T::chain(path.weight, T::depolarising(chosen->weight));
  path.radiance_scale *= chosen->radiance_scale;
  path.scatter_pdf = B::kIsDelta ? 0 : chosen->pdf;
  path.events.add(B::kEvent, chosen->is_transmitted);
  path.ray = {offset_origin(vertex.point, direction), direction};
  ++path.scatterings;
  return survives_roulette<T>(path, u[3]);
}

/// Handles what the path's ray has met; true when the path goes on with a new ray.
template <Transport T>
bool advance(Wave<T>& wave, const World& world, std::uint32_t index, const Sample& sample, const Hit& hit) {
  PathState<T>& path = wave.paths[index];
  if (hit.part == kNothing) {
    add_emission<T>(wave, path, {world.environment, 0});
    return false;
  }
  const Part& part = world.parts[hit.part];
  if (part.kind == PartKind::Light) {
    if (!is_left_to_light_paths<T>(world, path))
      add_emission<T>(wave, path, met_light(world, part, path.ray, hit));
    return false;
  }
  const SurfacePoint point = surface_point(world, hit);
  const SurfaceMaterial& material = world.materials[static_cast<std::size_t>(point.material)];
  if (material.model == Model::Emission) {
    if (!is_left_to_light_paths<T>(world, path))
      add_emission<T>(wave, path, met_emissive_surface(world, point, material, path.ray, hit));
    return false;
  }
  if (path.scatterings == world.trace_depth) return false;
  const Vec3f wo = -path.ray.direction;
  const float side = dot(point.shading_normal, wo);
  if (side == 0)
    return false;  // exactly edge-on to the shading normal: nothing is reflected towards the viewer
  const bool is_outside = side > 0;
  Vertex vertex{point, frame_around(is_outside ? point.shading_normal : -point.shading_normal), {}};
  vertex.wo = vertex.frame.to_local(wo);
  if (!(vertex.wo.z > 0)) return false;  // edge-on by rounding of the frame
  path.last_is_sharp = material.is_sharp;
  if (path.scatterings == 0) path.first_is_sharp = material.is_sharp;
  return std::visit(
      [&](const auto& bsdf) {
        if constexpr (!bsdf.kIsDelta)
          if (!world.emitters.empty() && !is_left_to_light_paths<T>(world, path))
            ask_for_direct_light<T>(wave, world, index, sample, vertex, bsdf);
        return scatter<T>(path, sample, vertex, bsdf);
      },
      bsdf_at<T>(world, material, hit, is_outside, path.lambda));
}

template <Transport T>
void start_paths(Wave<T>& wave, const World& world, std::span<const Sample> samples) {
  wave.paths.assign(samples.size(), {});
  wave.active.resize(samples.size());
  wave.classed.clear();
  for (std::uint32_t i = 0; i < samples.size(); ++i) {
    const auto u = draw(samples[i].block, samples[i].index, 0, Purpose::PixelAndFirstLight);
    PathState<T>& path = wave.paths[i];
    path.sample = i;
    path.first_light = {u[2], u[3]};
    path.ray = camera_ray(world.camera, static_cast<float>(samples[i].x) + u[0],
                          static_cast<float>(samples[i].y) + u[1]);
    wave.active[i] = i;
  }
}

/// Runs a traversal and adds its time: twice per wave and bounce, for hundreds of rays at a time, so that the
/// clock costs nothing.
template <typename W, typename F>
void timed_traversal(W& wave, const F& traverse) {
  const auto start = std::chrono::steady_clock::now();
  traverse();
  wave.traversal_seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

template <Transport T>
void settle_shadows(Wave<T>& wave, const World& world) {
  wave.blocked.resize(wave.shadow_rays.size());
  timed_traversal(wave, [&] { world.accel->occluded(wave.shadow_rays, wave.blocked); });
  for (std::size_t i = 0; i < wave.shadows.size(); ++i)
    if (wave.blocked[i] == 0)
      add_light(wave, wave.paths[wave.shadows[i].path], wave.shadows[i].light, wave.shadows[i].path_class);
}

/// Traces one path per sample. wave.paths[i].light is what samples[i] saw.
template <Transport T>
void trace_wave(Wave<T>& wave, const World& world, std::span<const Sample> samples) {
  start_paths(wave, world, samples);
  while (!wave.active.empty()) {
    wave.rays.clear();
    for (const std::uint32_t path : wave.active) wave.rays.push_back(wave.paths[path].ray);
    wave.hits.resize(wave.rays.size());
    timed_traversal(wave, [&] { world.accel->intersect(wave.rays, wave.hits); });
    wave.shadow_rays.clear();
    wave.shadows.clear();
    std::size_t alive = 0;
    for (std::size_t i = 0; i < wave.active.size(); ++i) {
      const std::uint32_t path = wave.active[i];
      if (advance<T>(wave, world, path, samples[path], wave.hits[i])) wave.active[alive++] = path;
    }
    wave.active.resize(alive);
    settle_shadows(wave, world);
  }
}

extern template void trace_wave<RgbTransport>(Wave<RgbTransport>&, const World&, std::span<const Sample>);

}  // namespace orbs::tracer
