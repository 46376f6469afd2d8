#pragma once

#include "scene/load/load_scene.h"
#include "tracer/render.h"
#include "tracer/world/build_world.h"

#include <string>

/// Small scenes as text, rendered in the process of the test.
namespace orbs::tests {

inline tracer::Rendering render_text(const std::string& text, const tracer::RenderSettings& settings) {
  const std::atomic<bool> never{false};
  const auto world = tracer::make_world(scene::load_scene_text("test.json", text, ORBS_SOURCE_DIR));
  return tracer::render(world, settings, never, [](const tracer::Progress&) {});
}

/// A whole scene around `content` (materials, meshes, instances, lights); the camera looks from `eye` to
/// `target`, by default with a field of view so narrow that closed forms for a point hold for the whole
/// image.
inline std::string scene_text(const std::string& eye,
                              const std::string& target,
                              int side_px,
                              int trace_depth,
                              const std::string& content,
                              const std::string& fov_deg = "0.05") {
  const std::string side = std::to_string(side_px);
  return R"({"format": "orbs-scene/1", "name": "test", "camera": {"position": )" + eye + R"(, "look_at": )" +
         target + R"(, "up": [0.1, 0.99, 0.3], "fov_y": )" + fov_deg + R"(, "width": )" + side +
         R"(, "height": )" + side + R"(}, "integrator": {"trace_depth": )" + std::to_string(trace_depth) +
         "}, " + content + "}";
}

/// Mean over all pixels of one channel.
inline double mean_of_channel(const image::Image& image, std::size_t channel) {
  double sum = 0;
  for (std::size_t i = channel; i < image.pixels.size(); i += image.channel_count()) sum += image.pixels[i];
  return sum / static_cast<double>(image.pixel_count());
}

/// Standard error of mean_of_channel, from the variance layer (channel + 3).
inline double error_of_mean(const image::Image& image, std::size_t channel) {
  return std::sqrt(mean_of_channel(image, channel + 3) / static_cast<double>(image.pixel_count()));
}

}  // namespace orbs::tests
