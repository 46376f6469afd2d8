#pragma once

#include "base/matrix.h"
#include "base/vec.h"
#include "scene/spectral.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

/// A scene is plain data: what is to be rendered, with no renderer in it. Metres, y up, right-handed;
/// explicit colours are linear Rec.709; emission is the radiance seen on the screen (ORB.S, REQ_M2 and
/// REQ_L1). Things refer to each other by index into the vectors of Scene.
namespace orbs::scene {

using RgbColour = Vec3d;
inline bool is_grey(RgbColour c) { return c.x == c.y && c.y == c.z; }

/// gluLookAt and glFrustum as in ORB.S REQ_G2. Near and far planes do not clip: they are part of the OpenGL
/// matrix only.
struct Camera {
  Vec3d position_m;
  Vec3d look_at_m;
  Vec3d up{0, 1, 0};
  double fov_y_deg = 90;
  int width_px = 1024;
  int height_px = 1024;
  double near_m = 0.1;
  double far_m = 100;
  std::optional<double> focus_distance_m;  // ORB.S "camera distance"; a pinhole has no use for it
  bool operator==(const Camera&) const = default;
};

enum class Wrap { Repeat, Clamp };

/// LDR files (PNG, JPEG, BMP) hold sRGB values and are decoded to linear per texel, before bilinear
/// filtering; float files are linear. The bottom row of the image has v = 0; texel centres lie at +0.5.
struct Texture {
  std::string name;
  std::filesystem::path file;  // absolute
  Wrap wrap_u = Wrap::Repeat;
  Wrap wrap_v = Wrap::Repeat;
  bool operator==(const Texture&) const = default;
};

/// A texture as a material uses it: u' = m00 u + m01 v + m03, v' = m10 u + m11 v + m13 (ORB.S REQ_M5).
struct TextureUse {
  int texture = 0;
  Mat4 matrix;
  bool operator==(const TextureUse&) const = default;
};

struct Lambert {
  RgbColour reflectance;
  std::optional<TextureUse> texture;  // multiplies reflectance
  std::optional<SpectrumUse> spectrum = {};
  bool operator==(const Lambert&) const = default;
};
/// ORB.S eq. 5 with sigma = roughness * pi / 2 radians.
struct OrenNayar {
  RgbColour reflectance;
  double roughness = 0;  // [0, 1]
  std::optional<TextureUse> texture;
  std::optional<SpectrumUse> spectrum = {};
  bool operator==(const OrenNayar&) const = default;
};
struct Mirror {
  RgbColour reflectance;
  std::optional<SpectrumUse> spectrum = {};
  bool operator==(const Mirror&) const = default;
};
/// Smooth dielectric of ORB.S REQ_M8; `ior` is inside over outside, and the vertex normals point outside.
struct Glass {
  RgbColour colour;
  double ior = 1.5;
  bool operator==(const Glass&) const = default;
};
/// colour * D G / (4 cos cos), height-correlated Smith-GGX, no Fresnel factor.
struct Ggx {
  RgbColour colour;
  double alpha = 0.1;
  std::optional<SpectrumUse> spectrum = {};
  bool operator==(const Ggx&) const = default;
};
/// Rough dielectric after Walter et al. 2007 with GGX; masking is height-correlated in reflection, separable
/// in transmission.
struct RoughGlass {
  RgbColour colour;
  double ior = 1.5;
  double alpha = 0.1;
  bool operator==(const RoughGlass&) const = default;
};
/// Emits `radiance` (times the texture) from both sides and reflects nothing.
struct Emission {
  RgbColour radiance;
  std::optional<TextureUse> texture;
  std::optional<SpectrumUse> spectrum = {};
  bool operator==(const Emission&) const = default;
};

/// The models from here on go beyond ORB.S. Interfaces by their indices of refraction: reflectance, phase and
/// polarisation follow from Fresnel's formulas, or with a film from Airy's sum; smooth without `roughness`.
/// A conductor is black from behind.
struct Conductor {
  spectra::MetalIndex index;
  spectra::RefractiveIndex outside = spectra::constant(1);
  std::optional<Roughness> roughness;
  std::optional<Film> film;
  bool operator==(const Conductor&) const = default;
};
/// The vertex normals point outside; an open sheet is one interface. Radiance is scaled by the squared ratio
/// of the indices on refraction.
struct Dielectric {
  spectra::RefractiveIndex index;
  spectra::RefractiveIndex outside = spectra::constant(1);
  std::optional<Roughness> roughness;
  std::optional<Film> film;
  bool operator==(const Dielectric&) const = default;
};
/// Ideal sheets that light crosses straight on. The axis, a world direction, is projected into the sheet:
/// along it a polariser transmits everything, across it nothing; in a retarder it is the fast axis, and light
/// across it comes `retardance_deg` late, at all wavelengths.
struct Polariser {
  Vec3d axis;
  bool operator==(const Polariser&) const = default;
};
struct Retarder {
  Vec3d axis;
  double retardance_deg = 90;
  bool operator==(const Retarder&) const = default;
};
/// Lambert's law at every wavelength, and from both sides as there, and light at longer wavelengths beside
/// it.
struct Fluorescent {
  RgbColour reflectance;
  std::optional<SpectrumUse> spectrum;
  Reradiation reradiation;
  bool gains_energy = false;  // more leaves than came in, on purpose
  bool operator==(const Fluorescent&) const = default;
};

using MaterialModel = std::variant<Lambert,
                                   OrenNayar,
                                   Mirror,
                                   Glass,
                                   Ggx,
                                   RoughGlass,
                                   Emission,
                                   Conductor,
                                   Dielectric,
                                   Polariser,
                                   Retarder,
                                   Fluorescent>;

/// The models that ORB.S does not have, for code that knows ORB.S's alone.
template <typename Model>
concept AppearanceModel = std::is_same_v<Model, Conductor> || std::is_same_v<Model, Dielectric> ||
    std::is_same_v<Model, Polariser> || std::is_same_v<Model, Retarder> || std::is_same_v<Model, Fluorescent>;

struct Material {
  std::string name;
  MaterialModel model;
  bool operator==(const Material&) const = default;
};

/// Indexed triangles with the attributes of ORB.S REQ_G1, used exactly as given. All vertex arrays have one
/// length.
struct Mesh {
  std::string name;
  std::vector<Vec3f> positions;
  std::vector<Vec3f> normals;
  std::vector<Vec3f> tangents;  // zero where not available
  std::vector<Vec2f> uvs;       // zero where not available
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<int> triangle_materials;  // one per triangle
  bool operator==(const Mesh&) const = default;
};

/// One appearance of a mesh; a mesh without instances is not drawn. Each pair of `remap` replaces the
/// material `first` by `second`; the list is looked up once per triangle, so it does not chain (ORB.S
/// REQ_G5).
struct Instance {
  std::string name;
  int mesh = 0;
  Mat4 matrix;
  std::vector<std::pair<int, int>> remap;
  bool operator==(const Instance&) const = default;
};

/// A surface by its formula rather than by triangles; normals point out of the sphere, v runs from 0 at the
/// south pole (-Y) to 1, u around the equator from +Z towards +X.
struct Sphere {
  std::string name;
  Vec3d centre_m;
  double radius_m = 1;
  int material = 0;
  bool operator==(const Sphere&) const = default;
};

/// In the local XZ plane, emitting towards local -Y only; the back is black, opaque and visible.
struct RectShape {
  double half_width_m = 1;   // along local X
  double half_length_m = 1;  // along local Z
  bool operator==(const RectShape&) const = default;
};
struct DiskShape {
  double radius_m = 1;
  bool operator==(const DiskShape&) const = default;
};
struct SphereShape {
  double radius_m = 1;
  bool operator==(const SphereShape&) const = default;
};
using LightShape = std::variant<RectShape, DiskShape, SphereShape>;

/// Intensity distribution of a luminaire, LM-63 type C: candela over (vertical, horizontal) angle with
/// symmetry unfolded.
struct IesProfile {
  std::vector<double> vertical_deg;    // ascending within [0, 180]; 0 = nadir = local -Y of the light
  std::vector<double> horizontal_deg;  // ascending; first 0, last 360; 0 = local +X, 90 = local +Z
  std::vector<double> candela;         // [horizontal][vertical]
  double max_candela = 0;
  bool operator==(const IesProfile&) const = default;
};

/// The light's radiance is multiplied by candela / max candela.
struct IesUse {
  std::filesystem::path file;  // absolute
  std::shared_ptr<const IesProfile> profile;
  Mat4 matrix;  // turns the profile within the light's local frame
  /// true: the direction is taken from the light's centre (ORB.S REQ_L4, point-area); false: from the point
  /// on the light.
  bool point_area = false;
  bool operator==(const IesUse& other) const {
    return file == other.file && *profile == *other.profile && matrix == other.matrix &&
           point_area == other.point_area;
  }
};

struct Light {
  std::string name;
  LightShape shape;
  RgbColour radiance;
  Mat4 matrix;  // moves, turns and scales the shape; radiance stays
  std::optional<IesUse> ies;
  std::optional<SpectrumUse> spectrum = {};
  RgbColour reflectance = {};  // of the side that shines, by Lambert's law
  bool operator==(const Light&) const = default;
};

/// What the image holds beside the colour.
struct Outputs {
  bool stokes = false;        // S0 to S3 in the camera's frame
  bool path_classes = false;  // one layer for each class of light path
  bool operator==(const Outputs&) const = default;
};

/// A trace depth that no path reaches: Russian roulette ends them all.
constexpr int kUnlimitedDepth = 1'000'000;

/// How a scene was read, which is no part of what it is: scenes that differ in nothing else are equal.
struct ReadNotes {
  std::vector<std::filesystem::path> tables;  // files that spectra and indices were read from
  std::vector<std::string> warnings;          // file:line and what was let through
  bool operator==(const ReadNotes&) const { return true; }
};

struct Scene {
  std::string name;
  Camera camera;
  RgbColour environment;  // constant radiance of everything that no surface covers
  std::optional<SpectrumUse> environment_spectrum;
  std::vector<NamedSpectrum> spectra;
  std::vector<Texture> textures;
  std::vector<Material> materials;
  std::vector<Mesh> meshes;
  std::vector<Instance> instances;
  std::vector<Sphere> spheres;
  std::vector<Light> lights;
  int trace_depth = 5;  // most surface scatterings on a path; 1 is direct light (ORB.S REQ_A1)
  Outputs outputs;
  ReadNotes notes;
  bool operator==(const Scene&) const = default;
};

/// The material that an instance shows where its mesh has `material`.
int remapped(const Instance& instance, int material);

/// The texture of a material, if its model has one.
const std::optional<TextureUse>& texture_of(const MaterialModel& model);

/// The spectrum that a model has in the place of its colour, if it has one.
const std::optional<SpectrumUse>& spectrum_of(const MaterialModel& model);

}  // namespace orbs::scene
