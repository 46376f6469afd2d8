#include "tracer/irradiance_cache/hemisphere.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace orbs::tracer {

namespace {

// Sine and cosine of the polar angle at the edge between ring - 1 and ring.
struct RingEdge {
  double sine = 0;
  double cosine = 1;
};

RingEdge ring_edge(const HemisphereStrata& strata, int ring) {
  const double sine_squared = static_cast<double>(ring) / strata.rings;
  return {std::sqrt(sine_squared), std::sqrt(1 - sine_squared)};
}

// Indefinite integral of sin^2 over the polar angle.
double sine_squared_integral(const RingEdge& edge) {
  return (std::atan2(edge.sine, edge.cosine) - edge.sine * edge.cosine) / 2;
}

double sector_edge(const HemisphereStrata& strata, int sector) {
  return 2 * std::numbers::pi * sector / strata.sectors;
}

struct LightGrid {
  const HemisphereStrata& strata;
  std::span<const IncomingLight> light;

  const IncomingLight& at(int ring, int sector) const {
    const int wrapped = (sector + strata.sectors) % strata.sectors;
    return light[static_cast<std::size_t>(ring) * static_cast<std::size_t>(strata.sectors) +
                 static_cast<std::size_t>(wrapped)];
  }
};

// The nearer surface hides the other, so that the edge between both moves as it does.
Vec3d step_over_distance(const IncomingLight& here, const IncomingLight& before) {
  const double nearer = static_cast<double>(std::min(here.distance, before.distance));
  return cast<double>(here.radiance - before.radiance) / nearer;
}

void add(std::array<Vec3d, 3>& gradient, Vec3d channels, Vec3d direction) {
  gradient[0] += direction * channels.x;
  gradient[1] += direction * channels.y;
  gradient[2] += direction * channels.z;
}

// Ward and Heckbert 1992, section 3.2: the edges between strata belong to surfaces, and move as those do when
// the point moves. An edge at polar angle t and distance r moves by cos t / r, its length is sin t dphi, and
// its weight cos t; an edge between sectors moves by 1 / (r sin t) and weighs sin t cos t dt, whose integral
// over the ring without the sin t is the difference of the sines.
std::array<Vec3d, 3> translation_gradient(const LightGrid& grid) {
  const auto& strata = grid.strata;
  std::array<Vec3d, 3> gradient;
  for (int sector = 0; sector < strata.sectors; ++sector) {
    const double middle = (sector_edge(strata, sector) + sector_edge(strata, sector + 1)) / 2;
    const Vec3d outwards{std::cos(middle), std::sin(middle), 0};
    const double edge = sector_edge(strata, sector);
    const Vec3d sidewards{-std::sin(edge), std::cos(edge), 0};
    for (int ring = 0; ring < strata.rings; ++ring) {
      const RingEdge inner = ring_edge(strata, ring);
      const RingEdge outer = ring_edge(strata, ring + 1);
      const auto& here = grid.at(ring, sector);
      if (ring > 0)
        add(gradient, step_over_distance(here, grid.at(ring - 1, sector)),
            outwards * (2 * std::numbers::pi / strata.sectors * inner.sine * inner.cosine * inner.cosine));
      add(gradient, step_over_distance(here, grid.at(ring, sector - 1)),
          sidewards * (outer.sine - inner.sine));
    }
  }
  return gradient;
}

// The derivative of E = integral L (n . w) dw is the integral of L (n x w) dw. Over a stratum n x w = sin t
// (-sin phi, cos phi) is integrated exactly and not at the sample: constant radiance then has no
// gradient to the last digits, and no tangent of a grazing angle spoils it.
std::array<Vec3d, 3> rotation_gradient(const LightGrid& grid) {
  const auto& strata = grid.strata;
  std::array<Vec3d, 3> gradient;
  for (int ring = 0; ring < strata.rings; ++ring) {
    const double polar =
        sine_squared_integral(ring_edge(strata, ring + 1)) - sine_squared_integral(ring_edge(strata, ring));
    for (int sector = 0; sector < strata.sectors; ++sector) {
      const double from = sector_edge(strata, sector);
      const double to = sector_edge(strata, sector + 1);
      const Vec3d azimuthal{std::cos(to) - std::cos(from), std::sin(to) - std::sin(from), 0};
      add(gradient, cast<double>(grid.at(ring, sector).radiance), azimuthal * polar);
    }
  }
  return gradient;
}

std::array<Vec3f, 3> rounded(const std::array<Vec3d, 3>& gradient) {
  return {cast<float>(gradient[0]), cast<float>(gradient[1]), cast<float>(gradient[2])};
}

}  // namespace

HemisphereStrata hemisphere_strata(int rays) {
  assert(rays >= 8);
  const int rings = std::max(1, static_cast<int>(std::lround(std::sqrt(rays / std::numbers::pi))));
  return {rings, std::max(3, static_cast<int>(std::lround(static_cast<double>(rays) / rings)))};
}

Vec3f direction_in_stratum(const HemisphereStrata& strata, std::size_t index, Vec2f place) {
  const auto sectors = static_cast<std::size_t>(strata.sectors);
  const std::size_t ring = index / sectors;
  const std::size_t sector = index % sectors;
  const double sine_squared = (static_cast<double>(ring) + static_cast<double>(place.x)) / strata.rings;
  const double azimuth =
      2 * std::numbers::pi * (static_cast<double>(sector) + static_cast<double>(place.y)) / strata.sectors;
  const double sine = std::sqrt(sine_squared);
  return cast<float>(Vec3d{sine * std::cos(azimuth), sine * std::sin(azimuth), std::sqrt(1 - sine_squared)});
}

HemisphereEstimate estimate_irradiance(const HemisphereStrata& strata, std::span<const IncomingLight> light) {
  assert(light.size() == strata.count());
  Vec3d sum;
  double inverse_distances = 0;
  HemisphereEstimate out;
  out.least_distance = std::numeric_limits<float>::infinity();
  for (const IncomingLight& found : light) {
    sum += cast<double>(found.radiance);
    inverse_distances += 1 / static_cast<double>(found.distance);
    out.least_distance = std::min(out.least_distance, found.distance);
  }
  const auto count = static_cast<double>(light.size());
  out.irradiance = cast<float>(sum * (std::numbers::pi / count));
  out.harmonic_mean_distance = static_cast<float>(count / inverse_distances);
  const LightGrid grid{strata, light};
  out.translation_gradient = rounded(translation_gradient(grid));
  out.rotation_gradient = rounded(rotation_gradient(grid));
  return out;
}

}  // namespace orbs::tracer
