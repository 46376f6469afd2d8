#include "analytic/light_without_area.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace orbs::analytic {

namespace {

double cos_of_degrees(double degrees) { return std::cos(degrees * std::numbers::pi / 180); }

// Of a cone's intensity, at this cosine to its axis.
double share_in_cone(const std::array<double, 2>& cone_deg, double cosine) {
  const double inner = cos_of_degrees(cone_deg[0]);
  const double outer = cos_of_degrees(cone_deg[1]);
  if (cosine <= outer) return 0;
  if (cosine >= inner) return 1;
  const double t = (cosine - outer) / (inner - outer);
  return t * t * (3 - 2 * t);
}

// `direction` from the light, unit.
double intensity_towards(const registry::AnalyticLight& light, Vec3d direction) {
  double intensity = light.strength;
  if (light.cone_deg) intensity *= share_in_cone(*light.cone_deg, dot(light.direction, direction));
  if (!light.candela.empty()) intensity *= candela_towards(light.candela, direction);
  return intensity;
}

// A polygon in whose plane the point lies is its own surface, or beside it.
bool hides(const registry::FlatPolygon& polygon, Vec3d point, Vec3d to_light, double distance) {
  constexpr double kRounding = 1e-9;
  const auto& corners = polygon.corners;
  const Vec3d normal = normalised(cross(corners[1] - corners[0], corners[2] - corners[0]));
  const double height = dot(normal, corners.front() - point);
  const double along = dot(normal, to_light);
  if (std::fabs(height) <= kRounding * (1 + largest_magnitude(point)) || along == 0) return false;
  const double met = height / along;
  if (!(met > 0 && met < distance)) return false;
  const Vec3d at = point + to_light * met;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3d edge = corners[(i + 1) % corners.size()] - corners[i];
    if (dot(cross(edge, at - corners[i]), normal) < 0) return false;
  }
  return true;
}

// The share of the light that no surface on the way holds back.
double share_let_through(const registry::DirectLight& image, Vec3d point, Vec3d to_light, double distance) {
  double share = 1;
  if (!image.has_shadows) return share;
  for (const auto& surface : image.surfaces)
    if (hides(std::get<registry::FlatPolygon>(surface.shape), point, to_light, distance))
      share *= 1 - surface.opacity;
  return share;
}

}  // namespace

double candela_towards(const std::vector<std::pair<double, double>>& rows, Vec3d direction) {
  const double degrees = std::acos(std::clamp(-direction.y, -1.0, 1.0)) * 180 / std::numbers::pi;
  if (degrees < rows.front().first || degrees > rows.back().first) return 0;
  const auto next =
      std::find_if(rows.begin() + 1, rows.end() - 1, [&](const auto& row) { return degrees <= row.first; });
  const auto& [low, at_low] = *(next - 1);
  const auto& [high, at_high] = *next;
  return at_low + (at_high - at_low) * (degrees - low) / (high - low);
}

double irradiance_of_lights(const registry::DirectLight& image,
                            Vec3d point,
                            Vec3d normal,
                            Vec3d shading_normal) {
  double sum = 0;
  for (const auto& light : image.lights) {
    const Vec3d way = light.position ? *light.position - point : -light.direction;
    const double distance = light.position ? length(way) : std::numeric_limits<double>::infinity();
    const Vec3d to_light = light.position ? way / distance : way;
    const double cosine = dot(shading_normal, to_light);
    if (!(cosine > 0) || !(dot(normal, to_light) > 0)) continue;
    const double share = share_let_through(image, point, to_light, distance);
    if (share == 0) continue;
    sum += share * (light.position ? intensity_towards(light, -to_light) * cosine / (distance * distance)
                                   : light.strength * cosine);
  }
  return sum;
}

}  // namespace orbs::analytic
