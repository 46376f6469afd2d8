#pragma once

#include "tracer/cameras/latitude_longitude.h"
#include "tracer/cameras/orthographic.h"
#include "tracer/cameras/pinhole.h"
#include "tracer/cameras/thin_lens.h"
#include "tracer/geometry/mirror_plane.h"
#include "tracer/geometry/ray.h"

#include <optional>
#include <variant>

namespace orbs::tracer {

/// A camera that is many times farther from the scene than the scene is large. In floats its rays would miss
/// their points by 2^-24 of the distance, so they are computed in double and begin before the scene.
struct DistantCamera {
  Vec3d position;  // and the vectors of Camera
  Vec3d forward;
  Vec3d centre;
  Vec3d right;
  Vec3d up;
  double start_m = 0;  // no surface is nearer to where a ray begins
};

/// A kind is a file of tracer/cameras, and its functions film_ray and film_place.
using CameraKind = std::variant<Pinhole, ThinLens, Orthographic, LatitudeLongitude>;

struct Camera {
  Vec3f position;
  Vec3f forward;  // unit
  Vec3f centre;   // to the centre of the image plane at distance 1: `forward` unless the window is shifted
  Vec3f right;    // half the width of the image plane, of an orthographic camera in metres
  Vec3f up;       // half its height
  int width = 0;  // of the image in pixels
  int height = 0;
  CameraKind kind{};
  std::optional<DistantCamera> distant{};
};

/// Ray through film position (x, y), in pixels from the upper left corner; of a lens through its middle.
Ray camera_ray(const Camera& camera, float x, float y);

/// Whether a ray needs a point of the lens besides that of the film.
inline bool has_lens(const Camera& camera) { return std::holds_alternative<ThinLens>(camera.kind); }

/// The pinhole that sees the image from one point of the camera's lens; u and v in [0, 1) are uniform on the
/// lens.
Camera seen_through(const Camera& camera, float u, float v);

/// Where the camera sees a point, and the factor from the area of the surface to the mean over the pixel.
struct CameraProjection {
  std::uint32_t pixel = 0;
  float importance = 0;  // per m^2 of surface perpendicular to the ray; 0 outside the image
  Vec3f viewpoint;       // where the ray of the camera begins
};

CameraProjection project(const Camera& camera, Vec3f point);

/// Where a ray of the camera begins, also of a distant camera, whose rays are cut off.
Vec3f viewpoint_of(const Camera& camera, const Ray& ray);

/// Across the ray to the right of the image, as far as a vector that need not be unit or perpendicular says.
Vec3f image_right(const Camera& camera, const Ray& ray);

/// Width of the middle pixel where a path has travelled so far from the camera.
float pixel_width(const Camera& camera, float distance);

/// The mirrored camera sees a point where the camera sees its reflection.
Camera mirrored(const MirrorPlane& plane, const Camera& camera);

}  // namespace orbs::tracer
