#include "tracer/learn_light_selection.h"

#include "base/nth.h"
#include "base/parallel.h"
#include "base/random.h"
#include "image/colour.h"
#include "tracer/geometry/transforms.h"
#include "tracer/integrator/light_sampling.h"
#include "tracer/integrator/make_bsdf.h"
#include "tracer/integrator/timed_camera_ray.h"
#include "tracer/render/render_clock.h"
#include "tracer/sampling/warps.h"
#include "tracer/transport/rgb_transport.h"
#include "tracer/world/nearest_hits.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace orbs::tracer {

namespace {

// What is learned are directions and blockers; three channels and all materials are enough for them.
using LearningTransport = RgbBoundaryTransport;

// Of the camera paths; a region of space has some dozens of them even in small images.
constexpr double kShareOfPaths = 0.02;
constexpr std::uint64_t kLearningSeed = 0x1ea27;  // separates their random numbers from those of the image
constexpr int kMostSurfaces = 4;                  // of a path; later ones carry little of the light
constexpr int kPathsPerBlock = 256;
constexpr int kFewestBlocks = 4;
constexpr int kMostBlocks = 512;
// With fewer paths a finer grid has too few samples in each region.
constexpr int kBlocksForFineGrid = 256;

struct WalkingPath {
  Ray ray;
  std::uint32_t index = 0;  // within its block of random numbers
  Vec3f throughput{1, 1, 1};
};

/// One block of paths on their way.
struct Walk {
  SampleBlock block;
  std::vector<WalkingPath> paths;
  std::vector<LightTrial> trials;
  std::vector<Ray> shadow_rays;       // of the trials of the current bounce that found light
  std::vector<std::size_t> shadowed;  // which these are
};

float brightness(const Radiance& radiance) {
  const auto seen = static_cast<float>(image::luminance(radiance.rgb.x, radiance.rgb.y, radiance.rgb.z));
  return seen > 0 ? seen : 1;  // of a spectrum alone
}

void try_light(Walk& walk,
               const World& world,
               const LightSampleContext& at,
               const SurfacePoint& point,
               const std::array<float, 4>& u,
               float time) {
  const double pick = with_more_digits(u[0], u[3]);
  const auto selected = world.light_bvh.select(at, pick);
  if (!selected) return;
  walk.trials.push_back({at, selected->emitter, 0});
  const auto light = sample_light(world, at, pick, u[1], u[2]);
  if (!light) return;
  const Vec3f to_light = light->position - at.position;
  const float distance = length(to_light);
  const float cosine = at.normal == Vec3f{} ? 1 : dot(at.normal, to_light) / distance;
  if (!(cosine > 0)) return;
  walk.trials.back().irradiance = brightness(light->radiance) * cosine * selected->probability / light->pdf;
  walk.shadowed.push_back(walk.trials.size() - 1);
  const Vec3f from = offset_origin(point.position, point.position_error, point.geometric_normal,
                                   light->target - at.position);
  walk.shadow_rays.push_back({from, light->target - from, 1, 0, time});
}

/// Tries a light where the path has arrived and scatters it; false if it ends.
bool advance(Walk& walk, const World& world, WalkingPath& path, const Hit& hit, std::uint32_t bounce) {
  if (hit.object == kNoHit || world.objects[hit.object].kind == ObjectKind::Light) return false;
  const SurfacePoint point = surface_point(world, path.ray, hit);
  const SurfaceMaterial& material = nth(world.materials, point.material);
  if (std::holds_alternative<EmissionMaterial>(material.model)) return false;
  const Vec3f to_viewer = -path.ray.direction;
  if (!sides_agree(point.geometric_normal, point.shading_normal, to_viewer)) return false;
  const float side = dot(point.shading_normal, to_viewer);
  const Frame frame = frame_around(side > 0 ? point.shading_normal : -point.shading_normal);
  LearningTransport::Lambda lambda;
  LearningTransport::Bsdf bsdf;
  make_bsdf<LearningTransport>(
      bsdf,
      {world, {point, material, hit}, side > 0, lambda, path.throughput, walk.block, path.index, bounce});
  if (!is_delta(bsdf)) {
    const LightSampleContext at{point.position, event_of(bsdf) == Event::Diffuse ? frame.z : Vec3f{}};
    try_light(walk, world, at, point, draw(walk.block, path.index, bounce, SampleDimension::Light),
              path.ray.time);
  }
  const auto chosen =
      sample(bsdf, frame.to_local(to_viewer), draw(walk.block, path.index, bounce, SampleDimension::Scatter));
  if (!chosen) return false;
  const Vec3f direction = frame.to_world(chosen->wi);
  if (!sides_agree(point.geometric_normal, point.shading_normal, direction)) return false;
  path.ray.origin = offset_origin(point.position, point.position_error, point.geometric_normal, direction);
  path.ray.direction = direction;
  return true;
}

void resolve_shadows(Walk& walk, const World& world) {
  std::vector<std::uint8_t> blocked(walk.shadow_rays.size());
  world.accel->occluded(walk.shadow_rays, blocked);
  for (std::size_t i = 0; i < blocked.size(); ++i)
    if (blocked[i] != 0) walk.trials[walk.shadowed[i]].irradiance = 0;
  walk.shadow_rays.clear();
  walk.shadowed.clear();
}

std::vector<LightTrial> trials_of_block(const World& world, int number) {
  Walk walk;
  walk.block =
      sample_block(kLearningSeed, static_cast<std::uint32_t>(number), 0, {Sampler::Sobol, kPathsPerBlock});
  for (std::uint32_t i = 0; i < kPathsPerBlock; ++i) {
    const auto u = draw(walk.block, i, 0, SampleDimension::PixelAndFirstLight);
    walk.paths.push_back({timed_camera_ray(world, u[0] * static_cast<float>(world.camera.width),
                                           u[1] * static_cast<float>(world.camera.height), walk.block, i),
                          i});
  }
  const int surfaces = std::min(kMostSurfaces, world.trace_depth);
  for (int bounce = 0; bounce < surfaces && !walk.paths.empty(); ++bounce) {
    std::vector<Ray> rays;
    for (const WalkingPath& path : walk.paths) rays.push_back(path.ray);
    std::vector<Hit> hits(rays.size());
    nearest_hits(world, rays, hits);
    std::vector<WalkingPath> alive;
    for (std::size_t i = 0; i < hits.size(); ++i)
      if (advance(walk, world, walk.paths[i], hits[i], static_cast<std::uint32_t>(bounce)))
        alive.push_back(walk.paths[i]);
    walk.paths = std::move(alive);
    resolve_shadows(walk, world);
  }
  return std::move(walk.trials);
}

}  // namespace

RenderTime learn_light_selection(LightBvh& tree, World& world, const RenderSettings& settings) {
  if (tree.empty()) return {};
  const double paths = kShareOfPaths * world.camera.width * static_cast<double>(world.camera.height) *
                       settings.samples_per_pixel;
  const int blocks = static_cast<int>(std::min<double>(kMostBlocks, paths / kPathsPerBlock));
  if (blocks < kFewestBlocks) return {};
  const RenderClock clock;
  std::vector<std::vector<LightTrial>> by_block(static_cast<std::size_t>(blocks));
  std::swap(tree, world.light_bvh);
  for_each_index(blocks, settings.threads, [&](int i) { nth(by_block, i) = trials_of_block(world, i); });
  std::swap(tree, world.light_bvh);
  std::vector<LightTrial> all;
  for (const auto& trials : by_block) all.insert(all.end(), trials.begin(), trials.end());
  tree.learn(
      all, {.eye = world.camera.position, .cells_per_distance = blocks < kBlocksForFineGrid ? 8.0F : 16.0F});
  return clock.time();
}

}  // namespace orbs::tracer
