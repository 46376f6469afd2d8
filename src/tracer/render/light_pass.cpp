#include "tracer/render/light_pass.h"

namespace orbs::tracer {

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

PinholeCamera mirrored(const MirrorPlane& plane, const PinholeCamera& camera) {
  PinholeCamera image = camera;
  image.position = mirrored(plane, camera.position);
  image.forward = mirrored_direction(plane, camera.forward);
  image.right = mirrored_direction(plane, camera.right);
  image.up = mirrored_direction(plane, camera.up);
  return image;
}

CameraProjection project(const PinholeCamera& camera, Vec3f point) {
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
