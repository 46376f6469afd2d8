#pragma once

#include "scene/effects.h"
#include "scene/scene.h"
#include "snippets/fresnel_mueller.h"
#include "tracer/accel/accel.h"
#include "tracer/colour/colour.h"
#include "tracer/light/emitter.h"
#include "tracer/world/mirror_planes.h"
#include "tracer/light/caustic_casters.h"
#include "tracer/colour/texture.h"

#include <array>
#include <memory>
#include <optional>
#include <vector>

/// The scene as the path loop reads it: single precision, world space, names and defaults resolved.
namespace orbs::tracer {

/// 3x4 affine map in float.
struct Affine {
  std::array<Vec3f, 3> axes{Vec3f{1, 0, 0}, Vec3f{0, 1, 0}, Vec3f{0, 0, 1}};  // images of x, y, z
  Vec3f offset;
};

inline Vec3f apply_to_direction(const Affine& map, Vec3f v) {
  return map.axes[0] * v.x + map.axes[1] * v.y + map.axes[2] * v.z;
}
inline Vec3f apply_to_point(const Affine& map, Vec3f p) { return apply_to_direction(map, p) + map.offset; }

/// What a hit on a triangle needs, side by side in memory and worked out once.
struct TriangleCache {
  Vec3f corner;
  Vec3f edge1;
  Vec3f edge2;
  Vec3f geometric_normal;  // unit; zero where the triangle has no area, which no ray hits
  Vec3f shading_normal;    // unit, where the three vertex normals are equal; else unused
  float size = 0;          // largest absolute coordinate of the corners
  int material = 0;        // of the mesh
  bool has_one_normal = false;
};

struct TriangleMesh {
  std::vector<Vec3f> positions;
  std::vector<Vec3f> normals;
  std::vector<Vec2f> uvs;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<int> materials;  // per triangle
  std::vector<TriangleCache> triangle_cache;     // per triangle
};

struct SphereSurface {
  Vec3f centre;
  float radius = 0;
  int material = 0;
};

enum class ObjectKind { WorldMesh, InstancedMesh, Light, Sphere };

/// One thing that rays can hit: a mesh whose vertices are in world space, an instance of a mesh in its own
/// space, a light, or a sphere.
struct RenderObject {
  ObjectKind kind = ObjectKind::WorldMesh;
  std::size_t mesh = 0;    // of meshes
  std::size_t light = 0;   // of lights
  std::size_t sphere = 0;  // of spheres
  Affine to_world;         // InstancedMesh only
  Affine normal_to_world;
  std::vector<int> material_of;    // material of the mesh -> material shown (remap list applied)
  std::vector<int> mirror_planes;  // per triangle, see mirror_planes.h; empty where there is none
};

/// Those of ORB.S, then those beyond it.
enum class Model {
  Lambert,
  OrenNayar,
  Mirror,
  Glass,
  Ggx,
  RoughGlass,
  Emission,
  Conductor,
  Dielectric,
  ThinElement,
  Fluorescent
};

struct SurfaceMaterial {
  Model model = Model::Lambert;
  Colour colour{};  // reflectance, tint or radiance
  float roughness = 0;
  float alpha = 0;
  float ior = 1;
  int texture = -1;
  int details = -1;       // of conductors, dielectrics, sheets or reradiations, by the model
  bool is_near_specular = false;  // see caustic_casters.h
  UvMap uv{};
  float emitter_pdf_per_area =
      0;  // Emission: chance per m^2 that light sampling picks a point, selection included
};

struct DielectricSurface {
  scene::Dielectric model;
  bool is_dispersive = false;
};

/// A polariser or retarder, whose x lies along the axis.
struct ThinElement {
  snippets::AlignedMueller<float> element;
  Vec3f axis;  // in the world
};

struct PinholeCamera {
  Vec3f position;
  Vec3f forward;  // to the centre of the image plane at distance 1
  Vec3f right;    // half the image plane's width
  Vec3f up;       // half its height
  int width = 0;
  int height = 0;
};

struct World {
  PinholeCamera camera;
  scene::LightTransport transport = scene::LightTransport::Rgb;  // what its paths carry
  bool has_appearance_materials = false;                                   // materials beyond ORB.S
  bool wants_stokes = false;
  Radiance environment;
  int trace_depth = 1;
  std::vector<spectra::Spectrum> spectra;  // of colours and lights, scales applied; none for Colour
  std::vector<scene::Conductor> conductors;
  std::vector<DielectricSurface> dielectrics;
  std::vector<ThinElement> thin_elements;
  std::vector<scene::Reradiation> reradiations;
  std::vector<TexelGrid> textures;
  std::vector<SurfaceMaterial> materials;
  std::vector<TriangleMesh> meshes;
  std::vector<SphereSurface> spheres;
  std::vector<RenderObject> objects;
  std::vector<AreaLight> lights;
  EmitterTable emitters;
  /// Empty unless light paths are traced: then they carry all light that leaves its source towards a sharp
  /// surface and reaches the camera from another that is not sharp, or by the tail of its lobe (kTailPdf),
  /// and camera paths leave it to them.
  std::vector<BoundingSphere> caustic_casters;
  std::vector<MirrorPlane> mirror_planes;
  std::unique_ptr<Accel> accel;
};

struct WorldSettings {
  /// Above this many triangles in world space, meshes with several instances are instanced instead of copied.
  /// Copies trace faster; two million triangles take about 0.4 GB.
  std::size_t most_copied_triangles = 500'000;
  /// What paths carry; nothing: no more than the scene calls for.
  std::optional<scene::LightTransport> transport = {};
  /// Whether that may be less than the scene calls for. Indices are then those of 550 nm, spectra are
  /// colours, light is not polarised or keeps its wavelength.
  bool may_lose_effects = false;
  /// Off: camera paths find all light by themselves. The image is the same but for its noise.
  bool light_paths = true;
  /// Off: no light is asked for by way of flat mirrors. The image is the same but for its noise.
  bool mirrored_light = true;
};

/// InputError when a texture cannot be read, or the transport asked for lacks what the scene calls for.
World make_world(const scene::Scene& scene, const WorldSettings& settings = {});

/// Unit direction and origin through film position (x, y) in pixels from the upper left corner.
Ray camera_ray(const PinholeCamera& camera, float x, float y);

}  // namespace orbs::tracer
