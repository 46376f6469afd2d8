#include "tracer/plugins/plugin_hit.h"

#include <algorithm>
#include <cmath>

namespace orbs::tracer {

namespace {

Vec3d point_at(const orbs_shape_ray& ray, double t) {
  return {ray.origin[0] + t * ray.direction[0], ray.origin[1] + t * ray.direction[1],
          ray.origin[2] + t * ray.direction[2]};
}

orbs_shape_ray local_ray(const PluginShape& shape, const PluginRay& ray) {
  const Vec3d o = transform_point(shape.to_local, ray.origin);
  const Vec3d d = transform_direction(shape.to_local, ray.direction);
  return {{o.x, o.y, o.z}, {d.x, d.y, d.z}, ray.t_min, ray.t_max};
}

// The point of a ray is rounded by 2^-50 of its two terms.
bool is_within_bounds(const PluginShape& shape, const orbs_shape_ray& ray, double t) {
  const Vec3d o{ray.origin[0], ray.origin[1], ray.origin[2]};
  const Vec3d d{ray.direction[0], ray.direction[1], ray.direction[2]};
  return is_within_bounds(shape, point_at(ray, t),
                          0x1p-50 * (largest_magnitude(o) + t * largest_magnitude(d)));
}

UserRay user_ray(const Ray& ray) { return {ray.origin, ray.direction, ray.nearest, ray.reach}; }

PluginRay plugin_ray(const UserRay& ray) {
  return {cast<double>(ray.origin), cast<double>(ray.direction), ray.near, ray.far};
}

}  // namespace

bool has_direction(Vec3d v) {
  const double squared = dot(v, v);
  return std::isfinite(squared) && squared > 0;
}

bool is_within_bounds(const PluginShape& shape, Vec3d place, double rounding_m) {
  const double size = std::max(largest_magnitude(shape.local_low), largest_magnitude(shape.local_high));
  const double room = 1e-6 * size + rounding_m;
  const auto lies = [&](double x, double low, double high) { return x >= low - room && x <= high + room; };
  return lies(place.x, shape.local_low.x, shape.local_high.x) &&
         lies(place.y, shape.local_low.y, shape.local_high.y) &&
         lies(place.z, shape.local_low.z, shape.local_high.z);
}

std::optional<PluginHit> intersect(const PluginShape& shape, const PluginRay& ray) {
  const orbs_shape_ray local = local_ray(shape, ray);
  orbs_shape_hit hit{};
  if (shape.library->intersect(shape.shape.get(), &local, &hit) == 0) return std::nullopt;
  const auto faulty = [](std::atomic<std::uint64_t>& count) {
    ++count;
    return std::nullopt;
  };
  if (!(hit.t > ray.t_min && hit.t < ray.t_max) || !std::isfinite(hit.t))
    return faulty(shape.faults->distance);
  const Vec3d normal{hit.normal[0], hit.normal[1], hit.normal[2]};
  if (!has_direction(normal)) return faulty(shape.faults->normal);
  const Vec3d placed = transform_normal(shape.to_local, normalised(normal));
  if (!has_direction(placed)) return faulty(shape.faults->normal);
  if (!std::isfinite(hit.uv[0]) || !std::isfinite(hit.uv[1])) return faulty(shape.faults->uv);
  if (!is_within_bounds(shape, local, hit.t)) return faulty(shape.faults->place);
  return PluginHit{hit.t, normalised(placed), {hit.uv[0], hit.uv[1]}};
}

UserBounds bounds_of(const PluginShape& shape) { return {shape.low, shape.high}; }

std::optional<Hit> hit_of(const PluginShape& shape, unsigned int, const UserRay& ray) {
  const auto found = intersect(shape, plugin_ray(ray));
  if (!found) return std::nullopt;
  Hit hit;
  hit.distance = static_cast<float>(found->t);
  hit.barycentric = {static_cast<float>(found->uv.x), static_cast<float>(found->uv.y)};
  return hit;
}

bool is_blocked(const PluginShape& shape, unsigned int, const UserRay& ray) {
  if (shape.library->occluded == nullptr) return intersect(shape, plugin_ray(ray)).has_value();
  const orbs_shape_ray local = local_ray(shape, plugin_ray(ray));
  return shape.library->occluded(shape.shape.get(), &local) != 0;
}

SolidPoint point_on_plugin(const PluginShape& shape, const Ray& ray, const Hit& hit) {
  SolidPoint out;
  out.material = shape.material;
  // Up to the reach of the ray, which was the range of the first question or beyond it: nothing nearer was
  // found.
  const auto found = intersect(shape, plugin_ray(user_ray(ray)));
  const bool is_same = found && static_cast<float>(found->t) == hit.distance;
  if (!is_same) ++shape.faults->change;
  const double t = is_same ? found->t : hit.distance;
  out.position = cast<double>(ray.origin) + cast<double>(ray.direction) * t;
  out.normal = is_same ? found->normal : -normalised(cast<double>(ray.direction));
  out.error = kDoubleRounding * std::max(largest_magnitude(shape.low), largest_magnitude(shape.high));
  return out;
}

}  // namespace orbs::tracer
