#include "tracer/light/sphere_emitter.h"

#include "base/in_double.h"
#include "tracer/accel/curved_surface.h"
#include "tracer/geometry/transforms.h"
#include "tracer/numeric_fault.h"
#include "tracer/sampling/warps.h"

#include <algorithm>
#include <numbers>

namespace orbs::tracer {

namespace {

constexpr double kFullTurn = 2 * std::numbers::pi;

// From the centre, of a place in floats.
Vec3d from_centre(const SphereEmitter& sphere, Vec3f place) {
  if (has_fault(NumericFault::SphereCentreInSingle)) return cast<double>(place - cast<float>(sphere.centre));
  return cast<double>(place) - sphere.centre;
}

Vec3d to_local(const SphereEmitter& sphere, Vec3d v) {
  return {dot(sphere.inverse[0], v), dot(sphere.inverse[1], v), dot(sphere.inverse[2], v)};
}

Vec3d to_world(const SphereEmitter& sphere, Vec3d v) {
  return sphere.axes[0] * v.x + sphere.axes[1] * v.y + sphere.axes[2] * v.z;
}

// The gradient of |inverse (p - centre)|^2 where that is the local point, not normalised.
Vec3d gradient_at(const SphereEmitter& sphere, Vec3d local) {
  return sphere.inverse[0] * local.x + sphere.inverse[1] * local.y + sphere.inverse[2] * local.z;
}

// A linear map A takes a cone of directions w with solid angle dw to one with |det A| / |A w|^3 dw, by the
// volume and radius of the cone. `stretch`: |A w|.
float stretched_pdf(const SphereEmitter& sphere, double stretch, double local_pdf) {
  return static_cast<float>(local_pdf * stretch * stretch * stretch / sphere.determinant);
}

// A linear map M takes a surface element dS of the unit sphere with normal n to one of area |det M| |M^-T n|
// dS. `gradient`: M^-T n.
float pdf_by_stretch(const SphereEmitter& sphere, Vec3d gradient) {
  return static_cast<float>(1 / (2 * kFullTurn * sphere.determinant * length(gradient)));
}

// 1 - cos of the half angle that the unit sphere subtends at distance d > 1, without cancellation far away.
double cone_height(double distance2) {
  const double sin2 = 1 / distance2;
  if (has_fault(NumericFault::NaiveCone)) return 1 - std::sqrt(1 - static_cast<float>(sin2));
  return sin2 / (1 + std::sqrt(1 - sin2));
}

}  // namespace

SphereEmitter make_emitter(const scene::SphereShape& sphere, const Mat4& matrix, Vec3d) {
  const Mat4 map = matrix * scaling({sphere.radius_m, sphere.radius_m, sphere.radius_m});
  const Mat4 back = inverse(map).value();
  SphereEmitter out{.centre = transform_point(matrix, {})};
  for (std::size_t i = 0; i < 3; ++i) {
    out.axes[i] = {map(0, i), map(1, i), map(2, i)};
    out.inverse[i] = {back(i, 0), back(i, 1), back(i, 2)};
  }
  out.determinant = std::abs(determinant3(map));
  out.area = 4 * kPi * in_double::pow(static_cast<float>(out.determinant), 2.0F / 3.0F);
  return out;
}

CurvedSurface surface_of(const SphereEmitter& sphere) { return {sphere.centre, sphere.inverse, true}; }

std::optional<EmitterPoint> sample_towards(const SphereEmitter& sphere, Vec3f from, float u, float v) {
  const Vec3d view = to_local(sphere, from_centre(sphere, from));
  const double distance2 = dot(view, view);
  const float error = rounding_of(sphere);
  if (distance2 <= 1) return std::nullopt;  // from inside the light is dark
  // Uniform over the visible cone (Shirley et al. 1996). The cosine of the point's angle follows from the law
  // of sines, which is accurate for small spheres (Pharr, Jakob, Humphreys 2023, Physically Based Rendering,
  // 4th ed., 6.2.4), its sine from the distance along the ray, which is accurate close to the sphere.
  const double height = cone_height(distance2);
  const double one_minus_cos = static_cast<double>(u) * height;
  const double sin2_theta = one_minus_cos * (2 - one_minus_cos);
  const double cos_theta = 1 - one_minus_cos;
  const double distance = std::sqrt(distance2);
  // Rounding only: sin(theta) <= 1 / d inside the cone.
  const double root = std::sqrt(std::max(0.0, 1 - sin2_theta * distance2));
  const double cos_alpha = sin2_theta * distance + cos_theta * root;
  const double along_ray = (distance2 - 1) / (distance * cos_theta + root);
  const double sin_alpha = along_ray * std::sqrt(sin2_theta);
  const float phi = 2 * kPi * v;
  const double x = sin_alpha * static_cast<double>(in_double::cos(phi));
  const double y = sin_alpha * static_cast<double>(in_double::sin(phi));
  const Vec3d on_sphere = frame_around(view / distance).to_world({x, y, cos_alpha});
  const Vec3d position = sphere.centre + to_world(sphere, on_sphere);
  const double stretch = length(position - cast<double>(from)) / along_ray;
  return EmitterPoint{cast<float>(position), normalised(cast<float>(gradient_at(sphere, on_sphere))),
                      stretched_pdf(sphere, stretch, 1 / (kFullTurn * height)), error};
}

float pdf_towards(const SphereEmitter& sphere, Vec3f from, Vec3f position) {
  const Vec3d view = to_local(sphere, from_centre(sphere, from));
  const double distance2 = dot(view, view);
  if (distance2 <= 1) return 0;
  const Vec3d direction = cast<double>(position) - cast<double>(from);
  const double stretch = length(direction) / length(to_local(sphere, direction));
  return stretched_pdf(sphere, stretch, 1 / (kFullTurn * cone_height(distance2)));
}

// Uniform on the unit sphere, then mapped to the ellipsoid.
EmittingPoint point_on(const SphereEmitter& sphere, float u, float v) {
  const float z = 1 - 2 * u;
  const float r = std::sqrt(1 - z * z);  // z is exact and in [-1, 1], so this is not negative
  const float phi = 2 * kPi * v;
  const Vec3d p = cast<double>(Vec3f{r * in_double::cos(phi), r * in_double::sin(phi), z});
  const Vec3d normal = gradient_at(sphere, p);
  return {cast<float>(sphere.centre + to_world(sphere, p)),
          cast<float>(normalised(normal)),
          pdf_by_stretch(sphere, normal),
          rounding_of(sphere),
          {}};
}

float pdf_area(const SphereEmitter& sphere, Vec3f position) {
  const Vec3d local = to_local(sphere, from_centre(sphere, position));
  return pdf_by_stretch(sphere, gradient_at(sphere, local));
}

Vec3f normal_of(const SphereEmitter& sphere, Vec3f position) {
  const Vec3d local = to_local(sphere, from_centre(sphere, position));
  return cast<float>(normalised(gradient_at(sphere, local)));
}

// From outside, rays, samples and light paths meet the near side of a ball only, and that is bright. The
// point itself says nothing of its side where the ball is hardly larger than the rounding of its place.
bool shows_bright_side(const SphereEmitter& sphere, Vec3f position, Vec3f to_viewer) {
  if (has_fault(NumericFault::SphereCentreInSingle))
    return dot(from_centre(sphere, position), cast<double>(to_viewer)) > 0;
  const Vec3d viewer = to_local(sphere, from_centre(sphere, position) + cast<double>(to_viewer));
  return dot(viewer, viewer) > 1;
}

float rounding_of(const SphereEmitter& sphere) {
  return rounding_of(sphere.centre, sphere.axes[0] + sphere.axes[1], sphere.axes[2]);
}

// A sphere shows a quarter of its area to each side.
LightBounds bounds_of(const SphereEmitter& sphere, float power) {
  const Vec3f centre = cast<float>(sphere.centre);
  const Vec3f half =
      root_of_squares(cast<float>(sphere.axes[0]), cast<float>(sphere.axes[1]), cast<float>(sphere.axes[2]));
  return {.low = centre - half,
          .high = centre + half,
          .radius = length(half),
          .axis = {0, 0, 1},
          .power = power / 4};
}

}  // namespace orbs::tracer
