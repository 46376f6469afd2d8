#include "adapters/pbrt/profile_image.h"

#include <cmath>
#include <numbers>

namespace orbs::adapters::pbrt {

namespace {

// The direction at a place of the unit square (Clarberg 2008, "Fast Equal-Area Mapping of the (Hemi)Sphere
// using SIMD"): the middle of the square is +Z, its corners are -Z, and each of the two diamonds' rings of
// equal distance r from the middle or the corners is a circle at height 1 - r^2.
Vec3d equal_area_direction(double u, double v) {
  const double x = 2 * u - 1;
  const double y = 2 * v - 1;
  const double inside = 1 - (std::abs(x) + std::abs(y));  // below 0 in the lower half
  const double r = 1 - std::abs(inside);
  const double phi = (r == 0 ? 1 : (std::abs(y) - std::abs(x)) / r + 1) * std::numbers::pi / 4;
  const double z = std::copysign(1 - r * r, inside);
  const double across = r * std::sqrt(2 - r * r);
  return {std::copysign(across * std::cos(phi), x), std::copysign(across * std::sin(phi), y), z};
}

}  // namespace

image::Image profile_image(const scene::IesProfile& profile) {
  constexpr int kSide = 1024;
  auto image = image::make_image(kSide, kSide, {"Y"});
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      const Vec3d d = equal_area_direction((x + 0.5) / kSide, (y + 0.5) / kSide);
      // pbrt's Z is the Y of the light's frame.
      image.at(x, y, 0) =
          static_cast<float>(scene::candela_towards(profile, {d.x, d.z, d.y}) / profile.max_candela);
    }
  return image;
}

Mat4 profile_frame(const scene::Light& light) {
  const Mat4 to_world = light.matrix * light.ies->matrix;
  const auto axis = [&](Vec3d local) { return normalised(transform_direction(to_world, local)); };
  const Vec3d x = axis({1, 0, 0});
  const Vec3d y = axis({0, 1, 0});
  const Vec3d z = axis({0, 0, 1});
  const Vec3d o = transform_point(light.matrix, {});
  return {{x.x, y.x, z.x, o.x, x.y, y.y, z.y, o.y, x.z, y.z, z.z, o.z, 0, 0, 0, 1}};
}

}  // namespace orbs::adapters::pbrt
