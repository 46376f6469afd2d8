// Every kind of camera: its rays and its projection are each other's inverse, and the importance is the
// density of the rays.
#include "base/nth.h"
#include "tracer/world/camera.h"
#include "tracer/world/prepare_camera.h"
#include "unit/tracer/scenes.h"

#include <cmath>
#include <map>

#include <fmt/format.h>
#include <gtest/gtest.h>

using namespace orbs;

namespace {

// Looks along no axis.
tracer::Camera camera_of(const std::string& keys) {
  const auto scene = scene::load_scene_text(
      "s.json",
      fmt::format(R"({{"format": "orbs-scene/1", "name": "s", "camera": {{"position": [1, 2, 3],
"look_at": [-0.5, 0.3, 0.2], "width": 32, "height": 16, {}}}, "materials": []}})",
                  keys),
      ".");
  return tracer::prepare_camera(scene.camera, {scene.camera.position_m}, {});
}

std::map<std::string, tracer::Camera> cameras() {
  const auto lens = camera_of(R"("fov_y": 50, "focus_distance": 2, "aperture_radius": 0.3)");
  return {{"pinhole", camera_of(R"("fov_y": 50)")},
          {"shifted", camera_of(R"("fov_y": 50, "shift": [0.3, -0.2])")},
          {"middle of a lens", lens},
          {"rim of a lens", tracer::seen_through(lens, 0.9F, 0.3F)},
          {"orthographic", camera_of(R"("projection": "orthographic", "view_height": 3)")},
          {"latitude-longitude", camera_of(R"("projection": "latitude_longitude")")}};
}

constexpr std::array kPlaces{std::array{3.5F, 2.5F}, std::array{15.5F, 8.5F}, std::array{20.5F, 12.5F},
                             std::array{30.5F, 6.5F}};
constexpr float kDistance = 4;

Vec3f point_on(const tracer::Ray& ray) { return ray.origin + ray.direction * kDistance; }

// Where a ray meets the plane across another one at its point.
Vec3d on_plane(const tracer::Ray& ray, const tracer::Ray& middle) {
  const Vec3d normal = cast<double>(middle.direction);
  const Vec3d origin = cast<double>(ray.origin);
  const Vec3d direction = cast<double>(ray.direction);
  return origin + direction * (dot(normal, cast<double>(point_on(middle)) - origin) / dot(normal, direction));
}

}  // namespace

TEST(CameraKinds, APointOnARayIsSeenInItsPixel) {
  for (const auto& [name, camera] : cameras())
    for (const auto& [x, y] : kPlaces) {
      const auto ray = tracer::camera_ray(camera, x, y);
      const auto seen = tracer::project(camera, point_on(ray));
      EXPECT_EQ(seen.pixel, static_cast<std::uint32_t>(y) * 32 + static_cast<std::uint32_t>(x)) << name;
      EXPECT_LT(length(seen.viewpoint - ray.origin), 2e-6F) << name;
    }
}

TEST(CameraKinds, TheImportanceIsTheShareOfThePixelInTheSurface) {
  constexpr float kStep = 0.02F;
  for (const auto& [name, camera] : cameras())
    for (const auto& [x, y] : kPlaces) {
      const auto middle = tracer::camera_ray(camera, x, y);
      const auto at = [&](float dx, float dy) {
        return on_plane(tracer::camera_ray(camera, x + dx, y + dy), middle);
      };
      const Vec3d across = at(kStep, 0) - at(-kStep, 0);
      const Vec3d along = at(0, kStep) - at(0, -kStep);
      const double area = length(cross(across, along)) / (4 * kStep * kStep);
      const auto seen = tracer::project(camera, point_on(middle));
      EXPECT_NEAR(static_cast<double>(seen.importance) * area, 1, 2e-3) << name << " at " << x;
    }
}

TEST(CameraKinds, ALensSeesOnePointInFocusFromEverywhere) {
  const auto lens = camera_of(R"("fov_y": 50, "focus_distance": 2, "aperture_radius": 0.3)");
  for (const auto& [x, y] : kPlaces) {
    const auto middle = tracer::camera_ray(lens, x, y);
    const float depth = dot(middle.direction, lens.forward);
    const Vec3f focus = middle.origin + middle.direction * (2 / depth);  // on a plane, not on a sphere
    for (const float u : {0.0F, 0.5F, 0.99F})
      for (const float v : {0.1F, 0.6F}) {
        const auto ray = tracer::camera_ray(tracer::seen_through(lens, u, v), x, y);
        EXPECT_NEAR(length(cross(focus - ray.origin, ray.direction)), 0, 2e-6);
        EXPECT_NEAR(length(ray.origin - lens.position), 0.3F * std::sqrt(u), 1e-6) << "uniform on the disk";
        EXPECT_NEAR(dot(ray.origin - lens.position, lens.forward), 0, 1e-6);
      }
  }
}

TEST(CameraKinds, DirectionsOfALatitudeLongitudeImageAreTheStated) {
  const auto camera = camera_of(R"("projection": "latitude_longitude")");
  const auto expect = [&](float x, float y, Vec3f direction) {
    EXPECT_LT(length(tracer::camera_ray(camera, x, y).direction - direction), 1e-6F) << x << ", " << y;
  };
  expect(16, 8, camera.forward);
  expect(24, 8, camera.right);
  expect(8, 8, -camera.right);
  expect(0, 8, -camera.forward);
  expect(16, 0, camera.up);
  expect(16, 4, normalised(camera.forward + camera.up));
}

// Stokes vectors are measured from there.
TEST(CameraKinds, TheRightOfTheImageIsAlongItsRows) {
  for (const auto& [name, camera] : cameras())
    for (const auto& [x, y] : kPlaces) {
      const auto ray = tracer::camera_ray(camera, x, y);
      const auto next = tracer::camera_ray(camera, x + 0.1F, y);
      EXPECT_GT(
          dot(tracer::image_right(camera, ray), next.direction - ray.direction + next.origin - ray.origin), 0)
          << name;
    }
}
