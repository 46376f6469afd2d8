#pragma once

#include "base/matrix.h"
#include "base/nth.h"
#include "base/vec.h"
#include "scene/colour.h"
#include "scene/environment.h"
#include "scene/geometry/mesh.h"
#include "scene/integrator.h"
#include "scene/lights/light.h"
#include "scene/material.h"
#include "scene/projections/projection.h"
#include "scene/shapes/shape.h"
#include "scene/texture.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <variant>
#include <vector>

/// A scene is plain data: what is to be rendered, with no renderer in it. Metres, y up, right-handed;
/// explicit colours are linear Rec.709; emission is the radiance seen on the screen (ORB.S, REQ_M2 and
/// REQ_L1). Objects refer to each other by index into the vectors of Scene.
namespace orbs::scene {

/// When the shutter of the camera is open, in lengths of a frame: 0 is its start, 1 its end. The image is the
/// mean over the times between; without a length it shows an instant.
struct Shutter {
  double open = 0;
  double close = 0;
  bool operator==(const Shutter&) const = default;
};

/// Where the camera is and looks at the end of the frame. See motion.h for the times between.
struct CameraEnd {
  Vec3d position_m;
  Vec3d look_at_m;
  Vec3d up{0, 1, 0};
  bool operator==(const CameraEnd&) const = default;
};

/// gluLookAt and, unless it has another projection, glFrustum as in ORB.S REQ_G2. Near and far planes do not
/// clip: they are part of the OpenGL matrix only.
struct Camera {
  Vec3d position_m;
  Vec3d look_at_m;
  Vec3d up{0, 1, 0};
  double fov_y_deg = 90;  // of a perspective
  int width_px = 1024;
  int height_px = 1024;
  double near_m = 0.1;
  double far_m = 100;
  std::optional<double> focus_distance_m;  // ORB.S "camera distance", along the axis; a lens has it
  Shutter shutter;
  std::optional<CameraEnd> end = std::nullopt;  // of a camera that moves
  Projection projection{};
  double aperture_radius_m = 0;  // of the thin lens of a perspective; 0: a pinhole
  Vec2d shift{};                 // of the window of a perspective, in widths to the right and heights up
  bool operator==(const Camera&) const = default;
};

/// One placement of a mesh; a mesh without instances is not drawn. Each pair of `remap` replaces the
/// material `first` by `second`; the list is looked up once per triangle, so it does not chain (ORB.S
/// REQ_G5).
struct Instance {
  std::string name;
  int mesh = 0;
  Mat4 matrix;
  std::vector<std::pair<int, int>> remap;
  /// At the end of the frame, of an instance that moves; `matrix` is that of its start.
  std::optional<Mat4> end_matrix = std::nullopt;
  bool operator==(const Instance&) const = default;
};

/// A sphere by its formula that no matrix places; other shapes are in scene/shapes/shape.h. Normals point out
/// of the sphere, v runs from 0 at the south pole (-Y) to 1, u around the equator from +Z towards +X.
struct Sphere {
  std::string name;
  Vec3d centre_m;
  double radius_m = 1;
  int material = 0;
  bool operator==(const Sphere&) const = default;
};

/// Layers that the image holds beside the colour.
struct Outputs {
  bool stokes = false;                // S0 to S3 in the camera's frame
  bool path_classes = false;          // one layer for each class of light path
  std::vector<std::string> layers{};  // names of image::kLayers, each once
  bool operator==(const Outputs&) const = default;
};

/// A trace depth that no path reaches: Russian roulette ends them all.
constexpr int kUnlimitedDepth = 1'000'000;

/// How a scene was read. It is no part of the scene's value: scenes that differ in nothing else are equal.
struct ReadNotes {
  std::vector<std::filesystem::path> tables;  // files that spectra and indices were read from
  std::vector<std::string> warnings;          // file:line and the oddity that was accepted
  std::string camera;                         // the one of "cameras" that was chosen; "": that of "camera"
  bool operator==(const ReadNotes&) const { return true; }
};

struct Scene {
  std::string name;
  Camera camera;
  Environment environment;
  SpectrumList spectra;
  std::vector<Texture> textures;
  std::vector<Material> materials;
  std::vector<Mesh> meshes;
  std::vector<Instance> instances;
  std::vector<Sphere> spheres;
  std::vector<Shape> shapes;
  std::vector<Light> lights;
  int trace_depth = 5;  // most surface scatterings on a path; 1 is direct light (ORB.S REQ_A1)
  Integrator integrator;
  Outputs outputs;
  ReadNotes notes;
  bool operator==(const Scene&) const = default;
};

/// The material that an instance shows where its mesh has `material`.
int remapped(const Instance& instance, int material);

/// Indices of the materials that an instance or a shape shows, remap lists applied, and of the parts of
/// blends among them.
std::set<int> visible_materials(const Scene& scene);

/// "light 'key'", or "light 2" for the one at that place of the file when it has no name.
std::string display_name(const char* kind, const std::string& name, std::size_t place);

inline const Material& material_at(const Scene& scene, int index) { return nth(scene.materials, index); }
inline const Texture& texture_at(const Scene& scene, const TextureUse& use) {
  return nth(scene.textures, use.texture);
}
inline const Mesh& mesh_of(const Scene& scene, const Instance& instance) {
  return nth(scene.meshes, instance.mesh);
}

}  // namespace orbs::scene
