#include "scene/shapes/superellipsoid.h"

#include "json/writer.h"
#include "scene/load/entry.h"
#include "scene/shapes/expression.h"
#include "scene/shapes/revolved.h"

#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace orbs::scene {

namespace {

// Sines of multiples of pi are some 1e-16 and not 0, of which small powers are far from 0.
double signed_power(double x, double exponent) {
  const double magnitude = std::abs(x) < 1e-12 ? 0 : std::abs(x);
  return std::copysign(std::pow(magnitude, exponent), x);
}

}  // namespace

void load(ShapeEntry& entry, SuperellipsoidForm& loaded) {
  // Powers 2 / e below 1 have cusps on which no normal is defined; above 40 all of the shape is its edges.
  constexpr json::Range kExponent{0.05, 2};
  loaded.east_west = entry.in.number("east_west", kExponent);
  loaded.north_south = entry.in.number("north_south", kExponent);
}

void write(json::Writer& out, const MaterialList&, const SuperellipsoidForm& form) {
  out.member("east_west", form.east_west).member("north_south", form.north_south);
}

std::optional<LocalBox> bounds(const SuperellipsoidForm&) { return LocalBox{{-1, -1, -1}, {1, 1, 1}}; }

ImplicitForm implicit(const SuperellipsoidForm& form) {
  constexpr double kReach = 1 + 1e-6;
  const double e = form.east_west;
  const double n = form.north_south;
  return {
      parse_expression(fmt::format("(abs(x)^{} + abs(z)^{})^{} + abs(y)^{} - 1", 2 / e, 2 / e, e / n, 2 / n)),
      {-kReach, -kReach, -kReach},
      {kReach, kReach, kReach},
      true};
}

std::optional<Mesh> tessellated(const SuperellipsoidForm& form) {
  Mesh mesh;
  for (int i = 0; i <= kShapeBands; ++i)
    for (int j = 0; j <= kShapeSegments; ++j) {
      const double polar = turn_rad(i);
      const double phi = turn_rad(j % kShapeSegments);
      const double out = std::sin(polar);
      const auto place = [&](double e, double n) {
        return Vec3d{signed_power(out, n) * signed_power(std::sin(phi), e), signed_power(std::cos(polar), n),
                     signed_power(out, n) * signed_power(std::cos(phi), e)};
      };
      const Vec3d p = place(form.east_west, form.north_south);
      const Vec3d normal = normalised(place(2 - form.east_west, 2 - form.north_south));
      const double around = std::atan2(p.x, p.z) / (2 * std::numbers::pi);
      const double u = j == kShapeSegments ? 1 : around - std::floor(around);
      add_vertex(mesh, p, normal, {u, 0.5 + std::asin(p.y / length(p)) / std::numbers::pi});
    }
  add_grid_triangles(mesh, 0, kShapeBands, kShapeSegments);
  return mesh;
}

}  // namespace orbs::scene
