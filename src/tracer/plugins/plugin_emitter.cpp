#include "tracer/plugins/plugin_emitter.h"

#include "base/error.h"
#include "tracer/geometry/transforms.h"
#include "tracer/plugins/plugin_hit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace orbs::tracer {

namespace {

// A linear map M takes a surface element dA with unit normal n to one of area |det M| |M^-T n| dA, whose unit
// normal N is along M^-T n. So M^T N = n / |M^-T n|, and the area is |det M| / |M^T N| dA.
double stretch_of_area(const PluginShape& shape, Vec3d world_normal) {
  const Mat4& m = shape.to_world;
  const Vec3d turned = transform_normal(m, world_normal);  // by the transpose
  return std::abs(determinant3(m)) / length(turned);
}

// A point that the plug-in has given, checked.
std::optional<PluginPoint> placed(const PluginShape& shape, const orbs_shape_sample_point& point) {
  const Vec3d position{point.position[0], point.position[1], point.position[2]};
  const Vec3d normal{point.normal[0], point.normal[1], point.normal[2]};
  const Vec3d turned = has_direction(normal) ? transform_normal(shape.to_local, normalised(normal)) : Vec3d{};
  const bool is_density = std::isfinite(point.pdf) && point.pdf > 0;
  if (!has_direction(turned) || !is_density || !is_within_bounds(shape, position)) {
    ++shape.faults->sample;
    return std::nullopt;
  }
  const Vec3d world_normal = normalised(turned);
  return PluginPoint{transform_point(shape.to_world, position), world_normal,
                     point.pdf / stretch_of_area(shape, world_normal)};
}

// Per solid angle at `from`; not finite where the surface is seen edge-on.
double pdf_from(const PluginPoint& point, Vec3d from) {
  const Vec3d to = from - point.position;
  const double distance2 = dot(to, to);
  return point.pdf_area * distance2 * std::sqrt(distance2) / std::abs(dot(point.normal, to));
}

}  // namespace

bool can_be_sampled(const PluginShape& shape) {
  return shape.library->sample != nullptr && shape.library->pdf != nullptr;
}

std::optional<PluginPoint> sampled_point(const PluginShape& shape, double u, double v) {
  const std::array<double, 2> random{u, v};
  orbs_shape_sample_point point{};
  if (shape.library->sample(shape.shape.get(), random.data(), &point) == 0) return std::nullopt;
  return placed(shape, point);
}

std::optional<PluginPoint> point_at(const PluginShape& shape, Vec3d position) {
  const Vec3d p = transform_point(shape.to_local, position);
  const std::array<double, 3> local{p.x, p.y, p.z};
  orbs_shape_sample_point point{};
  shape.library->pdf(shape.shape.get(), local.data(), &point);
  return placed(shape, point);
}

float sampled_area(const PluginShape& shape) {
  constexpr int kSide = 16;
  // The two functions compute one density by two ways.
  constexpr double kAgreement = 1e-6;
  double sum = 0;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      const auto point = sampled_point(shape, (x + 0.5) / kSide, (y + 0.5) / kSide);
      if (!point) continue;
      const auto again = point_at(shape, point->position);
      const double ratio = again ? again->pdf_area / point->pdf_area : 0;
      if (!(std::abs(ratio - 1) <= kAgreement))
        throw InputError(fmt::format(
            "the plug-in '{}' gives a point of its shape two densities: that of orbs_shape_pdf is {} times "
            "that of orbs_shape_sample, so no image would be right; correct one, or leave out both",
            shape.library->name, ratio));
      sum += 1 / point->pdf_area;
    }
  return static_cast<float>(sum / (kSide * kSide));
}

// The point in double, and as a float.
float rounding_of(const PluginShape& shape) {
  const double size = std::max(largest_magnitude(shape.low), largest_magnitude(shape.high));
  return static_cast<float>((kDoubleRounding + 0x1p-24) * size);
}

std::optional<EmitterPoint> sample_towards(const PluginShape& shape, Vec3f from, float u, float v) {
  const auto point = sampled_point(shape, u, v);
  if (!point) return std::nullopt;
  const double pdf = pdf_from(*point, cast<double>(from));
  if (!std::isfinite(pdf)) return std::nullopt;
  const bool is_outside = dot(point->normal, cast<double>(from) - point->position) > 0;
  return EmitterPoint{cast<float>(point->position), cast<float>(is_outside ? point->normal : -point->normal),
                      static_cast<float>(pdf), rounding_of(shape)};
}

float pdf_towards(const PluginShape& shape, Vec3f from, Vec3f position) {
  const auto point = point_at(shape, cast<double>(position));
  const double pdf = point ? pdf_from(*point, cast<double>(from)) : 0;
  return std::isfinite(pdf) ? static_cast<float>(pdf) : 0;
}

EmittingPoint point_on(const PluginShape& shape, float u, float v, float side) {
  const auto point = sampled_point(shape, u, v);
  if (!point) return {{}, {0, 0, 1}, std::numeric_limits<float>::infinity(), 0, {}};
  return {cast<float>(point->position),
          cast<float>(side < 0.5F ? point->normal : -point->normal),
          static_cast<float>(0.5 * point->pdf_area),
          rounding_of(shape),
          {}};
}

float pdf_area(const PluginShape& shape, Vec3f position) {
  const auto point = point_at(shape, cast<double>(position));
  return point ? static_cast<float>(0.5 * point->pdf_area) : 0;
}

Vec3f normal_of(const PluginShape& shape, Vec3f position) {
  const auto point = point_at(shape, cast<double>(position));
  return point ? cast<float>(point->normal) : Vec3f{0, 0, 1};
}

// Its normals may have any direction.
LightBounds light_bounds_of(const PluginShape& shape, float power) {
  const Vec3f low = cast<float>(shape.low);
  const Vec3f high = cast<float>(shape.high);
  return {
      .low = low, .high = high, .radius = 0.5F * length(high - low), .axis = {0, 0, 1}, .power = power / 2};
}

}  // namespace orbs::tracer
