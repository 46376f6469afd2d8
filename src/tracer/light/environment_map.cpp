#include "tracer/light/environment_map.h"

#include "image/colour.h"
#include "scene/environment.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace orbs::tracer {

namespace {

// Nearer to a pole no direction of floats comes, but for the pole itself, where a density in u and v has no
// limit and one per solid angle has.
constexpr double kAtPole = 1e-12;

// Where a direction lies in the grid of cells.
struct Place {
  std::size_t row = 0;     // of cells, from the bottom; it lies between the edges `row` and `row + 1`
  std::size_t column = 0;  // between the centres of the texels `column` and `column + 1`
  double x = 0;            // shares of the cell
  double y = 0;
  double cosine = 1;  // of the latitude
};

std::size_t columns(const EnvironmentMap& map) { return static_cast<std::size_t>(map.width); }
std::size_t cell_rows(const EnvironmentMap& map) { return static_cast<std::size_t>(map.height) + 1; }

// v of an edge between rows of cells: the poles, and the centres of the rows of texels.
double edge(const EnvironmentMap& map, std::size_t index) {
  if (index == 0) return 0;
  if (index == cell_rows(map)) return 1;
  return (static_cast<double>(index) - 0.5) / map.height;
}

// The texel on an edge: at a pole that of the outermost row.
const Vec3f& texel(const EnvironmentMap& map, std::size_t column, std::size_t edge) {
  const std::size_t row = std::clamp<std::size_t>(edge, 1, static_cast<std::size_t>(map.height)) - 1;
  return map.texels[row * columns(map) + column % columns(map)];
}

double luminance(const Vec3f& rgb) {
  return image::luminance(static_cast<double>(rgb.x), static_cast<double>(rgb.y), static_cast<double>(rgb.z));
}

double density_at_corner(const EnvironmentMap& map, std::size_t column, std::size_t edge) {
  return luminance(texel(map, column, edge)) * map.cosines[edge];
}

// Bottom left, bottom right, top left, top right.
std::array<double, 4> corners(const EnvironmentMap& map, std::size_t row, std::size_t column) {
  return {density_at_corner(map, column, row), density_at_corner(map, column + 1, row),
          density_at_corner(map, column, row + 1), density_at_corner(map, column + 1, row + 1)};
}

double between(double a, double b, double t) { return a * (1 - t) + b * t; }

// Floats lose the digits of the latitude near the poles that its cosine has.
Place place_of(const EnvironmentMap& map, Vec3f direction) {
  const Vec3d d{static_cast<double>(dot(direction, map.axes[0])),
                static_cast<double>(dot(direction, map.axes[1])),
                static_cast<double>(dot(direction, map.axes[2]))};
  const double all = length(d);
  const double from_axis = std::max(std::hypot(d.x, d.z), kAtPole * all);
  const double at_u = (0.5 + std::atan2(d.x, -d.z) / (2 * std::numbers::pi)) * map.width - 0.5;
  const double v = 0.5 + std::atan2(d.y, from_axis) / std::numbers::pi;
  Place place{.cosine = from_axis / all};
  const double column = std::floor(at_u);
  place.x = at_u - column;
  place.column = column < 0 ? columns(map) - 1 : std::min(static_cast<std::size_t>(column), columns(map) - 1);
  const double row = std::clamp(std::floor(v * map.height + 0.5), 0.0, static_cast<double>(map.height));
  place.row = static_cast<std::size_t>(row);
  const double low = edge(map, place.row);
  place.y = std::clamp((v - low) / (edge(map, place.row + 1) - low), 0.0, 1.0);  // rounding alone leaves it
  return place;
}

// t in [0, 1] with a density in proportion to a (1 - t) + b t: the root of its integral.
double sample_linear(double a, double b, double u) {
  const double root = std::sqrt(between(a * a, b * b, u));
  return a + root > 0 ? u * (a + b) / (a + root) : u;
}

// The interval of running sums that holds the share u of their total; u becomes its share of that interval.
std::size_t pick(const double* sums, std::size_t count, double& u) {
  const double wanted = u * sums[count - 1];
  auto found = static_cast<std::size_t>(std::upper_bound(sums, sums + count, wanted) - sums);
  found = std::min(found, count - 1);
  const double before = found == 0 ? 0 : sums[found - 1];
  u = std::clamp((wanted - before) / (sums[found] - before), 0.0, 1.0);
  return found;
}

void fill_sums(EnvironmentMap& map) {
  double below = 0;
  for (std::size_t row = 0; row < cell_rows(map); ++row) {
    const double height = edge(map, row + 1) - edge(map, row);
    double before = 0;
    for (std::size_t column = 0; column < columns(map); ++column) {
      const auto corner = corners(map, row, column);
      before += (corner[0] + corner[1] + corner[2] + corner[3]) / 4 * height / map.width;
      map.cells_up_to.push_back(before);
    }
    below += before;
    map.rows_up_to.push_back(below);
  }
  // The mean of f cos(latitude) over u and v is 2 / pi of the mean of f over the sphere.
  map.mean_luminance = below * std::numbers::pi / 2;
}

}  // namespace

std::unique_ptr<const EnvironmentMap> make_environment_map(const TexelGrid& image, const Mat4& matrix) {
  auto map = std::make_unique<EnvironmentMap>();
  for (std::size_t i = 0; i < 3; ++i)
    map->axes[i] = cast<float>(Vec3d{matrix(0, i), matrix(1, i), matrix(2, i)});
  map->width = image.width;
  map->height = image.height;
  map->texels = image.texels;
  for (std::size_t i = 0; i <= cell_rows(*map); ++i)
    map->cosines.push_back(std::sin(edge(*map, i) * std::numbers::pi));
  map->cosines.back() = 0;  // sin(pi) is not zero in floats
  fill_sums(*map);
  return map;
}

Vec3f radiance_from(const EnvironmentMap& map, Vec3f direction) {
  const Place place = place_of(map, direction);
  const auto x = static_cast<float>(place.x);
  const auto y = static_cast<float>(place.y);
  const auto along = [&](std::size_t edge) {
    return texel(map, place.column, edge) * (1 - x) + texel(map, place.column + 1, edge) * x;
  };
  return along(place.row) * (1 - y) + along(place.row + 1) * y;
}

Vec3f sample_direction(const EnvironmentMap& map, float u, float v) {
  double across = static_cast<double>(u);
  double up = static_cast<double>(v);
  const std::size_t row = pick(map.rows_up_to.data(), cell_rows(map), up);
  const std::size_t column = pick(map.cells_up_to.data() + row * columns(map), columns(map), across);
  const auto corner = corners(map, row, column);
  const double y = sample_linear(corner[0] + corner[1], corner[2] + corner[3], up);
  const double x = sample_linear(between(corner[0], corner[2], y), between(corner[1], corner[3], y), across);
  const Vec3d local = scene::map_direction(
      {(static_cast<double>(column) + 0.5 + x) / map.width, between(edge(map, row), edge(map, row + 1), y)});
  const Vec3f d = cast<float>(local);
  return normalised(map.axes[0] * d.x + map.axes[1] * d.y + map.axes[2] * d.z);
}

// One unit of u is two pi of longitude, one of v is pi of latitude.
float pdf_of(const EnvironmentMap& map, Vec3f direction) {
  const Place place = place_of(map, direction);
  const auto corner = corners(map, place.row, place.column);
  const double density =
      between(between(corner[0], corner[1], place.x), between(corner[2], corner[3], place.x), place.y) /
      map.rows_up_to.back();
  return static_cast<float>(density / (2 * std::numbers::pi * std::numbers::pi * place.cosine));
}

}  // namespace orbs::tracer
