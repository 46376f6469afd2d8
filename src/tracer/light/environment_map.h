#pragma once

#include "base/matrix.h"
#include "base/vec.h"
#include "tracer/colour/texture.h"

#include <array>
#include <memory>
#include <vector>

namespace orbs::tracer {

/// A latitude-longitude image in the directions around the scene, see scene::EnvironmentMap, and a density by
/// which light sampling finds its bright parts. The sphere is divided into cells between the centres of four
/// neighbouring texels; those of the poles reach from the outermost row to the pole. In each the density in u
/// and v is bilinear between its corners, where it is the luminance of the texel times the cosine of the
/// latitude, so that it follows radiance times solid angle and is zero only where the image is black.
struct EnvironmentMap {
  std::array<Vec3f, 3> axes;  // unit, of the image's own frame in the world
  int width = 0;
  int height = 0;
  std::vector<Vec3f> texels;        // from the bottom row up
  std::vector<double> cosines;      // of the latitude at the lower edge of each row of cells, and of the pole
  std::vector<double> rows_up_to;   // of the mass of each row of cells and all below it
  std::vector<double> cells_up_to;  // of each cell and those before it in its row
  double mean_luminance = 0;        // over the sphere
};

/// `matrix` turns or mirrors the image.
std::unique_ptr<const EnvironmentMap> make_environment_map(const TexelGrid& image, const Mat4& matrix);

/// Radiance that arrives from where this direction leads to; it need not be unit, but not zero.
Vec3f radiance_from(const EnvironmentMap& map, Vec3f direction);

/// A unit direction, by u and v in [0, 1). The map must not be black.
Vec3f sample_direction(const EnvironmentMap& map, float u, float v);

/// Per solid angle, with which sample_direction finds this direction.
float pdf_of(const EnvironmentMap& map, Vec3f direction);

}  // namespace orbs::tracer
