#include "tracer/world/world.h"

#include "base/error.h"
#include "image/colour.h"
#include "scene/camera_frame.h"
#include "tracer/geometry/frame.h"
#include "tracer/world/materials.h"
#include "tracer/sampling/warps.h"
#include "tracer/world/surface.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace orbs::tracer {

namespace {

// The zero of the world's coordinates. Floats are as coarse as 1 m at 10^7 m from theirs, so it lies near the
// camera: where scenes have it, or whole steps from there, which doubles subtract exactly. Half a step away a
// float tells 8e-6 m.
Vec3d origin_near(const scene::Camera& camera) {
  constexpr double kStep_m = 256;
  const auto nearest = [](double m) { return kStep_m * std::round(m / kStep_m); };
  return {nearest(camera.position_m.x), nearest(camera.position_m.y), nearest(camera.position_m.z)};
}

Mat4 seen_from(Mat4 matrix, Vec3d origin) {
  matrix(0, 3) -= origin.x;
  matrix(1, 3) -= origin.y;
  matrix(2, 3) -= origin.z;
  return matrix;
}

PinholeCamera prepare_camera(const scene::Camera& camera, Vec3d origin) {
  const auto frame = scene::camera_frame(camera);
  return {cast<float>(camera.position_m - origin),
          cast<float>(frame.forward),
          cast<float>(frame.right * frame.half_width),
          cast<float>(frame.up * frame.half_height),
          camera.width_px,
          camera.height_px};
}

TriangleMesh copy_mesh(const scene::Mesh& mesh, const Mat4& matrix) {
  TriangleMesh out{mesh.positions, mesh.normals, mesh.uvs, mesh.triangles, mesh.triangle_materials, {}};
  if (matrix == Mat4{}) {
    for (Vec3f& n : out.normals) n = normalised(n);
    return out;
  }
  const Mat4 back = inverse(matrix).value();  // the loader refuses singular matrices
  for (Vec3f& p : out.positions) p = cast<float>(transform_point(matrix, cast<double>(p)));
  for (Vec3f& n : out.normals) n = cast<float>(normalised(transform_normal(back, cast<double>(n))));
  return out;
}

Affine affine(const Mat4& m) {
  Affine out;
  for (std::size_t c = 0; c < 3; ++c) out.axes[c] = cast<float>(Vec3d{m(0, c), m(1, c), m(2, c)});
  out.offset = cast<float>(Vec3d{m(0, 3), m(1, 3), m(2, 3)});
  return out;
}

// Columns of the inverse transpose.
Affine normal_map(const Mat4& matrix) {
  const Mat4 back = inverse(matrix).value();
  Affine out;
  for (std::size_t c = 0; c < 3; ++c) out.axes[c] = cast<float>(Vec3d{back(c, 0), back(c, 1), back(c, 2)});
  return out;
}

void add_meshes(const scene::Scene& scene, Vec3d origin, const WorldSettings& settings, World& world) {
  std::vector<int> uses(scene.meshes.size(), 0);
  std::size_t copied = 0;
  for (const auto& instance : scene.instances) {
    ++uses[static_cast<std::size_t>(instance.mesh)];
    copied += scene.meshes[static_cast<std::size_t>(instance.mesh)].triangles.size();
  }
  std::vector<std::size_t> shared(scene.meshes.size(), kNoHit);
  for (const auto& instance : scene.instances) {
    const auto index = static_cast<std::size_t>(instance.mesh);
    const Mat4 matrix = seen_from(instance.matrix, origin);
    RenderObject object;
    for (int m = 0; m < static_cast<int>(scene.materials.size()); ++m)
      object.material_of.push_back(scene::remapped(instance, m));
    if (copied <= settings.most_copied_triangles || uses[index] == 1) {
      object.mesh = world.meshes.size();
      world.meshes.push_back(copy_mesh(scene.meshes[index], matrix));
    } else {
      if (shared[index] == kNoHit) {
        shared[index] = world.meshes.size();
        world.meshes.push_back(copy_mesh(scene.meshes[index], Mat4{}));
      }
      object.kind = ObjectKind::InstancedMesh;
      object.mesh = shared[index];
      object.to_world = affine(matrix);
      object.normal_to_world = normal_map(matrix);
    }
    world.objects.push_back(std::move(object));
  }
}

Vec3f direction_of(const Mat4& m, Vec3d v) { return cast<float>(transform_direction(m, v)); }

EmitterShape prepare_shape(const scene::RectShape& s, const Mat4& m, Vec3f normal) {
  RectEmitter out{.centre = cast<float>(transform_point(m, {})),
                  .a = direction_of(m, {s.half_width_m, 0, 0}),
                  .b = direction_of(m, {0, 0, s.half_length_m}),
                  .normal = normal};
  out.area = 4 * length(cross(out.a, out.b));
  out.is_orthogonal = std::abs(dot(out.a, out.b)) <= 1e-5F * length(out.a) * length(out.b);
  return out;
}

EmitterShape prepare_shape(const scene::DiskShape& s, const Mat4& m, Vec3f normal) {
  DiskEmitter out{.centre = cast<float>(transform_point(m, {})),
                  .a = direction_of(m, {s.radius_m, 0, 0}),
                  .b = direction_of(m, {0, 0, s.radius_m}),
                  .normal = normal};
  out.area = kPi * length(cross(out.a, out.b));
  return out;
}

EmitterShape prepare_shape(const scene::SphereShape& s, const Mat4& m, Vec3f) {
  const Mat4 map = m * scaling({s.radius_m, s.radius_m, s.radius_m});
  const Mat4 back = inverse(map).value();
  SphereEmitter out{.centre = cast<float>(transform_point(m, {})), .axes = affine(map).axes};
  for (std::size_t r = 0; r < 3; ++r) out.inverse[r] = cast<float>(Vec3d{back(r, 0), back(r, 1), back(r, 2)});
  out.determinant = static_cast<float>(std::abs(determinant3(map)));
  out.area = 4 * kPi * std::pow(out.determinant, 2.0F / 3.0F);
  return out;
}

AreaLight prepare_light(const scene::Scene& scene, const scene::Light& light, Vec3d origin, World& world) {
  const Mat4 matrix = seen_from(light.matrix, origin);
  const Mat4 back = inverse(matrix).value();
  const Vec3f normal = cast<float>(normalised(transform_normal(back, {0, -1, 0})));
  AreaLight out{
      .shape = std::visit([&](const auto& s) { return prepare_shape(s, matrix, normal); }, light.shape),
      .radiance = {cast<float>(light.radiance), add_spectrum(scene, light.spectrum, world)},
      .reflectance = cast<float>(light.reflectance),
      .ies = light.ies,
      .ies_axes = {},
      .centre = cast<float>(transform_point(matrix, {}))};
  const Mat4 turned = light.ies ? matrix * light.ies->matrix : matrix;
  const std::array axes{Vec3d{1, 0, 0}, Vec3d{0, 1, 0}, Vec3d{0, 0, 1}};
  for (std::size_t i = 0; i < 3; ++i)
    out.ies_axes[i] = cast<float>(normalised(transform_direction(turned, axes[i])));
  return out;
}

float mean_share(const scene::IesProfile& profile) {
  double sum = 0;
  for (const double value : profile.candela) sum += value;
  return static_cast<float>(sum / static_cast<double>(profile.candela.size()) / profile.max_candela);
}

float luminance(Vec3f rgb) { return static_cast<float>(image::luminance(rgb.x, rgb.y, rgb.z)); }

// Steers only how often a light is chosen, never what it gives. Where light can become visible on its way,
// what the eye makes of it is no measure.
float brightness(const World& world, const Radiance& radiance) {
  const bool can_change = scene::covers(world.transport, scene::LightTransport::Bispectral);
  if (radiance.spectrum < 0 || !can_change) return luminance(radiance.rgb);
  const auto& spectrum = world.spectra[static_cast<std::size_t>(radiance.spectrum)];
  const auto one = spectra::constant(1);
  constexpr double kFrom = spectra::kShortestLight_nm;
  constexpr double kTo = spectra::kLongestSeen_nm;
  return static_cast<float>(spectra::integral_of_product(spectrum, one, one, kFrom, kTo) / (kTo - kFrom));
}

float power_of(const World& world, const AreaLight& light) {
  const float area = std::visit([](const auto& s) { return s.area; }, light.shape);
  return area * brightness(world, light.radiance) * (light.ies ? mean_share(*light.ies->profile) : 1.0F);
}

float mean_brightness(const World& world, const SurfaceMaterial& material) {
  const Colour& colour = material.colour;
  if (material.texture < 0) return brightness(world, {colour.rgb, colour.spectrum});
  return luminance(colour.rgb * world.textures[static_cast<std::size_t>(material.texture)].average);
}

void add_emissive_triangles(const World& world,
                            const RenderObject& object,
                            std::vector<float>& powers,
                            std::vector<TriangleEmitter>& out) {
  const TriangleMesh& mesh = world.meshes[object.mesh];
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const int material = object.material_of[static_cast<std::size_t>(mesh.materials[i])];
    const SurfaceMaterial& m = world.materials[static_cast<std::size_t>(material)];
    if (m.model != Model::Emission) continue;
    std::array<Vec3f, 3> p;
    std::array<Vec2f, 3> uv;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3f local = mesh.positions[mesh.triangles[i][k]];
      p[k] = object.kind == ObjectKind::InstancedMesh ? apply_to_point(object.to_world, local) : local;
      uv[k] = apply(m.uv, mesh.uvs[mesh.triangles[i][k]]);
    }
    const Vec3f normal = cross(p[1] - p[0], p[2] - p[0]);
    const float area = 0.5F * length(normal);
    const float power = area * mean_brightness(world, m);
    if (!(power > 0)) continue;  // a sliver, or black: rays that hit it by chance still see its emission
    powers.push_back(power);
    out.push_back({p[0], p[1] - p[0], p[2] - p[0], normalised(normal), area, uv, material});
  }
}

void build_emitters(World& world) {
  std::vector<float> powers;
  std::vector<TriangleEmitter> triangles;
  for (const AreaLight& light : world.lights) powers.push_back(power_of(world, light));
  for (const RenderObject& object : world.objects)
    if (object.kind == ObjectKind::WorldMesh || object.kind == ObjectKind::InstancedMesh)
      add_emissive_triangles(world, object, powers, triangles);
  double total = 0;
  for (const float power : powers) total += power;
  for (SurfaceMaterial& m : world.materials) {
    if (m.model == Model::Emission && total > 0)
      m.emitter_pdf_per_area = static_cast<float>(mean_brightness(world, m) / total);
  }
  world.emitters.build(powers, std::move(triangles), world.lights.size());
}

void add_spheres(const scene::Scene& scene, Vec3d origin, World& world) {
  for (const auto& sphere : scene.spheres) {
    RenderObject object;
    object.kind = ObjectKind::Sphere;
    object.sphere = world.spheres.size();
    world.spheres.push_back(
        {cast<float>(sphere.centre_m - origin), static_cast<float>(sphere.radius_m), sphere.material});
    world.objects.push_back(std::move(object));
  }
}

void add_lights(const scene::Scene& scene, Vec3d origin, World& world) {
  for (const auto& light : scene.lights) {
    RenderObject object;
    object.kind = ObjectKind::Light;
    object.light = world.lights.size();
    world.lights.push_back(prepare_light(scene, light, origin, world));
    world.objects.push_back(std::move(object));
  }
}

// The transport that is asked for must have every effect of the scene's own.
scene::LightTransport checked_transport(const scene::Scene& scene, const WorldSettings& settings) {
  const auto& asked = settings.transport;
  const auto found = scene::effects(scene);
  const auto needed = scene::transport(found);
  if (!asked || *asked == needed) return needed;
  if (settings.may_lose_effects || scene::covers(*asked, needed)) return *asked;
  throw InputError(fmt::format("scene '{}' calls for {} transport{}, which {} transport does not have",
                               scene.name, scene::transport_name(needed), scene::reason_for(found),
                               scene::transport_name(*asked)));
}

// Light paths end at lights, keep their wavelengths, and multiply no matrices from the other side: they are
// of no use where lights reflect, surfaces fluoresce, or polarisation counts.
bool has_use_for_light_paths(const World& world) {
  const bool is_polarised = scene::covers(world.transport, scene::LightTransport::Polarised);
  const bool lights_reflect = std::any_of(world.lights.begin(), world.lights.end(),
                                          [](const auto& light) { return !(light.reflectance == Vec3f{}); });
  return !is_polarised && !lights_reflect && world.reradiations.empty() && !world.emitters.empty();
}

}  // namespace

World make_world(const scene::Scene& scene, const WorldSettings& settings) {
  World world;
  world.transport = checked_transport(scene, settings);
  const Vec3d origin = origin_near(scene.camera);
  world.camera = prepare_camera(scene.camera, origin);
  world.wants_stokes =
      scene.outputs.stokes && scene::covers(world.transport, scene::LightTransport::Polarised);
  world.environment = {cast<float>(scene.environment),
                       add_spectrum(scene, scene.environment_spectrum, world)};
  world.trace_depth = scene.trace_depth;
  for (const auto& texture : scene.textures) world.textures.push_back(load_texels(texture));
  add_materials(scene, world);
  add_meshes(scene, origin, settings, world);
  add_spheres(scene, origin, world);
  add_lights(scene, origin, world);
  build_emitters(world);
  for (TriangleMesh& mesh : world.meshes) fill_triangle_cache(mesh);
  if (settings.mirrored_light) find_mirror_planes(world);
  if (settings.light_paths && has_use_for_light_paths(world)) world.caustic_casters = find_caustic_casters(world);
  world.accel = std::make_unique<Accel>(world);
  return world;
}

Ray camera_ray(const PinholeCamera& camera, float x, float y) {
  const float sx = 2 * x / static_cast<float>(camera.width) - 1;
  const float sy = 1 - 2 * y / static_cast<float>(camera.height);
  return {camera.position, normalised(camera.forward + camera.right * sx + camera.up * sy)};
}

}  // namespace orbs::tracer
