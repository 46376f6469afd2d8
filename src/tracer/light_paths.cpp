#include "tracer/light_paths.h"

#include "base/parallel.h"
#include "base/random.h"
#include "tracer/trace_light_wave.h"

#include <algorithm>

namespace orbs::tracer {

namespace {

constexpr std::uint32_t kWave = 1024;          // as for camera paths
constexpr std::uint64_t kLightSeed = 0x11947;  // keeps light paths off the camera paths' numbers
constexpr std::size_t kSamplesPerLightPath = 4;
constexpr int kChunksAtOnce = 256;  // their splats wait in memory: about a million paths'

// One block of jointly stratified paths: the unit of work, so that the order of sums is fixed.
struct Chunk {
  std::vector<Splat> splats;
  double traversal_seconds = 0;
};

Chunk trace_chunk(const World& world, SampleBlock block, std::uint32_t count) {
  LightWave<RgbTransport> wave;
  for (std::uint32_t first = 0; first < count; first += kWave)
    trace_light_wave(wave, world, block, first, std::min(kWave, count - first));
  return {std::move(wave.splats), wave.traversal_seconds};
}

// `share`: what turns the mean over the light paths into a sum over the camera samples.
void add_splats(const std::vector<Splat>& splats, double share, Film& film, BadSamples& bad) {
  for (const Splat& splat : splats) {
    if (!is_finite(splat.value)) {
      merge(bad, {1, static_cast<int>(splat.pixel) % film.width, static_cast<int>(splat.pixel) / film.width});
      continue;
    }
    const Vec3d radiance = cast<double>(splat.value) * share;
    film.pixels[splat.pixel].current += radiance;
    if (!film.class_sums.empty())
      film.class_sums[static_cast<std::size_t>(splat.path_class)][splat.pixel] += radiance;
  }
}

}  // namespace

LightPassResult add_light_paths(const World& world, const LightPass& pass, Film& film) {
  LightPassResult result;
  if (world.light_path_targets.empty()) return result;
  const auto samples = film.pixels.size() * static_cast<std::size_t>(pass.samples_per_pixel);
  const auto paths = (samples + kSamplesPerLightPath - 1) / kSamplesPerLightPath;
  const auto chunks = static_cast<int>((paths + kBlock - 1) / kBlock);
  const double share = static_cast<double>(pass.samples_per_pixel) / static_cast<double>(paths);
  std::vector<Chunk> done(kChunksAtOnce);
  for (int first = 0; first < chunks; first += kChunksAtOnce) {
    const int count = std::min(kChunksAtOnce, chunks - first);
    for_each_index(count, pass.threads, [&](int i) {
      const auto chunk = static_cast<std::size_t>(first) + static_cast<std::size_t>(i);
      const auto block =
          sample_block(mix(pass.seed, kLightSeed), static_cast<std::uint32_t>(chunk), pass.number);
      const auto left = std::min<std::size_t>(kBlock, paths - chunk * kBlock);
      done[static_cast<std::size_t>(i)] = trace_chunk(world, block, static_cast<std::uint32_t>(left));
    });
    for (int i = 0; i < count; ++i) {
      const Chunk& chunk = done[static_cast<std::size_t>(i)];
      add_splats(chunk.splats, share, film, result.bad_samples);
      result.traversal_seconds += chunk.traversal_seconds;
      result.arrived += chunk.splats.size();
    }
  }
  return result;
}

PinholeCamera mirrored(const MirrorPlane& plane, const PinholeCamera& camera) {
  PinholeCamera image = camera;
  image.position = mirrored(plane, camera.position);
  image.forward = mirrored_direction(plane, camera.forward);
  image.right = mirrored_direction(plane, camera.right);
  image.up = mirrored_direction(plane, camera.up);
  return image;
}

EyeView view_of(const PinholeCamera& camera, Vec3f point) {
  const Vec3f d = point - camera.position;
  const float depth = dot(d, camera.forward);
  if (!(depth > 0)) return {};
  const Vec3f on_plane = d / depth;
  const float half_width = length(camera.right);
  const float half_height = length(camera.up);
  const float x =
      (dot(on_plane, camera.right) / (half_width * half_width) + 1) / 2 * static_cast<float>(camera.width);
  const float y =
      (1 - dot(on_plane, camera.up) / (half_height * half_height)) / 2 * static_cast<float>(camera.height);
  if (!(x >= 0 && y >= 0 && x < static_cast<float>(camera.width) && y < static_cast<float>(camera.height)))
    return {};
  const auto pixel = static_cast<std::uint32_t>(y) * static_cast<std::uint32_t>(camera.width) +
                     static_cast<std::uint32_t>(x);
  // A surface element dA at distance r that faces the camera fills dA / r^2 of solid angle, and 1 / cos^3 of
  // that on the image plane at distance 1; the pixel is the mean over its share of the plane's area.
  const float distance = length(d);
  const float cosine = depth / distance;
  const float pixels_per_area =
      static_cast<float>(camera.width) * static_cast<float>(camera.height) / (4 * half_width * half_height);
  return {pixel, pixels_per_area / (distance * distance * cosine * cosine * cosine)};
}

}  // namespace orbs::tracer
