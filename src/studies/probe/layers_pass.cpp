#include "studies/probe/layers_pass.h"

#include "image/layers.h"
#include "metrics/image_pair.h"
#include "metrics/surface_layers.h"
#include "scene/camera_frame.h"

#include <algorithm>
#include <limits>
#include <span>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::studies {

namespace {

// Of one pixel: the mean and the range of each channel.
struct PixelValues {
  std::vector<double> sums;
  std::vector<double> least;
  std::vector<double> most;
};

// Whether all points see one mesh: lights have no normals here, and the background has no depth.
bool is_of_one_mesh(std::span<const VisibleSurface> points, int meshes) {
  return std::all_of(points.begin(), points.end(), [&](const VisibleSurface& point) {
    return point.object == points.front().object && point.object != kNoObject && point.object < meshes;
  });
}

// The layers of a point of the image in the order of kProbedLayers, and of a ray whose length along the axis
// is 1.
std::vector<double> values_of(const VisibleSurface& point, Vec3d eye, Vec3d ray) {
  const Vec3d position = eye + ray * point.depth_m;
  Vec3d normal = cast<double>(point.normal);
  if (dot(normal, ray) > 0) normal = -normal;
  return {point.depth_m,
          position.x,
          position.y,
          position.z,
          normal.x,
          normal.y,
          normal.z,
          static_cast<double>(point.u),
          static_cast<double>(point.v)};
}

std::vector<std::string> probed_channels() {
  std::vector<std::string> channels;
  for (const auto& layer : kProbedLayers)
    for (auto& channel : image::channels_of(*image::find_layer(layer)))
      channels.push_back(std::move(channel));
  return channels;
}

void add(PixelValues& pixel, const std::vector<double>& values) {
  if (pixel.sums.empty()) {
    pixel = {values, values, values};
    return;
  }
  for (std::size_t c = 0; c < values.size(); ++c) {
    pixel.sums[c] += values[c];
    pixel.least[c] = std::min(pixel.least[c], values[c]);
    pixel.most[c] = std::max(pixel.most[c], values[c]);
  }
}

// The points of the default grid over one pixel.
PixelValues values_of_pixel(const scene::Scene& scene,
                            const scene::CameraFrame& frame,
                            std::span<const VisibleSurface> points,
                            Pixel at) {
  constexpr VisibilityGrid kGrid{};
  const double step = (1 + 2 * kGrid.margin_px) / (kGrid.per_side - 1);
  PixelValues pixel;
  std::size_t k = 0;
  for (int row = 0; row < kGrid.per_side; ++row)
    for (int column = 0; column < kGrid.per_side; ++column) {
      const auto ray = scene::camera_ray(scene.camera, frame, at.x - kGrid.margin_px + step * column,
                                         at.y - kGrid.margin_px + step * row);
      add(pixel, values_of(points[k++], ray.origin_m, ray.direction));
    }
  return pixel;
}

// With the range of each channel, as the tracer writes layers. Pixels that more than one thing shares are
// half covered, so that their values do not count.
image::Image visible_layers(const ProbeScene& probe, const std::vector<VisibleSurface>& surfaces) {
  constexpr VisibilityGrid kGrid{};
  const auto channels = probed_channels();
  std::vector<std::string> names{"R", "G", "B", "coverage.A"};
  for (const auto& channel : channels)
    for (const auto prefix : {std::string_view{}, image::kLeast, image::kMost})
      names.push_back(std::string(prefix) + channel);
  const auto& camera = probe.scene.camera;
  auto out = image::make_image(camera.width_px, camera.height_px, names);
  const auto frame = scene::camera_frame(camera);
  const auto side = static_cast<std::size_t>(kGrid.per_side);
  const std::size_t each = side * side;
  for (int y = 0; y < out.height; ++y)
    for (int x = 0; x < out.width; ++x) {
      const auto index =
          static_cast<std::size_t>(y) * static_cast<std::size_t>(out.width) + static_cast<std::size_t>(x);
      const auto points = std::span(surfaces).subspan(index * each, each);
      const bool counts = is_of_one_mesh(points, static_cast<int>(probe.scene.materials.size()));
      constexpr float kHalf = 0.5F;
      out.at(x, y, 3) = counts ? 1 : kHalf;
      const auto pixel = values_of_pixel(probe.scene, frame, points, {x, y});
      for (std::size_t c = 0; c < channels.size(); ++c) {
        out.at(x, y, 4 + 3 * c) = static_cast<float>(pixel.sums[c] / static_cast<double>(each));
        out.at(x, y, 5 + 3 * c) = static_cast<float>(pixel.least[c]);
        out.at(x, y, 6 + 3 * c) = static_cast<float>(pixel.most[c]);
      }
    }
  return out;
}

}  // namespace

LayerFindings compare_layers(const ProbeScene& probe,
                             const std::vector<VisibleSurface>& surfaces,
                             const image::Image& image,
                             const std::vector<std::string>& layers) {
  auto reference = visible_layers(probe, surfaces);
  reference.attributes["orbs.layers"] = fmt::format("{}", fmt::join(layers, " "));
  LayerFindings findings;
  for (int y = 0; y < reference.height; ++y)
    for (int x = 0; x < reference.width; ++x) findings.compared += reference.at(x, y, 3) == 1 ? 1 : 0;
  metrics::ImagePair pair;  // the colours, which are ids, do not matter
  static_cast<metrics::PairSamples&>(pair) = metrics::pair_samples(image, reference);
  const auto found = metrics::compute_layer_pixels(pair);
  if (!found.value)
    findings.fault = fmt::format("it lacks the layers {}", found.what);
  else if (*found.value > 0)
    findings.fault = fmt::format("{}; so in {:.0f} px", found.what, *found.value);
  return findings;
}

}  // namespace orbs::studies
