#pragma once

#include "tracer/accel/user_geometry.h"
#include "tracer/plugins/plugin_shape.h"
#include "tracer/shapes/solid_hit.h"

#include <optional>

/// Shapes of plug-ins as Embree hits them.
namespace orbs::tracer {

/// What the plug-in answers, checked, in double.
struct PluginHit {
  double t = 0;  // of the ray in world space
  Vec3d normal;  // unit, in world space
  Vec2d uv;
};

struct PluginRay {
  Vec3d origin;  // in world space
  Vec3d direction;
  double t_min = 0;
  double t_max = 0;
};

/// Whether a vector has a direction: it is finite and not zero.
bool has_direction(Vec3d v);

/// Whether a place in the shape's own space lies within its bounds, up to a millionth of their size and
/// `rounding_m`.
bool is_within_bounds(const PluginShape& shape, Vec3d place, double rounding_m = 0);

/// The nearest point with t_min < t < t_max. Nothing where the plug-in has none, or breaks its rules, which
/// is counted.
std::optional<PluginHit> intersect(const PluginShape& shape, const PluginRay& ray);

/// For make_user_geometry. Hits hold the texture coordinates in their barycentric ones.
UserBounds bounds_of(const PluginShape& shape);
std::optional<Hit> hit_of(const PluginShape& shape, unsigned int index, const UserRay& ray);
bool is_blocked(const PluginShape& shape, unsigned int index, const UserRay& ray);

/// The point of a hit, which the ray found. The plug-in is asked once more with the same ray, as a hit has no
/// room for a normal in double; where the answer is another one by then, that is counted, and the normal
/// faces the ray.
SolidPoint point_on_plugin(const PluginShape& shape, const Ray& ray, const Hit& hit);

}  // namespace orbs::tracer
