#include "tracer/choose_light_paths.h"

#include "image/colour.h"
#include "tracer/render.h"

#include <algorithm>
#include <utility>

namespace orbs::tracer {

namespace {

constexpr int kSide = 64;     // pixels of the trial picture's longer side
constexpr int kSamples = 16;  // per pixel
// Light paths take a fifth to a half of a render's time (measured on mirrors and glass of the ORB.S scenes),
// so the noise has to fall by more.
constexpr double kWorthwhile = 0.78;

float on_display(float radiance) { return image::srgb_encode(std::clamp(radiance, 0.0F, 1.0F)); }

// Mean squared difference of two pictures with different seeds, as a display shows them: twice the noise.
double noise(const World& world) {
  const std::atomic<bool> stop{false};
  const auto trial = [&](std::uint64_t seed) {
    return render(world, {.samples_per_pixel = kSamples, .seed = seed}, stop, [](const Progress&) {}).picture;
  };
  const auto a = trial(1);
  const auto b = trial(2);
  double sum = 0;
  for (std::size_t pixel = 0; pixel < a.pixel_count(); ++pixel)
    for (std::size_t c = 0; c < 3; ++c) {
      const std::size_t at = pixel * a.channel_count() + c;
      const double difference = on_display(a.pixels[at]) - on_display(b.pixels[at]);
      sum += difference * difference;
    }
  return sum;
}

}  // namespace

bool choose_light_paths(World& world) {
  if (world.light_path_targets.empty()) return false;
  const PinholeCamera camera = world.camera;
  const double scale = static_cast<double>(kSide) / std::max(camera.width, camera.height);
  world.camera.width = std::max(1, static_cast<int>(camera.width * scale));
  world.camera.height = std::max(1, static_cast<int>(camera.height * scale));
  const double with = noise(world);
  auto targets = std::exchange(world.light_path_targets, {});
  const double without = noise(world);
  world.camera = camera;
  const bool worthwhile = with < kWorthwhile * without;
  if (worthwhile) world.light_path_targets = std::move(targets);
  return worthwhile;
}

}  // namespace orbs::tracer
