#include "scene/load/camera.h"

#include "base/text.h"
#include "scene/camera_frame.h"
#include "scene/load/entry.h"
#include "scene/motion.h"

#include <map>
#include <optional>
#include <set>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace orbs::scene {

namespace {

// Directions are floats, rounded by up to 6e-8: with finer pixels the image would move by a tenth of a pixel.
void check_pixels(json::ObjectReader& in, const Camera& camera) {
  constexpr double kFinest_rad = 1e-6;
  if (!is_perspective(camera)) return;  // no other camera has an angle that a key may narrow
  const double pixel_rad = 2 * camera_frame(camera).half_height / camera.height_px;
  if (!(pixel_rad >= kFinest_rad))
    in.fail(
        in.has("fov_y") ? "fov_y" : "height",
        fmt::format("makes pixels of {:.4g} rad; they must be at least {} rad high, which is what directions "
                    "in float can tell: widen fov_y, or take fewer pixels",
                    pixel_rad, kFinest_rad));
}

Shutter load_shutter(json::ObjectReader& in) {
  if (!in.has("shutter")) return {};
  const auto times = in.numbers("shutter", 2, {0, 1});
  if (times[0] > times[1])
    in.fail("shutter", fmt::format("must open before it closes, it opens at {} and closes at {} of the frame",
                                   times[0], times[1]));
  return {times[0], times[1]};
}

CameraEnd load_camera_end(json::ObjectReader in, const Camera& start) {
  const CameraEnd end{in.vec3_or("position", start.position_m, kPlace),
                      in.vec3_or("look_at", start.look_at_m, kPlace), in.vec3_or("up", start.up, kPlace)};
  in.finish();
  return end;
}

void refuse_of_others(json::ObjectReader& in, const Camera& camera, const std::vector<const char*>& keys) {
  const char* what = std::visit([](const auto& kind) { return kind.kWhat; }, camera.projection);
  for (const char* key : keys)
    if (in.has(key)) in.fail(key, fmt::format("is for a perspective, and the camera is {}", what));
}

struct LoadProjection {
  json::ObjectReader& in;
  Camera& camera;

  void operator()(Perspective&) const {
    constexpr double kMostShift = 100;  // images; the field of view ends long before
    camera.fov_y_deg = in.number_or("fov_y", camera.fov_y_deg, {1e-3, 179.0});
    if (in.has("shift")) {
      const auto shift = in.numbers("shift", 2, {-kMostShift, kMostShift});
      camera.shift = {shift[0], shift[1]};
    }
    camera.aperture_radius_m = in.number_or("aperture_radius", 0, json::kNotNegative);
    if (has_lens(camera) && !in.has("focus_distance"))
      in.fail("aperture_radius", "is that of a lens, which needs a 'focus_distance'");
  }
  void operator()(Orthographic& projection) const {
    projection.height_m = in.number("view_height", json::kPositive);
  }
  void operator()(LatitudeLongitude&) const {}
};

void load_projection(json::ObjectReader& in, Camera& camera) {
  const auto type = in.one_of_or("projection", Perspective::kType,
                                 {Perspective::kType, Orthographic::kType, LatitudeLongitude::kType});
  for (const Projection& kind : {Projection{}, Projection{Orthographic{}}, Projection{LatitudeLongitude{}}})
    if (type == std::visit([](const auto& one) { return one.kType; }, kind)) camera.projection = kind;
  if (!is_perspective(camera)) refuse_of_others(in, camera, {"fov_y", "shift", "aperture_radius"});
  if (!std::holds_alternative<Orthographic>(camera.projection) && in.has("view_height"))
    in.fail("view_height", "is for an orthographic camera");
  std::visit(LoadProjection{in, camera}, camera.projection);
}

Camera load_camera(json::ObjectReader in) {
  constexpr int kLargestSide = 65536;
  constexpr long long kMostPixels = 1LL << 26;
  Camera camera;
  camera.position_m = in.vec3("position", kPlace);
  camera.look_at_m = in.vec3("look_at", kPlace);
  camera.up = in.vec3_or("up", camera.up, kPlace);
  load_projection(in, camera);
  camera.width_px = in.integer_or("width", camera.width_px, 1, kLargestSide);
  camera.height_px = in.integer_or("height", camera.height_px, 1, kLargestSide);
  // The images of a render, with variances and in double, take some 100 bytes for each pixel.
  if (const auto pixels = static_cast<long long>(camera.width_px) * camera.height_px; pixels > kMostPixels)
    in.fail(in.has("height") ? "height" : "width",
            fmt::format("{} x {} are {} pixels; an image may have at most {} (8192 x 8192)", camera.width_px,
                        camera.height_px, pixels, kMostPixels));
  camera.near_m = in.number_or("near", camera.near_m, json::kPositive);
  camera.far_m = in.number_or("far", camera.far_m, json::kPositive);
  if (in.has("focus_distance")) camera.focus_distance_m = in.number("focus_distance", json::kPositive);
  camera.shutter = load_shutter(in);
  if (in.has("end")) camera.end = load_camera_end(in.object("end"), camera);
  in.finish();
  if (camera.near_m >= camera.far_m)
    in.fail(in.has("near") ? "near" : "far",
            fmt::format("'near' must be below 'far', they are {} and {}", camera.near_m, camera.far_m));
  const Vec3d view = camera.look_at_m - camera.position_m;
  if (length(view) == 0) in.fail("look_at", "must differ from position: the view has no direction");
  // gluLookAt divides by |view x up|: below 1e-9 of their lengths the image's up direction is rounding
  // noise.
  if (length(cross(view, camera.up)) <= 1e-9 * length(view) * length(camera.up))
    in.fail(in.has("up") ? "up" : "look_at", "up must not be parallel to the view direction");
  if (const auto problem = motion_problem(camera); !problem.empty()) in.fail("end", problem);
  check_pixels(in, camera);
  return camera;
}

}  // namespace

Camera load_cameras(json::ObjectReader& in, const std::string& chosen) {
  if (!in.has("cameras") && chosen.empty()) return load_camera(in.object("camera"));
  std::map<std::string, Camera> named;
  std::set<std::string> names;
  if (in.has("cameras")) {
    auto cameras = in.object("cameras");
    for (const auto& name : cameras.keys()) {
      if (!is_plain_name(name))
        cameras.fail(name, "is no plain name: at most 100 letters, digits, '-' and '_'");
      named[name] = load_camera(cameras.object(name));
      names.insert(name);
    }
    cameras.finish();
    if (named.empty()) in.fail("cameras", "must hold at least one camera by its name; leave it out for none");
  }
  const auto own = in.has("camera") ? std::optional(load_camera(in.object("camera"))) : std::nullopt;
  if (chosen.empty() && own) return *own;
  if (const auto found = named.find(chosen); found != named.end()) return found->second;
  const auto there_are =
      names.empty() ? "the file has no \"cameras\"" : fmt::format("there are: {}", fmt::join(names, ", "));
  if (chosen.empty())
    in.fail("", fmt::format("has several cameras and none without a name; choose one, by \"camera\" in the "
                            "scene's entry of case.json or by --camera of orbs-tracer; {}",
                            there_are));
  in.fail("cameras", fmt::format("there is no camera '{}'{}; {}", clean_line(chosen), closest(chosen, names),
                                 there_are));
}

}  // namespace orbs::scene
