#pragma once

#include "unit/tracer/scenes.h"

#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

/// Images of tiny scenes for the tests of light: means of channels and their standard errors.
namespace orbs::tests {

struct View {
  std::string position = "[0, 0, 5]";
  std::string look_at = "[0, 0, 0]";
  std::string up = "[0, 1, 0]";
  double fov_deg = 0.01;  // so narrow that closed forms for one ray hold for the whole image
  int width = 8;
  int height = 8;
};

/// `content` holds spectra, materials, surfaces, lights and outputs.
inline std::string scene_of(const View& view,
                            const std::string& content,
                            const std::string& trace_depth = R"("unlimited")") {
  return fmt::format(
      R"({{"format": "orbs-scene/1", "name": "test", "camera": {{"position": {}, "look_at": {}, "up": {}, )"
      R"("fov_y": {}, "width": {}, "height": {}}}, "integrator": {{"trace_depth": {}}}, {}}})",
      view.position, view.look_at, view.up, view.fov_deg, view.width, view.height, trace_depth, content);
}

inline std::string text_of(Vec3d v) { return fmt::format("[{:.17g}, {:.17g}, {:.17g}]", v.x, v.y, v.z); }

/// A mesh: a square around `centre` whose outside is the side of `normal`.
inline std::string square(Vec3d centre, Vec3d normal, double half_size, const std::string& material) {
  const Vec3d n = normalised(normal);
  const Vec3d a = normalised(cross(n, std::abs(n.x) < 0.9 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0})) * half_size;
  const Vec3d b = cross(n, a);
  std::string positions;
  std::string normals;
  for (const Vec3d corner : {centre - a - b, centre + a - b, centre + a + b, centre - a + b}) {
    const char* separator = positions.empty() ? "" : ", ";
    positions += fmt::format("{}{:.17g}, {:.17g}, {:.17g}", separator, corner.x, corner.y, corner.z);
    normals += fmt::format("{}{:.17g}, {:.17g}, {:.17g}", separator, n.x, n.y, n.z);
  }
  return fmt::format(
      R"({{"name": "square{}", "positions": [{}], "normals": [{}], "triangles": [0, 1, 2, 0, 2, 3], )"
      R"("material": "{}"}})",
      positions, positions, normals, material);
}

/// "meshes" and "instances" of such squares.
inline std::string meshes(const std::vector<std::string>& squares) {
  std::string instances;
  for (const auto& text : squares) {
    const auto begin = text.find("square");
    instances += fmt::format(R"({}{{"mesh": "{}"}})", instances.empty() ? "" : ", ",
                             text.substr(begin, text.find('"', begin) - begin));
  }
  return fmt::format(R"("meshes": [{}], "instances": [{}])", fmt::join(squares, ", "), instances);
}

inline image::Image image_of(const std::string& text,
                             int samples_per_pixel,
                             const tracer::WorldSettings& world = {},
                             std::uint64_t seed = 1) {
  const std::atomic<bool> never{false};
  const auto rendering = tracer::render(
      tracer::make_world(scene::load_scene_text("test.json", text, ORBS_SOURCE_DIR), world),
      {.samples_per_pixel = samples_per_pixel, .seed = seed}, never, [](const tracer::Progress&) {});
  EXPECT_EQ(rendering.bad_samples.count, 0U);
  return rendering.image;
}

inline std::size_t channel_of(const image::Image& image, std::string_view name) {
  const int index = image::channel_index(image, std::string(name));
  if (index < 0) throw std::runtime_error(fmt::format("the image has no channel {}", name));
  return static_cast<std::size_t>(index);
}

inline double mean_of(const image::Image& image, std::string_view channel) {
  return mean_of_channel(image, channel_of(image, channel));
}

/// The mean over pixels with equal expectation, and its standard error from their spread: for layers without
/// a variance of their own.
struct Estimate {
  double mean = 0;
  double error = 0;
};

inline Estimate estimate_of(const image::Image& image, std::string_view channel) {
  const std::size_t at = channel_of(image, channel);
  const double mean = mean_of_channel(image, at);
  double squares = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const double off = image.at(x, y, at) - mean;
      squares += off * off;
    }
  const auto count = static_cast<double>(image.pixel_count());
  return {mean, std::sqrt(squares / (count - 1) / count)};
}

}  // namespace orbs::tests
