#include "tracer/integrator/ambient_occlusion.h"

#include "base/parallel.h"
#include "tracer/geometry/transforms.h"
#include "tracer/integrator/timed_camera_ray.h"
#include "tracer/sampling/warps.h"
#include "tracer/world/nearest_hits.h"
#include "tracer/world/surface.h"

#include <cmath>
#include <mutex>
#include <vector>

namespace orbs::tracer {

namespace {

struct PixelSample {
  std::size_t pixel = 0;
  SampleBlock block;
  std::uint32_t index = 0;  // within the block
};

// Uniform on the hemisphere about +z.
Vec3f sample_hemisphere(float u, float v) {
  // The disk's squared radius is uniform, as is 1 - z.
  const Vec2f d = sample_disk(u, v);
  const float squared = d.x * d.x + d.y * d.y;
  const float scale = std::sqrt(2 - squared);
  return {d.x * scale, d.y * scale, 1 - squared};
}

class TileWorker {
 public:
  TileWorker(const World& world, const RenderSettings& settings, Film& film)
      : world_(world), settings_(settings), film_(film) {}

  void trace(const Tile& tile, const Pass& pass) {
    for (int y = tile.y0; y < tile.y1; ++y) {
      start_row(tile, y, pass);
      trace_row();
    }
  }

 private:
  void start_row(const Tile& tile, int y, const Pass& pass) {
    samples_.clear();
    camera_rays_.clear();
    for (int x = tile.x0; x < tile.x1; ++x) {
      const auto pixel = pixel_index(film_, x, y);
      const auto [camera_x, camera_y] = camera_pixel(film_, pixel, x, y);
      const auto block = sample_block(settings_.seed, static_cast<std::uint32_t>(pixel), pass.block,
                                      {settings_.sampler, pass.length});
      for (std::uint32_t i = 0; i < pass.count; ++i) {
        const auto u = draw(block, pass.first + i, 0, SampleDimension::PixelAndFirstLight);
        samples_.push_back({pixel, block, pass.first + i});
        camera_rays_.push_back(timed_camera_ray(world_, static_cast<float>(camera_x) + u[0],
                                                static_cast<float>(camera_y) + u[1], block, pass.first + i));
      }
    }
    pass_ = pass;
  }

  void trace_row() {
    hits_.resize(camera_rays_.size());
    nearest_hits(world_, camera_rays_, hits_);
    open_.assign(samples_.size(), 0);
    occlusion_rays_.clear();
    ray_samples_.clear();
    for (std::size_t i = 0; i < hits_.size(); ++i)
      if (hits_[i].object != kNoHit) add_occlusion_ray(i);
    blocked_.resize(occlusion_rays_.size());
    world_.accel->occluded(occlusion_rays_, blocked_);
    for (std::size_t k = 0; k < blocked_.size(); ++k) open_[ray_samples_[k]] = blocked_[k] != 0 ? 0 : 1;
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      add_sample(film_.pixels[samples_[i].pixel], {open_[i], open_[i], open_[i]});
      if (const auto piece = piece_ended_by(pass_, samples_[i].index))
        end_piece(film_, samples_[i].pixel, *piece);
    }
  }

  void add_occlusion_ray(std::size_t i) {
    const Ray& ray = camera_rays_[i];
    const Hit& hit = hits_[i];
    const RenderObject& object = world_.objects[hit.object];
    const SurfacePoint point = object.kind == ObjectKind::Light
                                   ? light_point(world_.lights[object.light], ray, hit)
                                   : surface_point(world_, ray, hit);
    const auto u = draw(samples_[i].block, samples_[i].index, 0, SampleDimension::Scatter);
    const auto& settings = std::get<scene::AmbientOcclusion>(world_.integrator);
    const Vec3f local = settings.weight == scene::OcclusionWeight::Cosine ? sample_cosine(u[0], u[1])
                                                                          : sample_hemisphere(u[0], u[1]);
    const float side = dot(point.shading_normal, ray.direction);
    const Frame frame = frame_around(side < 0 ? point.shading_normal : -point.shading_normal);
    const Vec3f direction = frame.to_world(local);
    if (!sides_agree(point.geometric_normal, frame.z, direction)) return;
    ray_samples_.push_back(i);
    occlusion_rays_.push_back(
        {offset_origin(point.position, point.position_error, point.geometric_normal, direction), direction,
         static_cast<float>(settings.distance_m), 0, ray.time});
  }

  const World& world_;
  const RenderSettings& settings_;
  Film& film_;
  std::vector<PixelSample> samples_;
  std::vector<Ray> camera_rays_;
  std::vector<Hit> hits_;
  std::vector<Ray> occlusion_rays_;
  std::vector<std::size_t> ray_samples_;  // index into samples_ of each occlusion ray
  std::vector<std::uint8_t> blocked_;
  std::vector<double> open_;  // of each sample: 1 where its ray meets nothing
  Pass pass_;
};

}  // namespace

void render_ambient_occlusion(const World& world,
                              const RenderSettings& settings,
                              const NumberedPass& pass,
                              Film& film,
                              Rendering&,
                              const std::function<void()>& tile_done) {
  std::mutex mutex;
  for_each_index(tile_count(film), settings.threads, [&](int index) {
    TileWorker worker(world, settings, film);
    worker.trace(tile_at(film, index), pass.pass);
    const std::lock_guard lock(mutex);
    tile_done();
  });
}

}  // namespace orbs::tracer
