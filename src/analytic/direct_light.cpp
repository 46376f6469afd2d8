#include "analytic/direct_light.h"

#include "analytic/form_factor.h"
#include "analytic/light_without_area.h"
#include "analytic/motion.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace orbs::analytic {

namespace {

struct Hit {
  double distance = std::numeric_limits<double>::infinity();
  Vec3d normal;  // unit, of the front
};

struct Intersect {
  const Ray& ray;

  std::optional<Hit> plane(Vec3d point, Vec3d normal) const {
    const double along = dot(normal, ray.direction);
    const double distance = dot(normal, point - ray.origin) / along;
    if (along == 0 || !(distance > 0)) return std::nullopt;
    return Hit{distance, normal};
  }
  std::optional<Hit> operator()(const registry::FlatPolygon& polygon) const {
    const auto& corners = polygon.corners;
    const auto normal = normalised(cross(corners[1] - corners[0], corners[2] - corners[0]));
    const auto hit = plane(corners.front(), normal);
    if (!hit) return std::nullopt;
    const auto point = ray.origin + ray.direction * hit->distance;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const auto edge = corners[(i + 1) % corners.size()] - corners[i];
      if (dot(cross(edge, point - corners[i]), normal) < 0) return std::nullopt;
    }
    return hit;
  }
  std::optional<Hit> operator()(const registry::RoundDisk& disk) const {
    const auto hit = plane(disk.centre, disk.normal);
    if (!hit || length(ray.origin + ray.direction * hit->distance - disk.centre) > disk.radius_m)
      return std::nullopt;
    return hit;
  }
  // The nearer hit, or that of a ray from within.
  std::optional<Hit> operator()(const registry::FormulaSphere& sphere) const {
    const auto to_centre = sphere.centre - ray.origin;
    const double middle = dot(to_centre, ray.direction);
    const double aside = length(to_centre - ray.direction * middle);
    if (aside > sphere.radius_m) return std::nullopt;
    const double half = std::sqrt((sphere.radius_m - aside) * (sphere.radius_m + aside));
    const double distance = middle - half > 0 ? middle - half : middle + half;
    if (!(distance > 0)) return std::nullopt;
    return Hit{distance, normalised(ray.direction * distance - to_centre)};
  }
};

double candela_factor(const registry::AnalyticSource& source, Vec3d point) {
  if (!source.candela_centre) return 1;
  return candela_towards(source.candela, normalised(point - *source.candela_centre));
}

// All surfaces in whose plane the point does not lie, relative to it: that leaves out its own.
std::vector<Corners> blockers_at(const registry::DirectLight& image, Vec3d point, double time) {
  std::vector<Corners> blockers;
  if (!image.has_shadows) return blockers;
  for (const auto& surface : image.surfaces) {
    auto corners = seen_from(point, corners_at(std::get<registry::FlatPolygon>(surface.shape), time));
    if (!lies_in_plane(corners)) blockers.push_back(std::move(corners));
  }
  return blockers;
}

registry::AnalyticShape shape_at(const registry::AnalyticShape& shape, double time) {
  const auto* polygon = std::get_if<registry::FlatPolygon>(&shape);
  return polygon == nullptr ? shape : registry::FlatPolygon{corners_at(*polygon, time)};
}

double lit(
    const registry::DirectLight& image, double reflectance, Vec3d point, Vec3d normal, double time = 0) {
  double sum = image.environment + irradiance_of_lights(image, point, normal, normal) / std::numbers::pi;
  const auto blockers = blockers_at(image, point, time);
  for (const auto& source : image.sources) {
    const auto seen = coverage(shape_at(source.shape, time), source.window, blockers, point, normal);
    const double radiance = seen.shows_front ? source.radiance * candela_factor(source, point) : 0;
    // What is seen through a window, a mirror's say, hides nothing.
    sum += seen.form_factor * (radiance - (source.window.empty() ? image.environment : 0));
  }
  return reflectance * sum;
}

// Where the ray meets a surface, and when, while the shutter is open.
struct TimedHit {
  Hit hit;
  TimeIntervals times;
  const registry::AnalyticSurface* met = nullptr;
};

std::vector<TimedHit> timed_hits(const registry::DirectLight& image, const Ray& ray, TimeInterval open) {
  std::vector<TimedHit> hits;
  for (const auto& surface : image.surfaces) {
    const auto* polygon = std::get_if<registry::FlatPolygon>(&surface.shape);
    if (polygon == nullptr || polygon->end_corners.empty()) {
      if (const auto hit = std::visit(Intersect{ray}, surface.shape))
        hits.push_back({*hit, {open}, &surface});
      continue;
    }
    const auto& corners = polygon->corners;
    const auto normal = normalised(cross(corners[1] - corners[0], corners[2] - corners[0]));
    const auto hit = Intersect{ray}.plane(corners.front(), normal);
    if (!hit) continue;
    auto times = times_inside(*polygon, ray.origin + ray.direction * hit->distance, open);
    if (!times.empty()) hits.push_back({*hit, std::move(times), &surface});
  }
  std::stable_sort(hits.begin(), hits.end(),
                   [](const auto& a, const auto& b) { return a.hit.distance < b.hit.distance; });
  return hits;
}

// The radiance that the surface shows, over these times.
double integral_over(const registry::DirectLight& image,
                     const TimedHit& seen,
                     const Ray& ray,
                     const TimeIntervals& times) {
  const bool is_front = dot(seen.hit.normal, ray.direction) < 0;
  const bool shines = is_front || std::holds_alternative<registry::FormulaSphere>(seen.met->shape);
  const auto point = ray.origin + ray.direction * seen.hit.distance;
  double sum = 0;
  for (const auto& interval : times)
    sum += seen.met->reflectance ? integral(
                                       [&](double time) {
                                         return lit(image, *seen.met->reflectance, point,
                                                    is_front ? seen.hit.normal : -seen.hit.normal, time);
                                       },
                                       interval)
                                 : (shines ? seen.met->radiance : 0) * (interval.to - interval.from);
  return sum;
}

double mean_over_shutter(const registry::DirectLight& image, const Ray& ray) {
  const TimeInterval open{image.shutter->front(), image.shutter->back()};
  TimeIntervals left{open};
  double sum = 0;
  for (const auto& seen : timed_hits(image, ray, open)) {
    sum += integral_over(image, seen, ray, common(left, seen.times));
    left = without(left, seen.times);
  }
  for (const auto& interval : left) sum += image.environment * (interval.to - interval.from);
  return sum / (open.to - open.from);
}

}  // namespace

namespace {

double shown(const registry::DirectLight& image,
             const registry::AnalyticSurface& met,
             const Hit& hit,
             const Ray& ray) {
  const bool is_front = dot(hit.normal, ray.direction) < 0;
  // The inside of a sphere shines, as that of a room does.
  const bool shines = is_front || std::holds_alternative<registry::FormulaSphere>(met.shape);
  if (!met.reflectance) return shines ? met.radiance : 0;
  const Vec3d point = ray.origin + ray.direction * hit.distance;
  const Vec3d normal = is_front ? hit.normal : -hit.normal;
  if (!met.shading_normal) return lit(image, *met.reflectance, point, normal);
  const Vec3d turned = is_front ? *met.shading_normal : -*met.shading_normal;
  // What faces away from the viewer by its shading normal is black.
  if (!(dot(turned, ray.direction) < 0)) return 0;
  return *met.reflectance * irradiance_of_lights(image, point, normal, turned) / std::numbers::pi;
}

}  // namespace

double direct_light(const registry::DirectLight& image, const Ray& ray) {
  if (image.shutter) return mean_over_shutter(image, ray);
  std::vector<std::pair<Hit, const registry::AnalyticSurface*>> hits;
  for (const auto& surface : image.surfaces)
    if (const auto hit = std::visit(Intersect{ray}, surface.shape)) hits.emplace_back(*hit, &surface);
  // Of two at one distance the first one counts, as it stands in the case.
  std::stable_sort(hits.begin(), hits.end(),
                   [](const auto& a, const auto& b) { return a.first.distance < b.first.distance; });
  double sum = 0;
  double left = 1;
  for (const auto& [hit, met] : hits) {
    sum += left * met->opacity * shown(image, *met, hit, ray);
    left *= 1 - met->opacity;
    if (left == 0) return sum;
  }
  return sum + left * image.environment;
}

}  // namespace orbs::analytic
