// Light sampling and light paths start where they say: chi-square tests of whole samples, with the choice of
// the emitter, on rectangles, disks, balls and triangles.
#include "property/hashed_numbers.h"
#include "property/sampling_density.h"
#include "tracer/integrator/light_emission.h"
#include "tracer/integrator/light_sampling.h"
#include "tracer/sampling/warps.h"
#include "unit/tracer/scenes.h"

#include <optional>

namespace {

using namespace orbs;
using namespace orbs::tracer;
using tests::Cell;
using tests::chi_square;
using tests::expect_density;
using tests::four_uniform;
using tests::kTrials;
using tests::LogPolarMap;

constexpr double kPiHere = std::numbers::pi;

// Three lights and three triangles of two meshes, whose powers are of one order. A black floor and a black
// ball: what there is to light does not matter.
World lamps(LightSelection selection) {
  return make_world(scene::load_scene_text("test.json", tests::scene_text("[0, 0, 5]", "[0, 0, 0]", 8, 2, R"(
    "materials": [{"name": "black", "type": "lambert", "reflectance": [0, 0, 0]},
                  {"name": "glow", "type": "emission", "radiance": [2, 2, 2]}],
    "meshes": [{"name": "floor", "generator": "plane", "half_size": 4, "material": "black"},
               {"name": "card", "generator": "plane", "half_size": 0.6, "material": "glow"},
               {"name": "shard", "positions": [0, 0, 0, 1.1, 0.2, 0, 0.3, 0.4, 0.9],
                "normals": [0, -1, 0, 0, -1, 0, 0, -1, 0], "triangles": [0, 1, 2], "material": "glow"}],
    "instances": [{"mesh": "floor"},
                  {"mesh": "card", "matrix": [{"translate": [2, 1, 0]}, {"rotate_z": 50}]},
                  {"mesh": "shard", "matrix": [{"translate": [-1, 1.5, 1]}]}],
    "lights": [{"type": "rect", "half_width": 0.5, "half_length": 0.25, "radiance": [4, 4, 4],
                "matrix": [{"translate": [0, 1.5, 0]}, {"rotate_x": 20}]},
               {"type": "disk", "radius": 0.4, "radiance": [5, 5, 5],
                "matrix": [{"translate": [1, 2, -1]}, {"rotate_z": -30}, {"scale": [1, 1, 0.5]}]},
               {"type": "sphere", "radius": 0.3, "radiance": [2, 2, 2],
                "matrix": [{"translate": [-2, 1, 0]}]}])"),
                                           ORBS_SOURCE_DIR),
                    {.light_selection = selection});
}

// A flat emitter with coordinates in which equal areas are equal.
struct Patch {
  enum class Kind { Rect, Disk, Triangle };
  Kind kind = Kind::Rect;
  Vec3d origin;
  Vec3d a;
  Vec3d b;
  Vec3d normal;
  bool is_two_sided = false;
};

std::optional<Patch> patch_of(const World& world, std::size_t emitter) {
  if (emitter >= world.emitters.light_count()) {
    const TriangleEmitter& t = world.emitters.triangle(emitter);
    return Patch{Patch::Kind::Triangle, cast<double>(t.corner), cast<double>(t.edge1),
                 cast<double>(t.edge2), cast<double>(t.normal), true};
  }
  const EmitterShape& shape = world.lights[emitter].shape;
  if (const auto* rect = std::get_if<RectEmitter>(&shape))
    return Patch{Patch::Kind::Rect, rect->centre, rect->a, rect->b, rect->normal};
  if (const auto* disk = std::get_if<DiskEmitter>(&shape))
    return Patch{Patch::Kind::Disk, disk->centre, disk->a, disk->b, disk->normal};
  return std::nullopt;
}

Cell domain_of(const Patch& patch) {
  if (patch.kind == Patch::Kind::Rect) return {{-1, -1}, {1, 1}};
  if (patch.kind == Patch::Kind::Disk) return {{0, -kPiHere}, {1, kPiHere}};
  return {{0, 0}, {1, 1}};
}

double area_per_place(const Patch& patch) {
  return length(cross(patch.a, patch.b)) * (patch.kind == Patch::Kind::Rect ? 1 : 0.5);
}

Vec3d point_at(const Patch& patch, Vec2d place) {
  if (patch.kind == Patch::Kind::Rect) return patch.origin + patch.a * place.x + patch.b * place.y;
  const double root = std::sqrt(place.x);
  if (patch.kind == Patch::Kind::Triangle)
    return patch.origin + patch.a * (root * (1 - place.y)) + patch.b * (root * place.y);
  return patch.origin + patch.a * (root * std::cos(place.y)) + patch.b * (root * std::sin(place.y));
}

// Points that rounding has moved past the edge are inside.
Vec2d place_of(const Patch& patch, Vec3d point) {
  const Vec3d across = cross(patch.a, patch.b);
  const Vec3d from_origin = point - patch.origin;
  const double s = dot(cross(from_origin, patch.b), across) / dot(across, across);
  const double t = dot(cross(patch.a, from_origin), across) / dot(across, across);
  Vec2d place{s, t};
  if (patch.kind == Patch::Kind::Disk) place = {s * s + t * t, std::atan2(t, s)};
  if (patch.kind == Patch::Kind::Triangle) place = {(s + t) * (s + t), s + t > 0 ? t / (s + t) : 0};
  const Cell domain = domain_of(patch);
  constexpr double kInside = 1e-12;
  return {std::clamp(place.x, domain.low.x, domain.high.x - kInside),
          std::clamp(place.y, domain.low.y, domain.high.y - kInside)};
}

// Of the light samples for a point, those on each flat emitter by their place, against light_pdf. Emitters
// that are selected too rarely for cells are left to the tests of picks.
void expect_light_samples(const World& world, const LightSampleContext& at, const std::string& name) {
  std::vector<std::vector<Vec3d>> found(world.emitters.size());
  for (std::uint64_t i = 0; i < kTrials; ++i) {
    const auto u = four_uniform(i);
    if (const auto light = sample_light(world, at, with_more_digits(u[0], u[3]), u[1], u[2]))
      found[light->emitter].push_back(cast<double>(light->position));
  }
  const Vec3d from = cast<double>(at.position);
  for (std::size_t k = 0; k < world.emitters.size(); ++k) {
    const auto patch = patch_of(world, k);
    if (!patch || selection_probability(world, at, k) < 0.05F) continue;
    if (!patch->is_two_sided && dot(patch->normal, from - patch->origin) <= 0) continue;
    std::vector<Vec2d> places;
    for (const Vec3d point : found[k]) places.push_back(place_of(*patch, point));
    const auto density = [&](Vec2d place) {
      const Vec3d point = point_at(*patch, place);
      const Vec3d d = point - from;
      const double cosine_by_d2 = std::abs(dot(patch->normal, d)) / (dot(d, d) * length(d));
      return light_pdf(world, at, k, cast<float>(point)) * cosine_by_d2 * area_per_place(*patch);
    };
    expect_density(chi_square(places, kTrials, domain_of(*patch), density),
                   name + ", emitter " + std::to_string(k));
  }
}

}  // namespace

TEST(LightDensity, OfLightSamplesOnAllFlatEmitters) {
  for (const auto selection : {LightSelection::Power, LightSelection::Bvh}) {
    const World world = lamps(selection);
    ASSERT_EQ(world.emitters.size(), 6U);
    for (const LightSampleContext& at :
         {LightSampleContext{{0, 0, 0}, {0, 1, 0}}, LightSampleContext{{0.9F, 0.3F, -0.4F}, {0, 1, 0}},
          LightSampleContext{{-0.8F, 1, 1.2F}, {}}, LightSampleContext{{3, 3, 3}, {}}})
      expect_light_samples(world, at,
                           "from " + std::to_string(at.position.x) +
                               (selection == LightSelection::Bvh ? " by the tree" : " by power"));
  }
}

namespace {

using Emit = EmittedRay (*)(const World&, const std::array<float, 4>&, const std::array<float, 4>&);

// Light paths by where they start: on the side of the normal of flat emitters, all over balls.
void expect_starts(const World& world, Emit emitted_by, const std::string& name) {
  std::vector<std::vector<Vec3d>> found(world.emitters.size());
  for (std::uint64_t i = 0; i < kTrials; ++i) {
    const EmittedRay ray = emitted_by(world, four_uniform(2 * i), four_uniform(2 * i + 1));
    const auto patch = patch_of(world, ray.emitter);
    const Vec3d off = cast<double>(ray.ray.origin - ray.position);
    if (patch && dot(patch->normal, off) < 0) continue;
    found[ray.emitter].push_back(cast<double>(ray.position));
  }
  const auto density_at = [&](std::size_t emitter, Vec3d point, Vec3d normal) {
    return emission_pdf(world, emitter, cast<float>(point), cast<float>(point + normal));
  };
  for (std::size_t k = 0; k < world.emitters.size(); ++k) {
    std::vector<Vec2d> places;
    const auto what = name + ", emitter " + std::to_string(k);
    if (const auto patch = patch_of(world, k)) {
      for (const Vec3d point : found[k]) places.push_back(place_of(*patch, point));
      expect_density(chi_square(places, kTrials, domain_of(*patch),
                                [&](Vec2d place) {
                                  return density_at(k, point_at(*patch, place), patch->normal) *
                                         area_per_place(*patch);
                                }),
                     what);
      continue;
    }
    const auto& ball = std::get<SphereEmitter>(world.lights[k].shape);
    const double radius = length(ball.axes[0]);
    const LogPolarMap map({0, 1, 0});
    for (const Vec3d point : found[k]) places.push_back(map.point_of(point - ball.centre));
    expect_density(chi_square(places, kTrials, map.domain(),
                              [&](Vec2d place) {
                                const Vec3d normal = map.direction_of(place);
                                return density_at(k, ball.centre + normal * radius, normal) * radius *
                                       radius * LogPolarMap::solid_angle_per_area(place);
                              }),
                   what);
  }
}

}  // namespace

TEST(LightDensity, OfTheStartsOfLightPaths) {
  World world = lamps(LightSelection::Power);
  world.caustic_casters = {{{0, -3, 0}, 0.5F}, {{1, 0.2F, 1}, 0.3F}};
  expect_starts(world, emit, "towards casters");
  expect_starts(world, emit_towards_use, "towards use");
}

// The lamp is so small that all its points see the guide's target alike.
TEST(LightDensity, OfTheDirectionsOfLightPaths) {
  World world =
      make_world(scene::load_scene_text("test.json", tests::scene_text("[0, 0, 5]", "[0, 0, 0]", 8, 2, R"(
        "materials": [{"name": "black", "type": "lambert", "reflectance": [0, 0, 0]}],
        "meshes": [{"name": "floor", "generator": "plane", "half_size": 4, "material": "black"}],
        "instances": [{"mesh": "floor"}],
        "lights": [{"type": "rect", "half_width": 1e-5, "half_length": 1e-5, "radiance": [1, 1, 1],
                    "matrix": [{"translate": [0, 1, 0]}]}])"),
                                        ORBS_SOURCE_DIR));
  const auto position = cast<float>(std::get<RectEmitter>(world.lights[0].shape).centre);
  const float pdf_of_place = emission_pdf(world, 0, position, position - Vec3f{0, 1, 0});
  for (const float radius : {0.0F, 0.05F, 0.6F, 3.0F}) {
    const Vec3f target{0.5F, -0.4F, 0.3F};
    if (radius > 0) world.light_guides = {{0, {target + position, radius}, 1 - kUnguidedShare}};
    const LogPolarMap map(radius > 0 ? cast<double>(target) : Vec3d{0, -1, 0});
    std::vector<Vec2d> places;
    for (std::uint64_t i = 0; i < kTrials; ++i) {
      const auto ray = emit_towards_use(world, four_uniform(2 * i), four_uniform(2 * i + 1));
      if (ray.weight > 0) places.push_back(map.point_of(cast<double>(ray.ray.direction)));
    }
    const auto density = [&](Vec2d place) {
      const Vec3d direction = map.direction_of(place);
      if (!(direction.y < 0)) return 0.0;
      const float pdf = emission_pdf(world, 0, position, position + cast<float>(direction));
      return pdf / pdf_of_place * -direction.y / kPiHere * LogPolarMap::solid_angle_per_area(place);
    };
    expect_density(chi_square(places, kTrials, map.domain(), density),
                   "guide of radius " + std::to_string(radius));
  }
}
