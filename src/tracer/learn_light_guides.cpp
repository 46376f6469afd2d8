#include "tracer/learn_light_guides.h"

#include "base/nth.h"
#include "base/parallel.h"
#include "base/random.h"
#include "tracer/integrator/light_vertex.h"
#include "tracer/render/render_clock.h"
#include "tracer/world/nearest_hits.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <vector>

namespace orbs::tracer {

namespace {

constexpr double kShareOfPaths = 0.05;
constexpr int kPathsPerBlock = 256;
constexpr int kMostBlocks = 256;
constexpr std::uint64_t kGuideSeed = 0x601de;  // separates their random numbers from those of the image
constexpr std::uint32_t kSeenPoints = 64;
constexpr int kConnectionsPerVertex = 2;

/// A point that the camera sees.
struct SeenPoint {
  SurfacePoint point;
  LightSampleContext context;
};

std::optional<SeenPoint> seen_point(const World& world, const Ray& ray, const Hit& hit) {
  if (hit.object == kNoHit || world.objects[hit.object].kind == ObjectKind::Light) return std::nullopt;
  const SurfacePoint point = surface_point(world, ray, hit);
  const SurfaceMaterial& material = nth(world.materials, point.material);
  if (material.is_near_specular || std::holds_alternative<EmissionMaterial>(material.model))
    return std::nullopt;
  const bool is_front = dot(point.shading_normal, ray.direction) < 0;
  return SeenPoint{point, {point.position, is_front ? point.shading_normal : -point.shading_normal}};
}

std::vector<SeenPoint> seen_points(const World& world) {
  const auto block = sample_block(kGuideSeed, 0, 0, {Sampler::Sobol, kSeenPoints});
  std::vector<Ray> rays;
  for (std::uint32_t i = 0; i < kSeenPoints; ++i) {
    const auto u = draw(block, i, 0, SampleDimension::PixelAndFirstLight);
    rays.push_back(camera_ray(world.camera, u[0] * static_cast<float>(world.camera.width),
                              u[1] * static_cast<float>(world.camera.height)));
  }
  std::vector<Hit> hits(rays.size());
  nearest_hits(world, rays, hits);
  std::vector<SeenPoint> out;
  for (std::size_t i = 0; i < rays.size(); ++i)
    if (const auto seen = seen_point(world, rays[i], hits[i])) out.push_back(*seen);
  return out;
}

/// A light vertex that a seen point was connected to.
struct Connection {
  std::size_t emitter = 0;
  Vec3f position;
  std::size_t seen = 0;
  float contribution = 0;
};

// What is rough and lets light through is left to the paths that no guide sends.
bool is_same_side(const LightVertex& vertex, Vec3f to_viewer) {
  const Vec3f normal = vertex.point.geometric_normal;
  return dot(normal, vertex.to_light) * dot(normal, to_viewer) > 0;
}

std::vector<Connection> connections_of_block(const World& world,
                                             const std::vector<SeenPoint>& seen,
                                             int number) {
  const auto block =
      sample_block(kGuideSeed, static_cast<std::uint32_t>(number), 1, {Sampler::Sobol, kPathsPerBlock});
  std::vector<Sample> samples(kPathsPerBlock);
  for (std::uint32_t i = 0; i < kPathsPerBlock; ++i) samples[i] = {.block = block, .index = i};
  LightVertexPool pool;
  trace_light_vertices(pool, world, samples);
  std::vector<Connection> out;
  std::vector<Ray> shadow_rays;
  for (std::size_t i = 0; i < pool.vertices.size(); ++i) {
    const LightVertex& vertex = pool.vertices[i];
    for (int k = 0; k < kConnectionsPerVertex; ++k) {
      const auto at = static_cast<std::size_t>(
          mix(block.seed, kConnectionsPerVertex * i + static_cast<std::size_t>(k)) % seen.size());
      const SurfacePoint& from = seen[at].point;
      const Vec3f d = vertex.point.position - from.position;
      const float contribution =
          is_same_side(vertex, -d) ? unblocked_contribution(vertex, seen[at].context) : 0;
      if (!(contribution > 0)) continue;
      const Vec3f start = offset_origin(from.position, from.position_error, from.geometric_normal, d);
      const Vec3f end = offset_origin(vertex.point.position, vertex.point.position_error,
                                      vertex.point.geometric_normal, -d);
      shadow_rays.push_back({start, end - start, 1});
      out.push_back({vertex.emitter, vertex.point.position, at, contribution});
    }
  }
  std::vector<std::uint8_t> blocked(shadow_rays.size());
  world.accel->occluded(shadow_rays, blocked);
  for (std::size_t i = 0; i < out.size(); ++i)
    if (blocked[i] != 0) out[i].contribution = 0;
  return out;
}

// Each seen point counts the same, as its light is what a relative error is measured against; but not one
// that is all but black beside the others.
std::vector<GuideTrial> trials_of(const std::vector<Connection>& connections, std::size_t seen_points) {
  constexpr float kDark = 0.1F;  // of the mean
  std::vector<float> sums(seen_points);
  for (const Connection& c : connections) sums[c.seen] += c.contribution;
  const float dark = kDark * std::reduce(sums.begin(), sums.end()) / static_cast<float>(seen_points);
  std::vector<GuideTrial> out;
  for (const Connection& c : connections)
    if (c.contribution > 0) out.push_back({c.emitter, c.position, c.contribution / (sums[c.seen] + dark)});
  return out;
}

}  // namespace

RenderTime learn_light_guides(World& world, const RenderSettings& settings) {
  world.light_guides.clear();
  const double paths = kShareOfPaths * world.camera.width * static_cast<double>(world.camera.height) *
                       settings.samples_per_pixel;
  const int blocks = static_cast<int>(std::min<double>(kMostBlocks, paths / kPathsPerBlock));
  if (blocks < 1) return {};
  const RenderClock clock;
  const auto seen = seen_points(world);
  if (!seen.empty()) {
    std::vector<std::vector<Connection>> by_block(static_cast<std::size_t>(blocks));
    for_each_index(blocks, settings.threads,
                   [&](int i) { nth(by_block, i) = connections_of_block(world, seen, i); });
    std::vector<Connection> all;
    for (const auto& some : by_block) all.insert(all.end(), some.begin(), some.end());
    world.light_guides = make_light_guides(trials_of(all, seen.size()));
  }
  return clock.time();
}

}  // namespace orbs::tracer
