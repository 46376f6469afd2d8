#include "scene/load/generator.h"

#include "scene/geometry/generators.h"

#include <fmt/format.h>

namespace orbs::scene {

namespace {

constexpr int kMostSegments = 4096;

TreeParameters load_tree(json::ObjectReader& in) {
  return {in.number("height", kLength), in.number("radius", kLength), in.integer("tiers", 1, 100),
          in.integer("points", 3, 100)};
}

WaterParameters load_water(json::ObjectReader& in) {
  return {in.number("half_width", kLength), in.number("half_length", kLength),
          in.number("depth", kLength),      in.number("amplitude", kLength),
          in.number("wavelength", kLength), in.integer("segments", 1, kMostSegments)};
}

SphereParameters load_sphere(json::ObjectReader& in) {
  return {in.number("radius", kLength), in.integer("segments", 3, kMostSegments)};
}

TorusParameters load_torus(json::ObjectReader& in) {
  return {in.number("minor_radius", kLength), in.number("major_radius", kLength),
          in.integer("ring_segments", 3, kMostSegments), in.integer("tube_segments", 3, kMostSegments)};
}

}  // namespace

Mesh load_generated(json::ObjectReader& in, SceneBudget& left) {
  const std::string kind =
      in.one_of("generator", {"plane", "cube", "cube_open", "sphere", "torus", "teapot", "tree", "water"});
  // A few bytes of text can ask for millions of triangles, so they are counted before they are made.
  const auto made = [&](const auto& parameters, auto make) {
    spend(in, "generator", "triangles", triangle_count(parameters), left.triangles);
    try {
      return make(parameters);
    } catch (const InputError& e) {
      in.fail("generator", e.what());
    }
  };
  if (kind == "plane") return made(PlaneParameters{in.number("half_size", kLength)}, make_plane);
  if (kind == "cube") return made(CubeParameters{in.number("half_size", kLength)}, make_cube);
  if (kind == "cube_open") return made(CubeParameters{in.number("half_size", kLength)}, make_cube_open);
  if (kind == "sphere") return made(load_sphere(in), make_sphere);
  if (kind == "torus") return made(load_torus(in), make_torus);
  if (kind == "teapot") return made(TeapotParameters{in.integer("subdivisions", 1, 128)}, make_teapot);
  if (kind == "tree") return made(load_tree(in), make_tree);
  return made(load_water(in), make_water);
}

}  // namespace orbs::scene
