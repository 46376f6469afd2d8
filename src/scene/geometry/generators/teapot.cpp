#include "scene/geometry/generators/teapot.h"

#include "scene/geometry/mesh.h"

namespace orbs::scene {

namespace {

// The data are Martin Newell's control points ("The Utilization of Procedure Models in Digital Image
// Synthesis", PhD thesis, University of Utah, 1975) in the published form with Blinn's squashed height and
// the bottom that was added later. Heights here are along y. Written by symmetry: rows of control points
// follow the profile, columns go around it.

/// Four control points of a quarter turn: (radius, 0), (radius, offset), (offset, radius), (0, radius).
struct TurnedRow {
  double radius;
  double offset;
  double height;
};
/// Four control points of half a tube, which is symmetric to z = 0: `inner` and `outer` lie at z = 0 and at
/// +-half_width.
struct TubeRow {
  Vec2d inner;
  Vec2d outer;
  double half_width;
};

using TurnedPatch = std::array<TurnedRow, 4>;
using TubePatch = std::array<TubeRow, 4>;

constexpr std::array<TurnedPatch, 5> kTurned{
    TurnedPatch{
        {{1.4, 0.784, 2.4}, {1.3375, 0.749, 2.53125}, {1.4375, 0.805, 2.53125}, {1.5, 0.84, 2.4}}},  // rim
    TurnedPatch{{{1.5, 0.84, 2.4}, {1.75, 0.98, 1.875}, {2, 1.12, 1.35}, {2, 1.12, 0.9}}},           // body
    TurnedPatch{{{2, 1.12, 0.9}, {2, 1.12, 0.45}, {1.5, 0.84, 0.225}, {1.5, 0.84, 0.15}}},
    TurnedPatch{{{0, 0, 3.15}, {0.8, 0.45, 3.15}, {0, 0, 2.85}, {0.2, 0.112, 2.7}}},               // knob
    TurnedPatch{{{0.2, 0.112, 2.7}, {0.4, 0.224, 2.55}, {1.3, 0.728, 2.55}, {1.3, 0.728, 2.4}}}};  // lid
constexpr TurnedPatch kBottom{{{0, 0, 0}, {1.425, 0.798, 0}, {1.5, 0.84, 0.075}, {1.5, 0.84, 0.15}}};

constexpr std::array<TubePatch, 4> kTubes{// handle
                                          TubePatch{{{{-1.6, 2.025}, {-1.5, 2.25}, 0.3},
                                                     {{-2.3, 2.025}, {-2.5, 2.25}, 0.3},
                                                     {{-2.7, 2.025}, {-3, 2.25}, 0.3},
                                                     {{-2.7, 1.8}, {-3, 1.8}, 0.3}}},
                                          TubePatch{{{{-2.7, 1.8}, {-3, 1.8}, 0.3},
                                                     {{-2.7, 1.575}, {-3, 1.35}, 0.3},
                                                     {{-2.5, 1.125}, {-2.65, 0.9375}, 0.3},
                                                     {{-2, 0.9}, {-1.9, 0.6}, 0.3}}},
                                          // spout
                                          TubePatch{{{{1.7, 1.425}, {1.7, 0.6}, 0.66},
                                                     {{2.6, 1.425}, {3.1, 0.825}, 0.66},
                                                     {{2.3, 2.1}, {2.4, 2.025}, 0.25},
                                                     {{2.7, 2.4}, {3.3, 2.4}, 0.25}}},
                                          TubePatch{{{{2.7, 2.4}, {3.3, 2.4}, 0.25},
                                                     {{2.8, 2.475}, {3.525, 2.49375}, 0.25},
                                                     {{2.9, 2.475}, {3.45, 2.5125}, 0.15},
                                                     {{2.8, 2.4}, {3.2, 2.4}, 0.15}}}};

/// [row along the profile, parameter v][column around it, parameter u], such that dS/du x dS/dv points
/// outside.
using Patch = std::array<std::array<Vec3d, 4>, 4>;
using Weights = std::array<double, 4>;

Weights bernstein(double t) {
  const double s = 1 - t;
  return {s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
}

Weights bernstein_slope(double t) {
  const double s = 1 - t;
  const double first = 3 * s * s;
  const double second = 6 * s * t;
  const double third = 3 * t * t;
  return {-first, first - second, second - third, third};
}

Vec3d blend(const Patch& patch, const Weights& rows, const Weights& columns) {
  Vec3d sum;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) sum += patch[i][j] * (rows[i] * columns[j]);
  return sum;
}

Vec3d patch_normal(const Patch& patch, double u, double v) {
  const Vec3d along_v = blend(patch, bernstein_slope(v), bernstein(u));
  // Where the whole first row is one point (top of the knob, centre of the bottom) dS/du vanishes with v; its
  // direction there is that of its derivative by v.
  const bool is_pole = v == 0 && patch[0][0] == patch[0][3];
  const Vec3d along_u = blend(patch, is_pole ? bernstein_slope(v) : bernstein(v), bernstein_slope(u));
  return normalised(cross(along_u, along_v));
}

// Newell's box is 6.43 x 3.15 x 4; this factor and lift put it into the box that the scenes were made for.
constexpr double kScale = 1 / 3.15;
constexpr double kLift = 0.09501 - 0.5;

void add_patch(Mesh& mesh, const Patch& patch, int subdivisions) {
  const std::uint32_t first = vertex_count(mesh);
  for (int i = 0; i <= subdivisions; ++i)
    for (int j = 0; j <= subdivisions; ++j) {
      const double u = double(i) / subdivisions;
      const double v = double(j) / subdivisions;
      const Vec3d point = blend(patch, bernstein(v), bernstein(u)) * kScale + Vec3d{0, kLift, 0};
      add_vertex(mesh, point, patch_normal(patch, u, v), {u, v});
    }
  add_grid_triangles(mesh, first, subdivisions, subdivisions);
}

Vec3d quarter_turns(Vec3d p, int count) {
  return count == 0 ? p : quarter_turns({-p.z, p.y, p.x}, count - 1);
}

Patch turned(const TurnedPatch& rows, int quarter) {
  Patch patch;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto [radius, offset, height] = rows[i];
    const std::array<Vec3d, 4> columns{Vec3d{radius, height, 0}, Vec3d{radius, height, offset},
                                       Vec3d{offset, height, radius}, Vec3d{0, height, radius}};
    for (std::size_t j = 0; j < 4; ++j) patch[i][j] = quarter_turns(columns[j], quarter);
  }
  return patch;
}

Patch with_reversed_columns(Patch patch) {
  for (auto& row : patch) row = {row[3], row[2], row[1], row[0]};
  return patch;
}

Patch half_tube(const TubePatch& rows, double side) {
  Patch patch;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto& [inner, outer, half_width] = rows[i];
    const double z = side * half_width;
    patch[i] = {Vec3d{inner.x, inner.y, 0}, Vec3d{inner.x, inner.y, z}, Vec3d{outer.x, outer.y, z},
                Vec3d{outer.x, outer.y, 0}};
  }
  return side > 0 ? patch : with_reversed_columns(patch);
}

}  // namespace

Mesh make_teapot(const TeapotParameters& parameters) {
  Mesh mesh;
  for (const TurnedPatch& rows : kTurned)
    for (int quarter = 0; quarter < 4; ++quarter)
      add_patch(mesh, turned(rows, quarter), parameters.subdivisions);
  for (int quarter = 0; quarter < 4;
       ++quarter)  // its profile runs outwards, against the others: the columns turn as well
    add_patch(mesh, with_reversed_columns(turned(kBottom, quarter)), parameters.subdivisions);
  for (const TubePatch& rows : kTubes)
    for (const double side : {1.0, -1.0}) add_patch(mesh, half_tube(rows, side), parameters.subdivisions);
  return mesh;
}

}  // namespace orbs::scene
