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

// Where the camera sees a corner of what the lamps light, hardly any light path arrives: the trial then shows
// no noise because it shows no light. So many contributions per pixel of it, at least, make it believable.
constexpr double kFewestArrivals = 0.25;

float on_display(float radiance) { return image::srgb_encode(std::clamp(radiance, 0.0F, 1.0F)); }

struct Trial {
  double noise = 0;  // of one picture, as a display shows it: mean square times number of values
  bool is_believable = false;
};

Trial trial_of(const World& world) {
  const std::atomic<bool> stop{false};
  const auto rendered = [&](std::uint64_t seed) {
    return render(world, {.samples_per_pixel = kSamples, .seed = seed}, stop, [](const Progress&) {});
  };
  const auto a = rendered(1);
  const auto b = rendered(2);
  const auto channels = a.picture.channel_count();
  Trial trial;
  for (std::size_t pixel = 0; pixel < a.picture.pixel_count(); ++pixel)
    for (std::size_t c = 0; c < 3; ++c) {
      const std::size_t at = pixel * channels + c;
      const double difference = on_display(a.picture.pixels[at]) - on_display(b.picture.pixels[at]);
      trial.noise += difference * difference / 2;
    }
  trial.is_believable = static_cast<double>(a.arrived_light_paths) >=
                        kFewestArrivals * static_cast<double>(a.picture.pixel_count());
  return trial;
}

}  // namespace

bool choose_light_paths(World& world) {
  if (world.light_path_targets.empty()) return false;
  const PinholeCamera camera = world.camera;
  const double scale = static_cast<double>(kSide) / std::max(camera.width, camera.height);
  world.camera.width = std::max(1, static_cast<int>(camera.width * scale));
  world.camera.height = std::max(1, static_cast<int>(camera.height * scale));
  const Trial with = trial_of(world);
  auto targets = std::exchange(world.light_path_targets, {});
  const Trial without = trial_of(world);
  world.camera = camera;
  const bool worthwhile = with.is_believable && with.noise < kWorthwhile * without.noise;
  if (worthwhile) world.light_path_targets = std::move(targets);
  return worthwhile;
}

}  // namespace orbs::tracer
