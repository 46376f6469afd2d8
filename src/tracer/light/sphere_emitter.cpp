#include "tracer/light/sphere_emitter.h"

#include "tracer/accel/curved_surface.h"
#include "tracer/geometry/transforms.h"
#include "tracer/sampling/warps.h"

#include <algorithm>

namespace orbs::tracer {

namespace {

Vec3f to_local(const SphereEmitter& sphere, Vec3f v) {
  return {dot(sphere.inverse[0], v), dot(sphere.inverse[1], v), dot(sphere.inverse[2], v)};
}

Vec3f to_world(const SphereEmitter& sphere, Vec3f v) {
  return sphere.axes[0] * v.x + sphere.axes[1] * v.y + sphere.axes[2] * v.z;
}

// The gradient of |inverse (p - centre)|^2 where that is the local point, not normalised.
Vec3f gradient_at(const SphereEmitter& sphere, Vec3f local) {
  return sphere.inverse[0] * local.x + sphere.inverse[1] * local.y + sphere.inverse[2] * local.z;
}

// A linear map A takes a cone of directions w with solid angle dw to one with |det A| / |A w|^3 dw, by the
// volume and radius of the cone.
float stretched_pdf(const SphereEmitter& sphere, Vec3f local_unit_direction, float local_pdf) {
  const float stretch = length(to_world(sphere, local_unit_direction));
  return local_pdf * stretch * stretch * stretch / sphere.determinant;
}

// 1 - cos of the half angle that the unit sphere subtends at distance d > 1, without cancellation far away.
float cone_height(float distance2) {
  const float sin2 = 1 / distance2;
  return sin2 / (1 + std::sqrt(1 - sin2));
}

}  // namespace

SphereEmitter make_emitter(const scene::SphereShape& sphere, const Mat4& matrix, Vec3f) {
  const Mat4 map = matrix * scaling({sphere.radius_m, sphere.radius_m, sphere.radius_m});
  const Mat4 back = inverse(map).value();
  SphereEmitter out{.centre = cast<float>(transform_point(matrix, {})), .axes = affine(map).axes};
  for (std::size_t r = 0; r < 3; ++r) out.inverse[r] = cast<float>(Vec3d{back(r, 0), back(r, 1), back(r, 2)});
  out.determinant = static_cast<float>(std::abs(determinant3(map)));
  out.area = 4 * kPi * std::pow(out.determinant, 2.0F / 3.0F);
  return out;
}

CurvedSurface surface_of(const SphereEmitter& sphere) {
  return {
      cast<double>(sphere.centre),
      inverse_rows(cast<double>(sphere.axes[0]), cast<double>(sphere.axes[1]), cast<double>(sphere.axes[2])),
      true};
}

std::optional<EmitterPoint> sample_towards(const SphereEmitter& sphere, Vec3f from, float u, float v) {
  const Vec3f view = to_local(sphere, from - sphere.centre);
  const float distance2 = dot(view, view);
  const float error = rounding_of(sphere);
  if (distance2 <= 1) return std::nullopt;  // from inside the light is dark
  // Uniform over the visible cone (Shirley et al. 1996). The cosine of the point's angle follows from the law
  // of sines, which is accurate for small spheres (Pharr, Jakob, Humphreys 2023, Physically Based Rendering,
  // 4th ed., 6.2.4), its sine from the distance along the ray, which is accurate close to the sphere.
  const float height = cone_height(distance2);
  const float one_minus_cos = u * height;
  const float sin2_theta = one_minus_cos * (2 - one_minus_cos);
  const float cos_theta = 1 - one_minus_cos;
  const float distance = std::sqrt(distance2);
  // Rounding only: sin(theta) <= 1 / d inside the cone.
  const float root = std::sqrt(std::max(0.0F, 1 - sin2_theta * distance2));
  const float cos_alpha = sin2_theta * distance + cos_theta * root;
  const float along_ray = (distance2 - 1) / (distance * cos_theta + root);
  const float sin_alpha = along_ray * std::sqrt(sin2_theta);
  const float phi = 2 * kPi * v;
  const Frame frame = frame_around(view / distance);
  const Vec3f on_sphere = frame.to_world({sin_alpha * std::cos(phi), sin_alpha * std::sin(phi), cos_alpha});
  const Vec3f direction = normalised(on_sphere - view);
  return EmitterPoint{sphere.centre + to_world(sphere, on_sphere), normalised(gradient_at(sphere, on_sphere)),
                      stretched_pdf(sphere, direction, 1 / (2 * kPi * height)), error};
}

float pdf_towards(const SphereEmitter& sphere, Vec3f from, Vec3f position) {
  const Vec3f view = to_local(sphere, from - sphere.centre);
  const float distance2 = dot(view, view);
  if (distance2 <= 1) return 0;
  return stretched_pdf(sphere, normalised(to_local(sphere, position - from)),
                       1 / (2 * kPi * cone_height(distance2)));
}

// Uniform on the unit sphere, then mapped to the ellipsoid. A linear map M takes a surface element dS with
// normal n to one of area |det M| |M^-T n| dS.
EmittingPoint point_on(const SphereEmitter& sphere, float u, float v) {
  const float z = 1 - 2 * u;
  const float r = std::sqrt(1 - z * z);  // z is exact and in [-1, 1], so this is not negative
  const float phi = 2 * kPi * v;
  const Vec3f p{r * std::cos(phi), r * std::sin(phi), z};
  const Vec3f normal = gradient_at(sphere, p);
  const float stretch = length(normal);
  return {sphere.centre + sphere.axes[0] * p.x + sphere.axes[1] * p.y + sphere.axes[2] * p.z,
          normal / stretch,
          1 / (4 * kPi * sphere.determinant * stretch),
          rounding_of(sphere),
          {}};
}

float pdf_area(const SphereEmitter& sphere, Vec3f position) {
  const Vec3f p = to_local(sphere, position - sphere.centre);
  return 1 / (4 * kPi * sphere.determinant * length(gradient_at(sphere, p)));
}

Vec3f normal_of(const SphereEmitter& sphere, Vec3f position) {
  return normalised(gradient_at(sphere, to_local(sphere, position - sphere.centre)));
}

// From outside, rays, samples and light paths meet the near side of a ball only, and that is bright. The
// point itself says nothing of its side where the ball is hardly larger than the rounding of its place.
bool shows_bright_side(const SphereEmitter& sphere, Vec3f position, Vec3f to_viewer) {
  const Vec3f viewer = to_local(sphere, (position - sphere.centre) + to_viewer);
  return dot(viewer, viewer) > 1;
}

float rounding_of(const SphereEmitter& sphere) {
  return rounding_of(sphere.centre, sphere.axes[0] + sphere.axes[1], sphere.axes[2]);
}

// A sphere shows a quarter of its area to each side.
LightBounds bounds_of(const SphereEmitter& sphere, float power) {
  const Vec3f half = root_of_squares(sphere.axes[0], sphere.axes[1], sphere.axes[2]);
  return {.low = sphere.centre - half,
          .high = sphere.centre + half,
          .radius = length(half),
          .axis = {0, 0, 1},
          .power = power / 4};
}

}  // namespace orbs::tracer
