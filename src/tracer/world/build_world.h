#pragma once

#include "scene/scene.h"
#include "tracer/plugins/plugin_library.h"
#include "tracer/world/world.h"

#include <memory>
#include <optional>

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
  PluginLibraries plugins = {};  // those of open_plugins, for scenes that name some
};

/// Throws InputError if a texture cannot be read, a plug-in makes no shape, or if the given transport lacks
/// effects that the scene calls for.
World make_world(const scene::Scene& scene, const WorldSettings& settings = {});

/// Whether World::connects_light_vertices may be set: light paths exist in such a world, and their
/// connections are weighted against the techniques of DirectLight::Mis.
bool supports_light_connections(const World& world);

/// Forgets what renders so far met at shapes by formula and of plug-ins: roots that stayed open, broken
/// rules.
inline void reset_counts(World& world) {
  for (auto& solid : world.solids) solid.counts = std::make_unique<RootCounts>();
  for (auto& shape : world.plugin_shapes) shape.faults = std::make_unique<PluginFaults>();
}

}  // namespace orbs::tracer
