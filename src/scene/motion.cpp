#include "scene/motion.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace orbs::scene {

namespace {

Mat4 between(const Mat4& start, const Mat4& end, double time) {
  Mat4 out;
  for (std::size_t i = 0; i < out.m.size(); ++i) out.m[i] = (1 - time) * start.m[i] + time * end.m[i];
  return out;
}

std::vector<Vec3f> between(const std::vector<Vec3f>& start, const std::vector<Vec3f>& end, double time) {
  std::vector<Vec3f> out;
  out.reserve(start.size());
  for (std::size_t i = 0; i < start.size(); ++i)
    out.push_back(cast<float>(cast<double>(start[i]) * (1 - time) + cast<double>(end[i]) * time));
  return out;
}

Vec3d column(const Mat4& m, std::size_t c) { return {m(0, c), m(1, c), m(2, c)}; }

using Columns = std::array<Vec3d, 3>;

// Of the powers of t in det(a + t b), for the determinant is linear in each column.
std::array<double, 4> determinant_polynomial(const Columns& a, const Columns& b) {
  const auto det = [](Vec3d x, Vec3d y, Vec3d z) { return dot(x, cross(y, z)); };
  return {det(a[0], a[1], a[2]), det(b[0], a[1], a[2]) + det(a[0], b[1], a[2]) + det(a[0], a[1], b[2]),
          det(b[0], b[1], a[2]) + det(b[0], a[1], b[2]) + det(a[0], b[1], b[2]), det(b[0], b[1], b[2])};
}

// Times in (0, 1) at which c1 + 2 c2 t + 3 c3 t^2, the derivative, is zero.
std::vector<double> turning_times(const std::array<double, 4>& c) {
  const double p = c[2];
  const double discriminant = p * p - 3 * c[3] * c[1];
  std::vector<double> times;
  if (discriminant >= 0) {
    // Without cancellation: the larger root first, the other by their product.
    const double q = -(p + std::copysign(std::sqrt(discriminant), p));
    for (const double t : {q / (3 * c[3]), c[1] / q})
      if (t > 0 && t < 1) times.push_back(t);  // also false for what a zero has divided
  }
  return times;
}

}  // namespace

bool is_moving(const Scene& scene, const Instance& instance) {
  return instance.end_matrix || mesh_of(scene, instance).end;
}

namespace {

bool is_open(const Shutter& shutter) { return shutter.open < shutter.close; }

}  // namespace

bool has_moving_objects(const Scene& scene) {
  return is_open(scene.camera.shutter) &&
         std::any_of(scene.instances.begin(), scene.instances.end(),
                     [&](const Instance& instance) { return is_moving(scene, instance); });
}

bool has_motion(const Scene& scene) {
  return (scene.camera.end && is_open(scene.camera.shutter)) || has_moving_objects(scene);
}

Mat4 matrix_at(const Instance& instance, double time) {
  return instance.end_matrix ? between(instance.matrix, *instance.end_matrix, time) : instance.matrix;
}

Camera camera_at(const Camera& camera, double time) {
  Camera out = camera;
  out.shutter = {};
  if (!camera.end) return out;
  const auto& [position_m, look_at_m, up] = *camera.end;
  out.position_m = camera.position_m * (1 - time) + position_m * time;
  out.look_at_m = camera.look_at_m * (1 - time) + look_at_m * time;
  out.up = camera.up * (1 - time) + up * time;
  out.end.reset();
  return out;
}

namespace {

void stop(Scene& scene, double time) {
  scene.camera = camera_at(scene.camera, time);
  for (Instance& instance : scene.instances) {
    instance.matrix = matrix_at(instance, time);
    instance.end_matrix.reset();
  }
  for (Mesh& mesh : scene.meshes) {
    if (!mesh.end) continue;
    mesh.positions = between(mesh.positions, mesh.end->positions, time);
    mesh.normals = between(mesh.normals, mesh.end->normals, time);
    mesh.end.reset();
  }
}

}  // namespace

Scene at_time(const Scene& scene, double time) {
  Scene out = scene;
  stop(out, time);
  return out;
}

void drop_unseen_motion(Scene& scene) {
  for (Instance& instance : scene.instances)
    if (instance.end_matrix == instance.matrix) instance.end_matrix.reset();
  for (Mesh& mesh : scene.meshes)
    if (mesh.end && mesh.end->positions == mesh.positions && mesh.end->normals == mesh.normals)
      mesh.end.reset();
  auto& camera = scene.camera;
  if (camera.end == CameraEnd{camera.position_m, camera.look_at_m, camera.up}) camera.end.reset();
  if (!has_motion(scene)) stop(scene, scene.camera.shutter.open);
}

std::string motion_problem(const Mat4& start, const Mat4& end) {
  Columns from;
  Columns change;
  double size = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    from[c] = column(start, c);
    change[c] = column(end, c) - from[c];
    size = std::max({size, length(from[c]), length(column(end, c))});
  }
  const auto c = determinant_polynomial(from, change);
  auto times = turning_times(c);
  times.push_back(1);
  for (const double t : times) {
    const double determinant = c[0] + t * (c[1] + t * (c[2] + t * c[3]));
    // As inverse() has it, and on the side of the start.
    if (!(std::copysign(1.0, c[0]) * determinant > 1e-12 * size * size * size))
      return fmt::format(
          "the matrices between start and end, which are linear in time, are singular on the way to {:.3g} of "
          "the frame: turn by less than 180 degrees, and do not mirror",
          t);
  }
  return "";
}

bool meets_zero(Vec3d from, Vec3d to) {
  constexpr double kLeastShare = 1e-6;
  const Vec3d change = to - from;
  if (dot(change, change) == 0) return false;
  const double time = std::clamp(-dot(from, change) / dot(change, change), 0.0, 1.0);
  return length(from + change * time) <= kLeastShare * std::max(length(from), length(to));
}

namespace {

// Of the angle between the view and the up direction, on which gluLookAt divides.
double sine_at(const Camera& camera, double time) {
  const Camera now = camera_at(camera, time);
  const Vec3d view = now.look_at_m - now.position_m;
  return length(cross(view, now.up)) / (length(view) * length(now.up));
}

// The time of the least sine. Both vectors run over straight lines, so a dip lasts long enough for one of
// these times to lie within it; thirds then close in on its end.
double time_of_least_sine(const Camera& camera) {
  constexpr int kTimes = 256;
  constexpr int kThirds = 96;  // (2 / 3)^96 is below what doubles tell
  int least = 0;
  for (int i = 1; i <= kTimes; ++i)
    if (sine_at(camera, static_cast<double>(i) / kTimes) <
        sine_at(camera, static_cast<double>(least) / kTimes))
      least = i;
  double low = std::max(0, least - 1) / static_cast<double>(kTimes);
  double high = std::min(kTimes, least + 1) / static_cast<double>(kTimes);
  for (int i = 0; i < kThirds; ++i) {
    const double third = (high - low) / 3;
    if (sine_at(camera, low + third) < sine_at(camera, high - third))
      high -= third;
    else
      low += third;
  }
  return (low + high) / 2;
}

}  // namespace

std::string motion_problem(const Camera& camera) {
  constexpr double kLeastSine = 1e-9;  // as of a camera at rest
  if (!camera.end) return "";
  if (length(camera.end->look_at_m - camera.end->position_m) == 0)
    return "look_at must differ from position: the view has no direction";
  if (meets_zero(camera.look_at_m - camera.position_m, camera.end->look_at_m - camera.end->position_m))
    return "the camera meets the point that it looks at on its way, where the view has no direction";
  if (length(camera.end->up) == 0 || meets_zero(camera.up, camera.end->up))
    return "'up' is no direction at some time on the way";
  if (const double time = time_of_least_sine(camera); !(sine_at(camera, time) > kLeastSine))
    return fmt::format("up must not be parallel to the view direction, as it is at {:.3g} of the frame",
                       time);
  return "";
}

}  // namespace orbs::scene
