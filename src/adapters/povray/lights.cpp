#include "adapters/povray/lights.h"

#include "adapters/environment_image.h"
#include "adapters/kind_support.h"
#include "adapters/light_frame.h"
#include "adapters/povray/sdl.h"
#include "adapters/povray/settings.h"
#include "scene/geometry/world_bounds.h"
#include "scene/lights/placement.h"
#include "scene/scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace orbs::adapters::povray {

namespace {

// The error of the direct light falls with the square of (side of a panel / distance of the lit surface). The
// light of scene 103, 16 m wide and 13 m above the floor, came to -2.8 %, -0.7 % and -0.2 % with 2, 4 and 8
// panels a side; a fifth of the distance makes that 0.3 %, a third of the tolerance of the cases.
constexpr double kLargestPanel = 0.2;

// Distance from the light to the last vertex in front of it.
double reach_m(const scene::Scene& scene, const LightFrame& frame) {
  double reach = 0;
  for (const auto& instance : scene.instances)
    for (const auto& position : mesh_of(scene, instance).positions) {
      const Vec3d vertex{position.x, position.y, position.z};
      reach = std::max(reach, dot(transform_point(instance.matrix, vertex) - frame.centre, frame.facing));
    }
  return reach;
}

// How many panels a rectangular light is cut into along each side, each a separate light source: a power
// of two, at least settings.area_split, and at most a half of settings.area_grid, so that POV-Ray has four
// samples of each. POV-Ray takes the cosine at the light for the whole panel from its centre.
int panels_per_side(const scene::Scene& scene, const scene::Light& light, const PovraySettings& settings) {
  const auto* rect = std::get_if<scene::RectShape>(&light.shape);
  if (rect == nullptr) return 1;
  const LightFrame frame = light_frame(light.matrix);
  const double side_m =
      2 * std::max(rect->half_width_m * length(frame.u), rect->half_length_m * length(frame.v));
  const double largest_m = kLargestPanel * reach_m(scene, frame);
  int panels = settings.area_split;
  while (2 * panels <= settings.area_grid / 2 && largest_m > 0 && side_m / panels > largest_m) panels *= 2;
  return panels;
}

constexpr const char* kName = "POV-Ray";

// POV-Ray attenuates by 2 / (1 + (d/f)^2), f = fade_distance. For f far below all distances that is 2 f^2 /
// d^2.
constexpr double kFadePerSize = 1e-5;
// Of a light without a size. The scene is a metre large at least (enlarged), and 0.1 m away the share (f/d)^2
// that is missing is 1e-6.
constexpr double kPointFade_m = 1e-4;
// Between the bright side and the black one behind it, in units of the light's local size.
constexpr double kGap = 1e-4;
// POV-Ray adds 0.001 to both coordinates of a circular grid, as shares of its axes, before it bends the grid
// into rings; on average over the disc asinh(1) of that remains.
constexpr double kCircularShift = 0.001 * 0.8814;

/// A flat piece of a light in world space: centre, two edge vectors (or conjugate diameters), and the
/// direction in which it faces.
struct Panel {
  Vec3d centre;
  Vec3d axis_u;
  Vec3d axis_v;
  Vec3d facing;
  double area_m2 = 0;
  bool is_round = false;
};

// A light source of colour C lights a Lambert surface to rho C (attenuation) cos; there is no 1/pi in
// POV-Ray's diffuse term. A panel of radiance L and area A has to give rho L A cos cos / (pi d^2): hence C =
// L A / (2 pi f^2). Samples: POV-Ray spans a grid edge to edge; (n-1)/n moves it to the centres of n x n
// cells.
std::string panel_light(const Panel& panel,
                        scene::RgbColour radiance,
                        int grid,
                        const PovraySettings& settings) {
  const double fade_m = kFadePerSize * std::sqrt(panel.area_m2);
  const scene::RgbColour intensity = radiance * (panel.area_m2 / (2 * std::numbers::pi * fade_m * fade_m));
  const double to_centres = static_cast<double>(grid - 1) / grid;
  const Vec3d axis_u = panel.axis_u * to_centres;
  const Vec3d axis_v = panel.axis_v * to_centres;
  const Vec3d centre = panel.is_round ? panel.centre - (axis_u + axis_v) * kCircularShift : panel.centre;
  return fmt::format(
      "light_source {{ {}, {}\n"
      "  spotlight point_at {} radius 90 falloff 90 tightness 1\n"
      "  area_light {}, {}, {}, {}{} area_illumination on adaptive {}\n"
      "  fade_distance {} fade_power 2{}\n"
      "}}\n",
      vector(centre), colour(intensity), vector(centre + panel.facing), vector(axis_u), vector(axis_v), grid,
      grid, panel.is_round ? " circular" : "", settings.area_adaptive, fade_m,
      settings.photons > 0 ? "\n  photons { reflection on refraction on area_light }" : "");
}

std::string rect_sources(const scene::Light& light,
                         const scene::RectShape& rect,
                         int split,
                         const PovraySettings& settings) {
  const LightFrame frame = light_frame(light.matrix);
  const double width_m = 2 * rect.half_width_m / split;
  const double length_m = 2 * rect.half_length_m / split;
  std::string text;
  for (int i = 0; i < split; ++i)
    for (int j = 0; j < split; ++j) {
      const Vec3d local{(i + 0.5) * width_m - rect.half_width_m, 0,
                        (j + 0.5) * length_m - rect.half_length_m};
      const Panel panel{transform_point(light.matrix, local), frame.u * width_m, frame.v * length_m,
                        frame.facing, width_m * length_m * frame.area_scale};
      text += panel_light(panel, light.radiance, settings.area_grid / split, settings);
    }
  return text;
}

// POV-Ray bends its square grid into rings, which crowds samples at the diagonals; a second source of half
// the power turned by 45 degrees evens that out up to the eightfold symmetry that remains.
std::string disk_sources(const scene::Light& light,
                         const scene::DiskShape& disk,
                         const PovraySettings& settings) {
  const LightFrame frame = light_frame(light.matrix);
  const double diameter_m = 2 * disk.radius_m;
  const double area_m2 = std::numbers::pi * disk.radius_m * disk.radius_m * frame.area_scale;
  const Vec3d u = frame.u * diameter_m;
  const Vec3d v = frame.v * diameter_m;
  const double turn = std::numbers::sqrt2 / 2;
  const Vec3d centre = transform_point(light.matrix, {});
  std::string text;
  for (const auto& [a, b] : std::array{std::pair{u, v}, std::pair{(u + v) * turn, (v - u) * turn}})
    text += panel_light({centre, a, b, frame.facing, area_m2, true}, light.radiance * 0.5, settings.area_grid,
                        settings);
  return text;
}

// Seen from outside, a sphere of radius r lights as a point at its centre does: E = pi L r^2 / d^2 cos while
// it is wholly above the horizon, hence C = L r^2 / (2 f^2). Its grid is a disc turned to the lit point, for
// the shadows alone. The source shines through its own body (projected_through), which stays an obstacle to
// all others.
std::string sphere_sources(const scene::Light& light,
                           const scene::SphereShape& sphere,
                           const PovraySettings& settings) {
  const double radius_m = sphere.radius_m * length(transform_direction(light.matrix, {1, 0, 0}));
  const double fade_m = kFadePerSize * radius_m;
  const scene::RgbColour intensity = light.radiance * (radius_m * radius_m / (2 * fade_m * fade_m));
  const Vec3d centre = transform_point(light.matrix, {});
  const int grid = settings.area_grid;
  const double size_m = 2 * radius_m * (grid - 1) / grid;
  return fmt::format(
      "light_source {{ {}, {}\n"
      "  area_light <{},0,0>, <0,{},0>, {}, {} circular orient adaptive {}\n"
      "  fade_distance {} fade_power 2\n"
      "  projected_through {{ sphere {{ {}, {} }} }}{}\n"
      "}}\n",
      vector(centre), colour(intensity), size_m, size_m, grid, grid, settings.area_adaptive, fade_m,
      vector(centre), radius_m * (1 + kGap),
      settings.photons > 0 ? "\n  photons { reflection on refraction on area_light }" : "");
}

std::string bright_finish(const scene::Light& light) {
  return fmt::format(
      "texture {{ pigment {{ {} }} finish {{ diffuse 0 emission 1 }} }} no_shadow no_radiosity photons "
      "{{ pass_through }}",
      colour(light.radiance));
}

constexpr const char* kBlack = "texture { pigment { rgb 0 } finish { diffuse 0 } }";

// The visible flat shape, and a black one a little behind it (towards local +Y). Seen from behind it is black
// as well, since past the edge of the other it shows as a bright line: 12 of a lamp in 1/500 of a pixel made
// a tile 5 % too bright.
std::string flat_body(const scene::Light& light, const std::string& shape, double size_m) {
  return fmt::format("object {{ {0} {1} interior_{4} {2} }}\nobject {{ {0} translate <0,{3},0> {4} {2} }}\n",
                     shape, bright_finish(light), matrix(light.matrix), kGap * size_m, kBlack);
}

// Photons are shot at what reflects and refracts.
std::string photons_text(const PovraySettings& settings) {
  return settings.photons > 0 ? "\n  photons { reflection on refraction on }" : "";
}

// A point of intensity I has to give rho I cos / (pi d^2), and of colour C it gives 2 rho C f^2 cos / d^2.
std::string point_source(const scene::Light& light, const std::string& cone, const PovraySettings& settings) {
  const double square = kPointFade_m * kPointFade_m;
  return fmt::format("light_source {{ {}, {}{}\n  fade_distance {} fade_power 2{}\n}}\n",
                     vector(transform_point(light.matrix, {})),
                     colour(light.radiance * (1 / (2 * std::numbers::pi * square))), cone, kPointFade_m,
                     photons_text(settings));
}

// It shines from a plane through its place on, which is put before everything.
std::string parallel_source(const scene::Scene& scene,
                            const scene::Light& light,
                            const PovraySettings& settings) {
  const Vec3d eye = scene.camera.position_m;
  const auto drawn = rough_bounds(scene);
  const auto bounds = drawn ? joined(*drawn, {eye, eye}) : scene::WorldBounds{eye, eye};
  const Vec3d middle = (bounds.low + bounds.high) * 0.5;
  const Vec3d place = middle - shining_direction(light.matrix) * (2 * radius_of(bounds) + 1);
  return fmt::format("light_source {{ {}, {}\n  parallel point_at {}{}\n}}\n", vector(place),
                     colour(light.radiance * (1 / std::numbers::pi)), vector(middle), photons_text(settings));
}

struct LightWriter {
  const scene::Scene& scene;
  const scene::Light& light;
  const PovraySettings& settings;

  std::string operator()(const scene::RectShape& rect) const {
    const double w = rect.half_width_m;
    const double l = rect.half_length_m;
    const std::string shape = fmt::format(
        "polygon {{ 5, <{0},0,{1}>, <{2},0,{1}>, <{2},0,{3}>, <{0},0,{3}>, <{0},0,{1}> }}", -w, -l, w, l);
    return rect_sources(light, rect, panels_per_side(scene, light, settings), settings) +
           flat_body(light, shape, std::min(w, l));
  }
  std::string operator()(const scene::DiskShape& disk) const {
    const std::string shape = fmt::format("disc {{ <0,0,0>, <0,-1,0>, {} }}", disk.radius_m);
    return disk_sources(light, disk, settings) + flat_body(light, shape, disk.radius_m);
  }
  std::string operator()(const scene::SphereShape& sphere) const {
    return sphere_sources(light, sphere, settings) +
           fmt::format("sphere {{ <0,0,0>, {} {} {} }}\nsphere {{ <0,0,0>, {} {} {} }}\n", sphere.radius_m,
                       bright_finish(light), matrix(light.matrix), sphere.radius_m * (1 - kGap), kBlack,
                       matrix(light.matrix));
  }
  std::string operator()(const scene::PointShape&) const { return point_source(light, "", settings); }
  // Its smoothstep of the cosine is ours; the tightness would be a power of the cosine.
  std::string operator()(const scene::SpotShape& spot) const {
    const Vec3d target = transform_point(light.matrix, {}) + shining_direction(light.matrix);
    return point_source(light,
                        fmt::format("\n  spotlight radius {} falloff {} tightness 0 point_at {}",
                                    spot.inner_deg, spot.outer_deg, vector(target)),
                        settings);
  }
  std::string operator()(const scene::DirectionalShape&) const {
    return parallel_source(scene, light, settings);
  }
};

}  // namespace

std::string light_text(const scene::Scene& scene, const scene::Light& light, const PovraySettings& settings) {
  return text_of_shape(light, kName, LightWriter{scene, light, settings});
}

std::string environment_file(const std::string& stem) { return stem + "-environment.exr"; }

std::string environment_text(const scene::Scene& scene, const std::string& stem) {
  const scene::Environment& environment = scene.environment;
  std::string pigment = fmt::format("pigment {{ {} }}", colour(environment.radiance));
  if (environment.map) {
    // The middle of POV-Ray's image lies towards -X and its right quarter towards +Z.
    const Mat4 turned = turned_environment(scene).matrix * rotation_y(-90);
    pigment = fmt::format("pigment {{ image_map {{ exr \"{}\" map_type 1 interpolate 2 }} {} }}",
                          environment_file(stem), matrix(turned));
  }
  if (environment.visible_to_camera)
    return environment.map ? fmt::format("sky_sphere {{ {} }}\n", pigment)
                           : fmt::format("background {{ {} }}\n", colour(environment.radiance));
  // From no place of the scene are the directions more than 1e-4 off; POV-Ray meets nothing beyond 1e7.
  constexpr double kFar = 1e4;
  constexpr double kFarthest = 5e6;
  const auto drawn = scene::rough_bounds(scene);
  const Vec3d eye = scene.camera.position_m;
  const auto bounds = drawn ? joined(*drawn, {eye, eye}) : scene::WorldBounds{eye, eye};
  const double radius = std::min(kFar * std::max(radius_of(bounds), 1.0), kFarthest);
  return fmt::format(
      "sphere {{ <0,0,0>, 1 hollow no_image no_shadow\n"
      "  texture {{ {} finish {{ emission 1 diffuse 0 }} }} scale {} }}\n",
      pigment, radius);
}

std::string light_limit(const scene::Light& light, const std::string& display_name) {
  if (auto reason = limit_of_shape<LightWriter>(light, display_name, kName); !reason.empty()) return reason;
  if (light.ies && has_area(light.shape))
    return display_name +
           " has an IES profile: POV-Ray's light sources have no measured intensity distribution";
  if (!std::holds_alternative<scene::SphereShape>(light.shape) || scene::uniform_scale(light.matrix))
    return "";
  return display_name + " is a sphere stretched into an ellipsoid, for which POV-Ray has no light source";
}

}  // namespace orbs::adapters::povray
