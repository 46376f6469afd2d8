#include "tracer/light/emitter_sampling.h"

#include "scene/lights/ies.h"
#include "tracer/geometry/frame.h"
#include "tracer/light/spherical_rectangle.h"
#include "tracer/sampling/warps.h"

#include <algorithm>
#include <cmath>

namespace orbs::tracer {

namespace {

// Pdf per solid angle of a point sampled uniformly by area.
float area_to_solid_angle(Vec3f from, Vec3f position, Vec3f normal, float area) {
  const Vec3f d = position - from;
  const float distance2 = dot(d, d);
  const float cos_times_distance = std::abs(dot(normal, d));
  return distance2 * std::sqrt(distance2) / (cos_times_distance * area);
}

std::optional<EmitterPoint> point_by_area(Vec3f from, Vec3f position, Vec3f normal, float area, float error) {
  if (dot(normal, from - position) <= 0) return std::nullopt;
  return EmitterPoint{position, normal, area_to_solid_angle(from, position, normal, area), error};
}

// Closer than two side lengths 1/d^2 varies by more than a factor of 4 over the rectangle, and area sampling
// spends most samples on its far end.
std::optional<SphericalRectangle> near_rectangle(const RectEmitter& rect, Vec3f from) {
  const Vec3f d = rect.centre - from;
  if (!rect.is_orthogonal || dot(d, d) > 4 * rect.area) return std::nullopt;
  return make_spherical_rectangle(rect, from);
}

std::optional<EmitterPoint> sample_shape(const RectEmitter& rect, Vec3f from, float u, float v) {
  const float error = rounding_of(rect);
  if (dot(rect.normal, from - rect.centre) <= 0) return std::nullopt;
  if (const auto spherical = near_rectangle(rect, from))
    return EmitterPoint{sample_point(*spherical, u, v), rect.normal, 1 / spherical->solid_angle, error};
  return point_by_area(from, rect.centre + rect.a * (2 * u - 1) + rect.b * (2 * v - 1), rect.normal,
                       rect.area, error);
}

float pdf_shape(const RectEmitter& rect, Vec3f from, Vec3f position) {
  if (const auto spherical = near_rectangle(rect, from)) return 1 / spherical->solid_angle;
  return area_to_solid_angle(from, position, rect.normal, rect.area);
}

std::optional<EmitterPoint> sample_shape(const DiskEmitter& disk, Vec3f from, float u, float v) {
  const Vec2f at = sample_disk(u, v);
  return point_by_area(from, disk.centre + disk.a * at.x + disk.b * at.y, disk.normal, disk.area,
                       rounding_of(disk));
}

float pdf_shape(const DiskEmitter& disk, Vec3f from, Vec3f position) {
  return area_to_solid_angle(from, position, disk.normal, disk.area);
}

Vec3f to_local(const SphereEmitter& sphere, Vec3f v) {
  return {dot(sphere.inverse[0], v), dot(sphere.inverse[1], v), dot(sphere.inverse[2], v)};
}

Vec3f to_world(const SphereEmitter& sphere, Vec3f v) {
  return sphere.axes[0] * v.x + sphere.axes[1] * v.y + sphere.axes[2] * v.z;
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

std::optional<EmitterPoint> sample_shape(const SphereEmitter& sphere, Vec3f from, float u, float v) {
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
  const Vec3f normal = normalised(sphere.inverse[0] * on_sphere.x + sphere.inverse[1] * on_sphere.y +
                                  sphere.inverse[2] * on_sphere.z);
  return EmitterPoint{sphere.centre + to_world(sphere, on_sphere), normal,
                      stretched_pdf(sphere, direction, 1 / (2 * kPi * height)), error};
}

float pdf_shape(const SphereEmitter& sphere, Vec3f from, Vec3f position) {
  const Vec3f view = to_local(sphere, from - sphere.centre);
  const float distance2 = dot(view, view);
  if (distance2 <= 1) return 0;
  return stretched_pdf(sphere, normalised(to_local(sphere, position - from)),
                       1 / (2 * kPi * cone_height(distance2)));
}

bool shows_bright_side(const RectEmitter& rect, Vec3f, Vec3f to_viewer) {
  return dot(rect.normal, to_viewer) > 0;
}
bool shows_bright_side(const DiskEmitter& disk, Vec3f, Vec3f to_viewer) {
  return dot(disk.normal, to_viewer) > 0;
}
bool shows_bright_side(const SphereEmitter& sphere, Vec3f position, Vec3f to_viewer) {
  // From outside, rays, samples and light paths meet the near side of a ball only, and that is bright. The
  // point itself says nothing of its side where the ball is hardly larger than the rounding of its place.
  const Vec3f viewer = to_local(sphere, (position - sphere.centre) + to_viewer);
  return dot(viewer, viewer) > 1;
}

}  // namespace

std::optional<EmitterPoint> sample_towards(const EmitterShape& shape, Vec3f from, float u, float v) {
  return std::visit([&](const auto& s) { return sample_shape(s, from, u, v); }, shape);
}

std::optional<EmitterPoint> sample_towards(const TriangleEmitter& t,
                                           Vec3f from,
                                           Vec2f uv,
                                           Vec2f& texture_uv) {
  const Vec2f b = triangle_point(uv);
  const Vec3f position = t.corner + t.edge1 * b.x + t.edge2 * b.y;
  texture_uv = interpolated_uv(t, b);
  const Vec3f normal = dot(t.normal, from - position) < 0 ? -t.normal : t.normal;
  return point_by_area(from, position, normal, t.area, rounding_of(t));
}

float pdf_towards(const EmitterShape& shape, Vec3f from, Vec3f position) {
  return std::visit([&](const auto& s) { return pdf_shape(s, from, position); }, shape);
}

Radiance radiance_towards(const AreaLight& light, Vec3f position, Vec3f to) {
  const Vec3f to_viewer = to - position;
  if (!std::visit([&](const auto& s) { return shows_bright_side(s, position, to_viewer); }, light.shape))
    return {};
  if (!light.ies) return light.radiance;
  const Vec3f d = light.ies->point_area ? to - light.centre : to_viewer;
  const Vec3f local{dot(d, light.ies_axes[0]), dot(d, light.ies_axes[1]), dot(d, light.ies_axes[2])};
  const auto& profile = *light.ies->profile;
  const auto share =
      static_cast<float>(scene::candela_towards(profile, cast<double>(local)) / profile.max_candela);
  if (share == 0) return {};
  return {light.radiance.rgb * share, light.radiance.spectrum, share};
}

}  // namespace orbs::tracer
