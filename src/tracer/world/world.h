#pragma once

#include "scene/effects/effects.h"
#include "tracer/accel/accel.h"
#include "tracer/accel/openings.h"
#include "tracer/bsdf/materials.h"
#include "tracer/colour/colour.h"
#include "tracer/geometry/mirror_plane.h"
#include "tracer/geometry/render_object.h"
#include "tracer/light/caustic_casters.h"
#include "tracer/light/direct_light.h"
#include "tracer/light/emitter.h"
#include "tracer/light/emitter_table.h"
#include "tracer/light/light_bvh.h"
#include "tracer/light/light_guides.h"
#include "tracer/plugins/plugin_shape.h"
#include "tracer/shapes/solid.h"
#include "tracer/world/prepare_camera.h"

#include <memory>
#include <optional>
#include <vector>

namespace orbs::tracer {

/// A normal map as it is looked up.
struct NormalTexture {
  int texture = -1;  // index into World::textures; -1: none
  UvMap uv{};
  Vec2f strength{1, 1};  // along u and v
};

/// A bump map, likewise: metres above the surface where its red is 1.
struct BumpTexture {
  int texture = -1;
  UvMap uv{};
  float height_m = 0;
};

struct NormalDetail {
  NormalTexture normal{};
  BumpTexture bump{};
};

/// The scene as the path loop reads it: single precision, world space, names and defaults resolved.
/// build_world.h makes it.
struct World {
  Camera camera;
  std::optional<scene::Shutter> shutter;                         // of a scene in which something moves
  std::optional<MovingCamera> moving_camera;                     // `camera` is then that of the start
  scene::LightTransport transport = scene::LightTransport::Rgb;  // what its paths carry
  bool has_appearance_materials = false;                         // a surface shows one
  bool wants_stokes = false;
  Radiance environment;                                   // constant; black where there is a map
  std::unique_ptr<const EnvironmentMap> environment_map;  // of the light `environment_light`
  int environment_light = -1;                             // its place in `lights`
  bool camera_sees_environment = true;
  scene::Integrator integrator;            // an irradiance cache needs Rgb transport
  int trace_depth = 1;                     // most scattering events of a path
  std::vector<spectra::Spectrum> spectra;  // of colours and lights, scales applied; empty for RGB
  std::vector<TexelGrid> textures;
  std::vector<SurfaceMaterial> materials;
  std::vector<MaterialOpacity> opacities;    // of the materials; empty: all that is shown is opaque
  std::vector<NormalDetail> normal_details;  // likewise; empty: no normal is turned
  std::vector<TriangleMesh> meshes;
  std::vector<SphereSurface> spheres;
  std::vector<Solid> solids;
  std::vector<PluginShape> plugin_shapes;
  std::vector<RenderObject> objects;
  std::vector<AreaLight> lights;
  bool has_lights_without_area = false;
  EmitterTable emitters;
  LightBvh light_bvh;  // of the emitters; empty: light sampling selects them by power alone
  /// Empty unless light paths are traced. They then carry all light that leaves its emitter towards a
  /// near-specular surface and reaches the camera from another surface that is not near-specular, or by the
  /// tail of its lobe (kTailPdf); camera paths skip that light.
  std::vector<BoundingSphere> caustic_casters;
  /// Camera paths also connect to the first hits of light paths (connect_light_vertices.h).
  bool connects_light_vertices = false;
  std::vector<LightGuide> light_guides;  // of the light paths that they need; empty: by power and cosine
  std::vector<MirrorPlane> mirror_planes;
  DirectLight direct_light = DirectLight::Mis;
  bool roulette = true;
  std::unique_ptr<Accel> accel;
};

}  // namespace orbs::tracer
