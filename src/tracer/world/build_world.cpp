#include "tracer/world/build_world.h"

#include "base/error.h"
#include "base/nth.h"
#include "scene/geometry/extent.h"
#include "scene/geometry/world_bounds.h"
#include "scene/mirrored_frames.h"
#include "scene/motion.h"
#include "scene/relations/geometry.h"
#include "scene/relations/motion.h"
#include "scene/scene.h"
#include "tracer/colour/scene_colours.h"
#include "tracer/integrator/light_sampling.h"
#include "tracer/numeric_fault.h"
#include "tracer/world/build_lights.h"
#include "tracer/world/build_meshes.h"
#include "tracer/world/prepare_camera.h"
#include "tracer/world/specular_objects.h"
#include "tracer/world/surface.h"
#include "tracer/world/world.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>

#include <fmt/format.h>

/// A step of make_world.

namespace orbs::tracer {

namespace {

// Up to this roughness light paths find the light in a lobe better than light sampling at the surface itself.
constexpr float kNearSpecularAlpha = 0.3F;

bool is_appearance(const MaterialModel& model) {
  return std::visit([](const auto& m) { return std::decay_t<decltype(m)>::kIsAppearance; }, model);
}

void add_materials(const scene::Scene& scene, const SceneColours& colours, World& world) {
  for (const auto& material : scene.materials) {
    SurfaceMaterial out{
        .model = std::visit([&](const auto& m) -> MaterialModel { return make_material(m, colours); },
                            material.model)};
    const float alpha = std::visit([](const auto& m) { return lobe_alpha(m); }, out.model);
    out.is_delta = alpha == 0;
    out.is_near_specular = alpha < kNearSpecularAlpha;
    world.materials.push_back(std::move(out));
  }
  for (const int index : scene::visible_materials(scene))
    world.has_appearance_materials =
        world.has_appearance_materials || is_appearance(nth(world.materials, index).model);
}

// The materials whose green is turned over.
std::set<int> flipped_normal_maps(const scene::Scene& scene, std::optional<scene::RenderFault> fault) {
  if (fault == scene::RenderFault::FramesWithoutSign)
    return scene::materials_in_wrong_frames(scene, scene::FrameSign::None);
  if (fault == scene::RenderFault::FramesWithSignOfMesh)
    return scene::materials_in_wrong_frames(scene, scene::FrameSign::OfMesh);
  if (fault == scene::RenderFault::NormalMapFlipped) return scene::visible_materials(scene);
  return {};
}

// Empty unless something that is shown has them: what follows is not executed then.
void add_details(const scene::Scene& scene, std::optional<scene::RenderFault> fault, World& world) {
  bool has_openings = false;
  bool has_normals = false;
  for (const int index : scene::visible_materials(scene)) {
    has_openings = has_openings || lets_rays_pass(material_at(scene, index).detail);
    has_normals = has_normals || turns_normals(material_at(scene, index).detail);
  }
  const auto flipped = flipped_normal_maps(scene, fault);
  const auto map_of = [&](const scene::TextureUse& use) { return uv_map(use, texture_at(scene, use)); };
  for (const auto& [name, model, detail] : scene.materials) {
    if (has_openings) {
      MaterialOpacity& opacity = world.opacities.emplace_back();
      opacity.share = static_cast<float>(detail.opacity);
      if (const auto& use = detail.opacity_texture) {
        opacity.texture = use->texture;
        opacity.uv = map_of(*use);
      }
      if (fault == scene::RenderFault::OpacityInverted && lets_rays_pass(detail))
        opacity = {1 - opacity.share, 1 - opacity.at_black, opacity.texture, opacity.uv};
    }
    if (!has_normals) continue;
    NormalDetail& turned = world.normal_details.emplace_back();
    if (const auto& map = detail.normal_map) {
      const auto strength = static_cast<float>(map->strength);
      const bool is_flipped = flipped.contains(static_cast<int>(world.normal_details.size()) - 1);
      turned.normal = {
          map->texture.texture, map_of(map->texture), {strength, is_flipped ? -strength : strength}};
    }
    if (const auto& map = detail.bump_map)
      turned.bump = {map->texture.texture, map_of(map->texture), static_cast<float>(map->height_m)};
  }
}

// A transport given by the settings must have every effect that the scene calls for.
scene::LightTransport checked_transport(const scene::Scene& scene, const WorldSettings& settings) {
  const auto& given = settings.transport;
  const auto found = scene::effects(scene);
  const auto needed = scene::transport(found);
  if (!given || *given == needed) return needed;
  if (settings.may_lose_effects || scene::covers(*given, needed)) return *given;
  throw InputError(fmt::format("scene '{}' calls for {} transport{}, which {} transport does not have",
                               scene.name, scene::transport_name(needed), scene::reason_for(found),
                               scene::transport_name(*given)));
}

// The rounding of the corners of a mesh or a light that is 256 times as large as all that is smaller is 1e-5
// of that, and what follows from it 1e-4. Beyond, its triangles are met in double.
constexpr double kVast = 256;

// Products of four lengths leave the range of floats in a scene of 1e-8 m, and tolerances are absolute in
// places. No radiance depends on a scale, so a small scene is enlarged by a power of two: bit for bit the
// same image as of the larger scene. A large scene is reduced: two of its places are two radii apart at most,
// and the fourth power of that, 2^124, is a float.
constexpr double kLeastRadius_m = 0x1p-4;
constexpr double kMostRadius_m = 0x1p30;

void check_irradiance_cache(const scene::Scene& scene, const World& world) {
  if (world.transport != scene::LightTransport::Rgb)
    throw InputError(fmt::format(
        "scene '{}' has an irradiance cache, which keeps three channels, and {} transport has more: render it "
        "with rgb transport, or by the integrator 'path'",
        scene.name, scene::transport_name(world.transport)));
  if (world.shutter)
    throw InputError(fmt::format(
        "scene '{}' has an irradiance cache, which is made at one time, and something moves while the shutter "
        "is open: render it by the integrator 'path'",
        scene.name));
}

double factor_of_world(const scene::Scene& scene) {
  return has_fault(NumericFault::NotRescaled) ? 1
                                              : scene::rescaling_into(scene, kLeastRadius_m, kMostRadius_m);
}

scene::Scene enlarged(const scene::Scene& scene, double factor) {
  return scene::moved(scene, scaling({factor, factor, factor}));
}

Vec3d origin_of_world(const scene::Extent& extent) {
  return has_fault(NumericFault::OriginNotMoved) ? Vec3d{} : scene::origin_near(extent);
}

World make_world_as_is(const scene::Scene& scene, const WorldSettings& settings) {
  World world;
  world.transport = checked_transport(scene, settings);
  const SceneColours colours{scene, world.transport != scene::LightTransport::Rgb, world.spectra};
  const scene::Extent extent = scene::extent_of(scene);
  const Vec3d origin = origin_of_world(extent);
  world.camera = prepare_camera(scene.camera, extent, origin);
  if (scene::has_motion(scene)) world.shutter = scene.camera.shutter;
  if (world.shutter && scene.camera.end) world.moving_camera = {scene.camera, extent, origin};
  world.wants_stokes =
      scene.outputs.stokes && scene::covers(world.transport, scene::LightTransport::Polarised);
  if (!scene.environment.map)
    world.environment = {cast<float>(scene.environment.radiance),
                         add_spectrum(colours, scene.environment.spectrum)};
  world.camera_sees_environment = scene.environment.visible_to_camera;
  world.integrator = scene.integrator;
  if (std::holds_alternative<scene::IrradianceCache>(world.integrator)) check_irradiance_cache(scene, world);
  world.trace_depth = scene.trace_depth;
  for (const auto& texture : scene.textures)
    world.textures.push_back(load_texels(
        texture, settings.fault == scene::RenderFault::RawTextures ? Texels::AsStored : Texels::Linear));
  add_materials(scene, colours, world);
  add_details(scene, settings.fault, world);
  constexpr double kNone = std::numeric_limits<double>::infinity();
  const scene::VastObjects is_vast =
      scene::vast_objects(scene, has_fault(NumericFault::VastInSingle) ? kNone : kVast);
  add_meshes(scene, origin, is_vast.instances, settings.most_copied_triangles, world);
  add_spheres(scene, origin, world);
  add_solids(scene, origin, world);
  add_plugin_shapes(scene, origin, settings.plugins, world);
  add_lights(scene, origin, colours, is_vast.lights, world);
  build_emitters(world, settings.light_selection);
  for (TriangleMesh& mesh : world.meshes) fill_triangle_cache(mesh);
  world.direct_light = settings.direct_light;
  world.roulette = settings.roulette;
  // Light paths and camera paths share the light another way if there are no planes, so both work without.
  if (settings.mirrored_light && samples_lights(world)) find_mirror_planes(world);
  if (settings.light_paths && why_no_light_paths(world).empty())
    world.caustic_casters = find_caustic_casters(world);
  world.accel =
      std::make_unique<Accel>(AccelGeometry{world.objects,
                                            world.meshes,
                                            world.spheres,
                                            world.solids,
                                            world.plugin_shapes,
                                            world.lights,
                                            {world.objects, world.meshes, world.textures, world.opacities}},
                              settings.intersection);
  return world;
}

}  // namespace

World make_world(const scene::Scene& scene, const WorldSettings& settings) {
  const double factor = factor_of_world(scene);
  if (factor == 1) return make_world_as_is(scene, settings);
  return make_world_as_is(enlarged(scene, factor), settings);
}

WorldPlace place_of_world(const scene::Scene& scene) {
  const double factor = factor_of_world(scene);
  return {origin_of_world(scene::extent_of(factor == 1 ? scene : enlarged(scene, factor))), factor};
}

// Light paths end at lights, keep their wavelengths, and carry plain factors instead of matrices. So they are
// not traced where lights reflect, surfaces fluoresce, or light is polarised. An irradiance cache keeps the
// light that they would carry.
std::string why_no_light_paths(const World& world) {
  if (!std::holds_alternative<scene::PathTracing>(world.integrator))
    return "an irradiance cache keeps the light that they would carry";
  if (world.shutter) return "they would meet the camera's paths at a time of their own, and something moves";
  if (world.environment_light >= 0)
    return "they start at lights alone, and what they light is lit by an environment map as well";
  if (std::holds_alternative<LatitudeLongitude>(world.camera.kind))
    return "a latitude-longitude image magnifies without bound towards its poles, and so their noise";
  if (world.emitters.empty()) return "the scene has no light or finite emitter that they could start at";
  // Of the transport, not of the materials: one that no surface shows must change nothing.
  if (scene::covers(world.transport, scene::LightTransport::Polarised))
    return fmt::format("they carry no polarisation, and the transport is {}",
                       scene::transport_name(world.transport));
  if (scene::covers(world.transport, scene::LightTransport::Bispectral))
    return fmt::format("they keep their wavelength, and the transport is {}",
                       scene::transport_name(world.transport));
  if (std::any_of(world.lights.begin(), world.lights.end(),
                  [](const auto& light) { return !(light.reflectance == Vec3f{}); }))
    return "they end at lights, and a light of the scene has a reflectance";
  return "";
}

std::string why_no_light_connections(const World& world) {
  if (auto why = why_no_light_paths(world); !why.empty()) return why;
  if (world.has_lights_without_area)
    return "they start at points of emitters with an area, and a light of the scene has none";
  if (world.direct_light != DirectLight::Mis) return "they are weighted against --direct-light mis alone";
  if (world.trace_depth < 2) return "they add a bounce, and the trace depth of the scene is 1";
  return "";
}

}  // namespace orbs::tracer
