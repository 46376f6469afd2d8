#include "tracer/world/prepare_camera.h"

#include "scene/camera_frame.h"
#include "scene/motion.h"

#include <cmath>

namespace orbs::tracer {

namespace {

struct KindOf {
  const scene::Camera& camera;

  CameraKind operator()(const scene::Perspective&) const {
    if (!scene::has_lens(camera)) return Pinhole{};
    return ThinLens{static_cast<float>(camera.aperture_radius_m),
                    static_cast<float>(camera.focus_distance_m.value())};
  }
  CameraKind operator()(const scene::Orthographic&) const { return Orthographic{}; }
  CameraKind operator()(const scene::LatitudeLongitude&) const { return LatitudeLongitude{}; }
};

// By the triangle inequality a point that is nearer is more than two radii from the middle of the scene: of a
// camera whose rays are parallel that middle counts by its depth, and rays begin at the camera where the
// scene reaches its plane. All points of a lens are within its radius.
double start_of_rays(const scene::Camera& camera, const scene::Extent& extent, Vec3d forward) {
  const Vec3d to_scene = extent.centre - camera.position_m;
  const bool is_parallel = std::holds_alternative<scene::Orthographic>(camera.projection);
  const double distance = is_parallel ? dot(to_scene, forward) : length(to_scene);
  return std::fmax(0.0, distance - 2 * extent.radius_m - camera.aperture_radius_m);
}

}  // namespace

Camera prepare_camera(const scene::Camera& camera, const scene::Extent& extent, Vec3d origin) {
  const auto frame = scene::camera_frame(camera);
  const bool has_plane = !std::holds_alternative<scene::LatitudeLongitude>(camera.projection);
  const DistantCamera exact{camera.position_m - origin,
                            frame.forward,
                            frame.forward + frame.right * frame.centre.x + frame.up * frame.centre.y,
                            has_plane ? frame.right * frame.half_width : frame.right,
                            has_plane ? frame.up * frame.half_height : frame.up,
                            start_of_rays(camera, extent, frame.forward)};
  Camera prepared{cast<float>(exact.position),
                  cast<float>(exact.forward),
                  cast<float>(exact.centre),
                  cast<float>(exact.right),
                  cast<float>(exact.up),
                  camera.width_px,
                  camera.height_px,
                  std::visit(KindOf{camera}, camera.projection)};
  if (extent.camera_is_distant) prepared.distant = exact;
  return prepared;
}

Camera camera_at(const MovingCamera& moving, const Camera& start, float time) {
  const auto camera = scene::camera_at(moving.camera, static_cast<double>(time));
  auto prepared = prepare_camera(camera, moving.extent, moving.origin);
  prepared.width = start.width;
  prepared.height = start.height;
  return prepared;
}

}  // namespace orbs::tracer
