#pragma once

#include "scene/scene.h"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

/// What an exported scene says, read by a small reader of our own that knows each format's conventions from
/// its manual, not from the exporter.
namespace orbs::tests {

/// Sums over the triangles of a material in world space, weighed by area: any wrong matrix, side, normal or
/// texture coordinate changes one of them.
struct Moments {
  double area_m2 = 0;
  Vec3d centre;  // times area
  Vec3d normal;  // of the vertices, times area
  Vec2d uv;      // as the texture sees it (v from the bottom), times area
};

/// Linear between its samples and zero beyond them, as both formats have it; a single number for all
/// wavelengths stands at 0.
using ReadSpectrum = std::map<double, double>;
double value_at(const ReadSpectrum& spectrum, double wavelength_nm);

/// A material as the format has it.
struct ReadSurface {
  std::string type;
  std::map<std::string, std::string> words;  // numbers and texts
  std::map<std::string, ReadSpectrum> spectra;
};

struct ReadLight {
  scene::RgbColour radiance;
  ReadSpectrum spectrum;                    // in the place of radiance; a flat 1 has Y = 1
  std::optional<ReadSpectrum> reflectance;  // where it is given as a spectrum
  double area_m2 = 0;
  Vec3d centre;
  Vec3d facing;  // zero for spheres
};

struct ReadScene {
  Vec3d eye;
  Vec3d target;
  Vec3d up;
  double fov_y_deg = 0;
  int width_px = 0;
  int height_px = 0;
  int trace_depth = 0;
  bool mirrored_x = false;  // pbrt's Scale -1 1 1
  scene::RgbColour environment;
  ReadSpectrum environment_spectrum;  // as that of a light
  bool has_stokes = false;
  std::map<std::string, ReadSurface> surfaces;  // by "material<index>"
  /// For each triangle of a material without a texture, in the world: the direction in which u grows.
  std::map<std::string, std::vector<Vec3d>> u_directions;
  std::map<std::string, Moments> materials;          // by "material<index>"
  std::map<std::string, scene::RgbColour> emission;  // of those that emit
  std::vector<ReadLight> lights;
};

/// Adds a mesh as it stands at `place`. `v_from_top`: the format counts v from the top row.
void add_mesh(Moments& moments, const scene::Mesh& mesh, const Mat4& place, bool v_from_top);

/// Straight from a scene, triangle by triangle, by the index of the material. `untextured_uv`: the
/// coordinates that a file has where no texture needs them; nothing: those of the mesh.
std::map<int, Moments> moments_of_materials(const scene::Scene& scene,
                                            std::optional<Vec2f> untextured_uv = std::nullopt);

std::vector<Vec3d> directions_of_u(const scene::Mesh& mesh, const Mat4& place);

/// All throw std::runtime_error for a text that is not well-formed or has a word they do not know.
ReadScene read_mitsuba(const std::filesystem::path& file);
ReadScene read_pbrt(const std::filesystem::path& file);
ReadScene read_hydra(const std::filesystem::path& file);

}  // namespace orbs::tests
