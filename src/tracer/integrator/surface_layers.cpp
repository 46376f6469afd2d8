#include "tracer/integrator/surface_layers.h"

#include "base/parallel.h"
#include "image/layers.h"
#include "scene/camera_frame.h"
#include "scene/motion.h"
#include "tracer/integrator/albedo.h"
#include "tracer/integrator/timed_camera_ray.h"
#include "tracer/render/passes.h"
#include "tracer/render/render_clock.h"
#include "tracer/world/build_world.h"
#include "tracer/world/nearest_hits.h"
#include "tracer/world/surface.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace orbs::tracer {

namespace {

using image::LayerInfo;
using image::LayerKind;

// A camera ray and the surface at its end.
struct Seen {
  const Ray& ray;
  const Hit& hit;
  SurfacePoint point;
};

// From where depths are measured.
struct Viewer {
  Vec3d position_m;
  Vec3d axis;  // unit; zero for a latitude-longitude image, whose depths are the way to the camera
};

Viewer viewer_of(const scene::Camera& camera) {
  if (std::holds_alternative<scene::LatitudeLongitude>(camera.projection)) return {camera.position_m, {}};
  return {camera.position_m, scene::camera_frame(camera).forward};
}

// What all pixels share.
struct LayerScene {
  const World& world;
  const scene::Scene& scene;
  WorldPlace place;
  Viewer viewer;  // when the frame begins
};

SurfacePoint point_of(const World& world, const Ray& ray, const Hit& hit) {
  const RenderObject& object = world.objects[hit.object];
  return object.kind == ObjectKind::Light ? light_point(world.lights[object.light], ray, hit)
                                          : surface_point(world, ray, hit);
}

bool is_light(const World& world, const Seen& seen) {
  return world.objects[seen.hit.object].kind == ObjectKind::Light;
}

Vec3d position_of(const LayerScene& of, const Seen& seen) {
  return (cast<double>(seen.point.position) + of.place.origin_m) / of.place.factor;
}

Vec3d depth_of(const LayerScene& of, const Seen& seen) {
  const Viewer viewer = of.world.moving_camera
                            ? viewer_of(scene::camera_at(of.scene.camera, static_cast<double>(seen.ray.time)))
                            : of.viewer;
  const Vec3d way = position_of(of, seen) - viewer.position_m;
  return {viewer.axis == Vec3d{} ? length(way) : dot(way, viewer.axis), 0, 0};
}

Vec3d normal_of(const LayerScene&, const Seen& seen) {
  const Vec3f n = seen.point.shading_normal;
  return cast<double>(dot(n, seen.ray.direction) > 0 ? -n : n);
}

SurfaceHit surface_of(const World& world, const Seen& seen) {
  return {seen.point, nth(world.materials, seen.point.material), seen.hit};
}

Vec3d albedo_value(const LayerScene& of, const Seen& seen) {
  if (is_light(of.world, seen))
    return cast<double>(of.world.lights[of.world.objects[seen.hit.object].light].reflectance);
  return cast<double>(albedo_of(of.world, surface_of(of.world, seen)));
}

Vec3d uv_of(const LayerScene& of, const Seen& seen) {
  if (is_light(of.world, seen)) return {};
  const Vec2f uv = texture_coordinates(of.world, surface_of(of.world, seen), UvMap{});
  return {static_cast<double>(uv.x), static_cast<double>(uv.y), 0};
}

using Value = Vec3d (*)(const LayerScene&, const Seen&);
constexpr std::array<std::pair<std::string_view, Value>, 5> kValues{{{"depth", depth_of},
                                                                     {"position", position_of},
                                                                     {"normal", normal_of},
                                                                     {"albedo", albedo_value},
                                                                     {"uv", uv_of}}};

// From 1. The objects of a world are those of its scene in the order instances, shapes, lights.
double id_of(const LayerScene& of, std::string_view layer, const Seen& seen) {
  const World& world = of.world;
  const scene::Scene& scene = of.scene;
  const bool is_of_light = is_light(world, seen);
  if (layer == "material")
    return is_of_light ? static_cast<double>(scene.materials.size() + 1) : seen.point.material + 1.0;
  if (layer == "instance") return seen.hit.object + 1.0;
  const auto instances = scene.instances.size();
  if (seen.hit.object < instances) return scene.instances[seen.hit.object].mesh + 1.0;
  return static_cast<double>(scene.meshes.size() + (seen.hit.object - instances) + 1);
}

// What one sample or pixel has of the layers that are means: their parts, one behind the other.
constexpr std::size_t kMostParts = 12;
using Values = std::array<double, kMostParts>;

struct MeanLayer {
  Value value;
  std::size_t parts = 0;
};

// The layers as the image holds them.
struct Plan {
  std::vector<MeanLayer> means;
  std::vector<const LayerInfo*> ids;
  std::vector<std::string> mean_channels;
};

Plan plan_of(const std::vector<std::string>& wanted) {
  Plan plan;
  for (const auto& layer : image::kLayers) {
    if (std::find(wanted.begin(), wanted.end(), layer.name) == wanted.end()) continue;
    if (layer.kind == LayerKind::Id) plan.ids.push_back(&layer);
    if (layer.kind != LayerKind::Mean) continue;
    const auto* const value = std::find_if(kValues.begin(), kValues.end(),
                                           [&](const auto& known) { return known.first == layer.name; });
    const auto channels = image::channels_of(layer);
    plan.means.push_back({value->second, channels.size()});
    plan.mean_channels.insert(plan.mean_channels.end(), channels.begin(), channels.end());
  }
  return plan;
}

// The coverage, then each channel with its range, then the numbers.
std::vector<std::string> channel_names(const Plan& plan) {
  std::vector<std::string> names{"coverage.A"};
  for (const auto& channel : plan.mean_channels) {
    names.push_back(channel);
    names.push_back(std::string(image::kLeast) + channel);
    names.push_back(std::string(image::kMost) + channel);
  }
  for (const auto* layer : plan.ids) names.push_back(image::channels_of(*layer).front());
  return names;
}

class PixelLayers {
 public:
  PixelLayers(const LayerScene& of, const Plan& plan) : of_(of), plan_(plan) {}

  void add(const Ray& ray, const Hit& hit) {
    ++samples_;
    if (hit.object == kNoHit) return;
    const Seen seen{ray, hit, point_of(of_.world, ray, hit)};
    Values values{};
    std::size_t count = 0;
    for (const auto& layer : plan_.means) {
      const Vec3d value = layer.value(of_, seen);
      for (std::size_t i = 0; i < layer.parts; ++i)
        values.at(count++) = i == 0 ? value.x : i == 1 ? value.y : value.z;
    }
    if (covered_++ == 0) {
      sums_ = least_ = most_ = values;
      return;
    }
    for (std::size_t i = 0; i < count; ++i) {
      sums_[i] += values[i];
      least_[i] = std::min(least_[i], values[i]);
      most_[i] = std::max(most_[i], values[i]);
    }
  }

  // In the order of channel_names; `middle` is what the middle of the pixel shows.
  void store(const Ray& ray, const Hit& middle, float* out) const {
    *out++ = static_cast<float>(covered_ / samples_);
    for (std::size_t i = 0; i < plan_.mean_channels.size(); ++i) {
      const bool is_there = covered_ > 0;
      *out++ = is_there ? static_cast<float>(sums_[i] / covered_) : 0;
      *out++ = is_there ? static_cast<float>(least_[i]) : 0;
      *out++ = is_there ? static_cast<float>(most_[i]) : 0;
    }
    if (plan_.ids.empty()) return;
    const bool is_there = middle.object != kNoHit;
    const Seen seen{ray, middle, is_there ? point_of(of_.world, ray, middle) : SurfacePoint{}};
    for (const auto* layer : plan_.ids)
      *out++ = is_there ? static_cast<float>(id_of(of_, layer->name, seen)) : 0;
  }

 private:
  const LayerScene& of_;
  const Plan& plan_;
  Values sums_{};
  Values least_{};
  Values most_{};
  double covered_ = 0;
  double samples_ = 0;
};

class TileOfLayers {
 public:
  TileOfLayers(const LayerScene& of, const Plan& plan, const RenderSettings& settings)
      : of_(of), plan_(plan), settings_(settings) {}

  void trace(const Tile& tile, const std::vector<Pass>& passes, image::Image& layers) {
    for (int y = tile.y0; y < tile.y1; ++y)
      for (int x = tile.x0; x < tile.x1; ++x) {
        PixelLayers pixel(of_, plan_);
        for (const auto& pass : passes) add_pass(x, y, pass, layers.width, pixel);
        const Ray middle = middle_ray(x, y);
        const Hit hit = intersect_one(middle);
        pixel.store(middle, hit, &layers.at(x, y, 0));
      }
  }

 private:
  void add_pass(int x, int y, const Pass& pass, int width, PixelLayers& pixel) {
    const auto index =
        static_cast<std::uint32_t>(y) * static_cast<std::uint32_t>(width) + static_cast<std::uint32_t>(x);
    const auto block = sample_block(settings_.seed, index, pass.block, {settings_.sampler, pass.length});
    rays_.clear();
    for (std::uint32_t i = pass.first; i < pass.first + pass.count; ++i) {
      const auto u = draw(block, i, 0, SampleDimension::PixelAndFirstLight);
      rays_.push_back(
          timed_camera_ray(of_.world, static_cast<float>(x) + u[0], static_cast<float>(y) + u[1], block, i));
    }
    hits_.resize(rays_.size());
    nearest_hits(of_.world, rays_, hits_);
    for (std::size_t i = 0; i < rays_.size(); ++i) pixel.add(rays_[i], hits_[i]);
  }

  // Through the middle of the lens, when the shutter opens.
  Ray middle_ray(int x, int y) const {
    constexpr float kHalf = 0.5F;
    const float time = of_.world.shutter ? static_cast<float>(of_.world.shutter->open) : 0.0F;
    Ray ray =
        camera_ray(camera_at(of_.world, time), static_cast<float>(x) + kHalf, static_cast<float>(y) + kHalf);
    ray.time = time;
    return ray;
  }

  Hit intersect_one(const Ray& ray) {
    rays_.assign(1, ray);
    hits_.assign(1, Hit{});
    nearest_hits(of_.world, rays_, hits_);
    return hits_.front();
  }

  const LayerScene& of_;
  const Plan& plan_;
  const RenderSettings& settings_;
  std::vector<Ray> rays_;
  std::vector<Hit> hits_;
};

// Both images have the same size.
image::Image side_by_side(const image::Image& first, const image::Image& second) {
  auto channels = first.channels;
  channels.insert(channels.end(), second.channels.begin(), second.channels.end());
  auto out = image::make_image(first.width, first.height, std::move(channels));
  out.attributes = first.attributes;
  const auto count = out.channel_count();
  for (std::size_t pixel = 0; pixel < out.pixel_count(); ++pixel) {
    float* const to = &out.pixels[pixel * count];
    std::copy_n(&first.pixels[pixel * first.channel_count()], first.channel_count(), to);
    std::copy_n(&second.pixels[pixel * second.channel_count()], second.channel_count(),
                to + first.channel_count());
  }
  return out;
}

}  // namespace

void add_surface_layers(const World& world,
                        const scene::Scene& scene,
                        const RenderSettings& settings,
                        Rendering& out) {
  if (scene.outputs.layers.empty()) return;
  const RenderClock clock;
  const LayerScene of{world, scene, place_of_world(scene), viewer_of(scene.camera)};
  const Plan plan = plan_of(scene.outputs.layers);
  const auto passes = plan_passes(out.samples_per_pixel, {1, out.samples_per_pixel});
  auto layers = image::make_image(out.image.width, out.image.height, channel_names(plan));
  const Film film = make_film(layers.width, layers.height);
  for_each_index(tile_count(film), settings.threads, [&](int index) {
    TileOfLayers(of, plan, settings).trace(tile_at(film, index), passes, layers);
  });
  out.image = side_by_side(out.image, layers);
  const RenderTime time = clock.time();
  out.seconds += time.seconds;
  out.cpu_seconds += time.cpu_seconds;
}

}  // namespace orbs::tracer
