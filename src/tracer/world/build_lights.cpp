#include "tracer/world/build_lights.h"

#include "base/nth.h"
#include "image/colour.h"
#include "scene/geometry/world_bounds.h"
#include "tracer/world/build_meshes.h"

#include <cmath>

namespace orbs::tracer {

namespace {

AreaLight prepare_light(const scene::Light& light, Vec3d origin, const SceneColours& colours) {
  const Mat4 matrix = relative_to(light.matrix, origin);
  const Mat4 back = inverse(matrix).value();
  const Vec3d normal = normalised(transform_normal(back, {0, -1, 0}));
  AreaLight out{
      .shape = std::visit([&](const auto& s) -> EmitterShape { return make_emitter(s, matrix, normal); },
                          light.shape),
      .radiance = {cast<float>(light.radiance), add_spectrum(colours, light.spectrum)},
      .reflectance = cast<float>(light.reflectance),
      .ies = light.ies,
      .ies_axes = {},
      .centre = cast<float>(transform_point(matrix, {}))};
  const Mat4 ies_to_world = light.ies ? matrix * light.ies->matrix : matrix;
  const std::array axes{Vec3d{1, 0, 0}, Vec3d{0, 1, 0}, Vec3d{0, 0, 1}};
  for (std::size_t i = 0; i < 3; ++i)
    out.ies_axes[i] = cast<float>(normalised(transform_direction(ies_to_world, axes[i])));
  return out;
}

// All that light may fall on. Where nothing is drawn, a directional light must still come from somewhere.
scene::WorldBounds lit_bounds(const scene::Scene& scene) {
  const auto around = [](Vec3d p) { return scene::WorldBounds{p, p}; };
  auto bounds = around(scene.camera.position_m);
  if (scene.camera.end) bounds = joined(bounds, around(scene.camera.end->position_m));
  const auto drawn = rough_bounds(scene);
  return drawn ? joined(bounds, *drawn) : bounds;
}

// The light behind all others.
void add_environment_map(const scene::Scene& scene, Vec3d origin, World& world) {
  const scene::EnvironmentMap& map = *scene.environment.map;
  world.environment_map = make_environment_map(nth(world.textures, map.texture), map.matrix);
  const scene::WorldBounds lit = lit_bounds(scene);
  world.environment_light = static_cast<int>(world.lights.size());
  world.lights.push_back(
      {.shape = make_emitter(*world.environment_map, (lit.low + lit.high) * 0.5 - origin, radius_of(lit)),
       .radiance = {cast<float>(scene.environment.radiance)},
       .reflectance = {},
       .ies = {},
       .ies_axes = {},
       .centre = {}});
}

float mean_share(const scene::IesProfile& profile) {
  double sum = 0;
  for (const double value : profile.candela) sum += value;
  return static_cast<float>(sum / static_cast<double>(profile.candela.size()) / profile.max_candela);
}

float luminance(Vec3f rgb) { return static_cast<float>(image::luminance(rgb.x, rgb.y, rgb.z)); }

// Determines the selection probability of a light, never its radiance. With fluorescence, invisible light
// counts as well, so the whole range is integrated instead of the luminance.
float brightness(const World& world, const Radiance& radiance) {
  const bool can_change = scene::covers(world.transport, scene::LightTransport::Bispectral);
  if (radiance.spectrum < 0 || !can_change) return luminance(radiance.rgb);
  const auto& spectrum = nth(world.spectra, radiance.spectrum);
  const auto one = spectra::constant(1);
  constexpr double kFrom = spectra::kShortestLight_nm;
  constexpr double kTo = spectra::kLongestSeen_nm;
  return static_cast<float>(spectra::integral_of_product(spectrum, one, one, kFrom, kTo) / (kTo - kFrom));
}

float power_of(const World& world, const AreaLight& light) {
  return area_of(light.shape) * brightness(world, light.radiance) *
         (light.ies ? mean_share(*light.ies->profile) : 1.0F);
}

float mean_brightness(const World& world, const EmissionMaterial& material) {
  const auto& [colour, texture, uv] = material.radiance;
  if (texture < 0) return brightness(world, {colour.rgb, colour.spectrum});
  return luminance(colour.rgb * nth(world.textures, texture).average);
}

void add_emissive_triangles(const World& world,
                            RenderObject& object,
                            std::vector<float>& powers,
                            std::vector<TriangleEmitter>& out) {
  const TriangleMesh& mesh = world.meshes[object.mesh];
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const int material = nth(object.material_of, mesh.materials[i]);
    const auto* emission = std::get_if<EmissionMaterial>(&nth(world.materials, material).model);
    if (emission == nullptr) continue;
    std::array<Vec3f, 3> p;
    std::array<Vec2f, 3> uv;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3f local = mesh.positions[mesh.triangles[i][k]];
      p[k] = object.kind == ObjectKind::InstancedMesh ? apply_to_point(object.to_world, local) : local;
      uv[k] = apply(emission->radiance.uv, uvs_of(mesh, emission->radiance.uv.set)[mesh.triangles[i][k]]);
    }
    const Vec3f normal = cross(p[1] - p[0], p[2] - p[0]);
    const float area = 0.5F * length(normal);
    const float power = area * mean_brightness(world, *emission);
    if (!(power > 0)) continue;  // a degenerate or black triangle; rays that hit it still see its emission
    if (object.emitters.empty()) object.emitters.assign(mesh.triangles.size(), -1);
    object.emitters[i] = static_cast<int>(powers.size());
    powers.push_back(power);
    out.push_back({p[0], p[1] - p[0], p[2] - p[0], normalised(normal), area, uv, material});
  }
}

// Of one radiance only: a random point has no texture coordinates.
void add_glowing_plugin_shape(const World& world,
                              RenderObject& object,
                              std::vector<float>& powers,
                              std::vector<PluginEmitter>& out) {
  const PluginShape& shape = world.plugin_shapes[object.plugin_shape];
  const auto* emission = std::get_if<EmissionMaterial>(&nth(world.materials, shape.material).model);
  if (emission == nullptr || emission->radiance.texture >= 0 || !can_be_sampled(shape)) return;
  const float area = sampled_area(shape);
  const float power = area * mean_brightness(world, *emission);
  if (!(power > 0)) return;
  object.emitters = {static_cast<int>(powers.size())};
  powers.push_back(power);
  out.push_back({object.plugin_shape, area});
}

// The power of a finite emitter says how much it lights at a distance that is not known here; parallel light
// lights the same everywhere, and the square of the radius of all that it may fall on, a vast floor say,
// would leave next to no samples for lamps nearby. Both get half of the samples.
void balance_parallel_light(const World& world, std::vector<float>& powers) {
  float parallel = 0;
  float finite = 0;
  const auto is_parallel = [&](std::size_t i) {
    return i < world.lights.size() && (std::holds_alternative<DirectionalEmitter>(world.lights[i].shape) ||
                                       std::holds_alternative<EnvironmentEmitter>(world.lights[i].shape));
  };
  for (std::size_t i = 0; i < powers.size(); ++i) (is_parallel(i) ? parallel : finite) += powers[i];
  if (!(parallel > 0 && finite > 0)) return;
  for (std::size_t i = 0; i < powers.size(); ++i)
    if (is_parallel(i)) powers[i] *= finite / parallel;
}

}  // namespace

void add_lights(const scene::Scene& scene,
                Vec3d origin,
                const SceneColours& colours,
                const std::vector<bool>& is_vast,
                World& world) {
  for (const auto& light : scene.lights) {
    RenderObject object;
    object.kind = ObjectKind::Light;
    object.light = world.lights.size();
    world.lights.push_back(prepare_light(light, origin, colours));
    AreaLight& prepared = world.lights.back();
    prepared.is_vast = is_vast[object.light];
    if (auto* directional = std::get_if<DirectionalEmitter>(&prepared.shape)) {
      const scene::WorldBounds lit = lit_bounds(scene);
      set_lit_sphere(*directional, (lit.low + lit.high) * 0.5 - origin, radius_of(lit));
    }
    if (has_area(prepared.shape))
      world.objects.push_back(std::move(object));
    else
      world.has_lights_without_area = true;
  }
  if (scene.environment.map) add_environment_map(scene, origin, world);
}

void build_emitters(World& world, LightSelection selection) {
  std::vector<float> powers;
  SurfaceEmitters surfaces;
  for (const AreaLight& light : world.lights) powers.push_back(power_of(world, light));
  std::vector<EmitterGroup> groups;
  for (std::size_t i = 0; i < world.lights.size(); ++i) groups.push_back({i, 1});
  for (RenderObject& object : world.objects) {
    if (object.kind != ObjectKind::WorldMesh && object.kind != ObjectKind::InstancedMesh) continue;
    const std::size_t first = powers.size();
    add_emissive_triangles(world, object, powers, surfaces.triangles);
    if (powers.size() > first) groups.push_back({first, powers.size() - first});
  }
  auto bounds = bounds_of(world.lights, surfaces.triangles, powers);
  for (RenderObject& object : world.objects) {
    if (object.kind != ObjectKind::PluginShape) continue;
    add_glowing_plugin_shape(world, object, powers, surfaces.plugin_shapes);
    if (object.emitters.empty()) continue;
    groups.push_back({powers.size() - 1, 1});
    bounds.push_back(light_bounds_of(world.plugin_shapes[object.plugin_shape], powers.back()));
  }
  if (selection == LightSelection::Bvh) world.light_bvh = LightBvh(bounds, groups);
  balance_parallel_light(world, powers);
  world.emitters.build(powers, std::move(surfaces), world.lights.size());
}

}  // namespace orbs::tracer
