#pragma once

#include "scene/render_fault.h"
#include "scene/scene.h"
#include "tracer/plugins/plugin_library.h"
#include "tracer/world/world.h"

#include <memory>
#include <optional>
#include <string>

namespace orbs::tracer {

struct WorldSettings {
  /// Above this many triangles in world space, meshes with several instances are instanced instead of copied.
  /// Copies trace faster; two million triangles take about 0.4 GB.
  std::size_t most_copied_triangles = 500'000;
  /// What paths carry; nothing: no more than the scene calls for.
  std::optional<scene::LightTransport> transport = {};
  /// Permits a transport with fewer effects than the scene calls for. Indices are then those of 550 nm,
  /// spectra become colours, light is unpolarised or keeps its wavelength.
  bool may_lose_effects = false;
  /// Off: camera paths find all light alone. The expected image is the same; only its noise differs.
  bool light_paths = true;
  /// Off: no next-event estimation by way of flat mirrors. The expected image is the same; only its noise
  /// differs.
  bool mirrored_light = true;
  /// The expected image is the same for all; only its noise differs.
  DirectLight direct_light = DirectLight::Mis;
  LightSelection light_selection = LightSelection::Bvh;
  /// Off: paths end at the trace depth or where they carry nothing, not by Russian roulette.
  bool roulette = true;
  Intersection intersection = Intersection::Single;
  /// What of it is in the tracer and not in the scene, see scene::with_fault.
  std::optional<scene::RenderFault> fault = {};
  PluginLibraries plugins = {};  // those of open_plugins, for scenes that name some
};

/// Where the world of a scene lies: a point p of the world is (p + origin_m) / factor of the scene.
struct WorldPlace {
  Vec3d origin_m;
  double factor = 1;
};

WorldPlace place_of_world(const scene::Scene& scene);

/// Throws InputError if a texture cannot be read, a plug-in makes no shape, or if the given transport lacks
/// effects that the scene calls for.
World make_world(const scene::Scene& scene, const WorldSettings& settings = {});

/// Why no light paths are traced in the world, whatever is asked for: "they end at lights, and a light
/// of the scene has a reflectance"; "" where they can be.
std::string why_no_light_paths(const World& world);

/// Why World::connects_light_vertices must not be set; "" where it may be: light paths exist in such a world,
/// and their connections are weighted against the techniques of DirectLight::Mis.
std::string why_no_light_connections(const World& world);
inline bool supports_light_connections(const World& world) { return why_no_light_connections(world).empty(); }

/// Forgets what renders so far met at shapes by formula and of plug-ins: roots that stayed open, broken
/// rules.
inline void reset_counts(World& world) {
  for (auto& solid : world.solids) solid.counts = std::make_unique<RootCounts>();
  for (auto& shape : world.plugin_shapes) shape.faults = std::make_unique<PluginFaults>();
}

}  // namespace orbs::tracer
