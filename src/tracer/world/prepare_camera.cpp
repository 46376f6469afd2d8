#include "tracer/world/prepare_camera.h"

#include "scene/camera_frame.h"
#include "scene/motion.h"

namespace orbs::tracer {

PinholeCamera prepare_camera(const scene::Camera& camera, const scene::Extent& extent, Vec3d origin) {
  const auto frame = scene::camera_frame(camera);
  const Vec3d position = camera.position_m - origin;
  const Vec3d right = frame.right * frame.half_width;
  const Vec3d up = frame.up * frame.half_height;
  PinholeCamera prepared{cast<float>(position), cast<float>(frame.forward),
                         cast<float>(right),    cast<float>(up),
                         camera.width_px,       camera.height_px};
  // By the triangle inequality a point that is nearer is more than two radii from the middle of the scene.
  if (extent.camera_is_distant)
    prepared.distant = {position, frame.forward, right, up,
                        length(camera.position_m - extent.centre) - 2 * extent.radius_m};
  return prepared;
}

PinholeCamera camera_at(const MovingCamera& moving, const PinholeCamera& start, float time) {
  const auto camera = scene::camera_at(moving.camera, static_cast<double>(time));
  auto prepared = prepare_camera(camera, moving.extent, moving.origin);
  prepared.width = start.width;
  prepared.height = start.height;
  return prepared;
}

}  // namespace orbs::tracer
