#include "importer/lights.h"

#include "importer/values.h"
#include "scene/camera_frame.h"

#include <algorithm>
#include <numbers>

namespace orbs::importer {

namespace {

constexpr const char* kExtension = "KHR_lights_punctual";

// A turn and a place: the scale of a node does nothing. Ours shine along -Y, where glTF's shine along -Z.
Mat4 light_matrix(Vec3d origin, Vec3d shines_along) {
  const Vec3d y = -normalised(shines_along);
  const Vec3d x = normalised(cross(std::abs(y.x) < 0.5 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0}, y));
  const Vec3d z = cross(x, y);
  return {{x.x, y.x, z.x, origin.x, x.y, y.y, z.y, origin.y, x.z, y.z, z.z, origin.z, 0, 0, 0, 1}};
}

scene::LightShape shape_of(Import& import, const tinygltf::Light& light, const std::string& where) {
  if (light.type == "point") return scene::PointShape{};
  if (light.type == "directional") return scene::DirectionalShape{};
  if (light.type != "spot")
    refuse(import.source,
           fmt::format("{} is of the type '{}'; there are point, spot and directional", where, light.type));
  const auto degrees = [](double radians) {
    constexpr double kLeast = 0.01;
    return std::clamp(radians * 180 / std::numbers::pi, kLeast, 90.0);
  };
  const double outer = degrees(light.spot.outerConeAngle);
  const double inner = std::min(degrees(light.spot.innerConeAngle), outer);
  if (inner < outer)
    import.report.not_understood("how spots fall off between their two angles (the square of glTF)",
                                 "our smooth step, t t (3 - 2 t) in the place of t t", where);
  return scene::SpotShape{inner, outer};
}

}  // namespace

void add_lights(Import& import, const std::vector<PlacedNode>& nodes) {
  const auto& source = import.source;
  for (const PlacedNode& placed : nodes) {
    const auto& node = source.model.nodes[static_cast<std::size_t>(placed.node)];
    const auto found = node.extensions.find(kExtension);
    if (found == node.extensions.end()) continue;
    const auto node_name = place("node", node.name, static_cast<std::size_t>(placed.node));
    const int index = static_cast<int>(number_in(found->second, "light").value_or(-1));
    const auto& light = item(source, source.model.lights, index, "light", node_name);
    const auto where = place("light", light.name, static_cast<std::size_t>(index));
    const Vec3d along = transform_direction(placed.matrix, {0, 0, -1});
    const Vec3d origin = transform_point(placed.matrix, {});
    if (!(length(along) > 0) || !is_finite(along) || !is_finite(origin)) {
      import.report.not_understood("lights in nodes that are flattened by a scale of 0", "nothing",
                                   node_name);
      continue;
    }
    if (light.range > 0)
      import.report.not_understood("the range beyond which a light ends",
                                   "none: it falls off with the square", where);
    const auto& c = light.color;
    const scene::RgbColour colour =
        c.size() == 3 ? scene::RgbColour{c[0], c[1], c[2]} : scene::RgbColour{1, 1, 1};
    if (colour.x < 0 || colour.y < 0 || colour.z < 0 || light.intensity < 0)
      refuse(source, fmt::format("{} shines with ({}, {}, {}) times {}; expected none below 0", where,
                                 colour.x, colour.y, colour.z, light.intensity));
    import.scene.lights.push_back({.name = node.name.empty() ? light.name : node.name,
                                   .shape = shape_of(import, light, where),
                                   .radiance = colour * light.intensity,
                                   .matrix = light_matrix(origin, along),
                                   .ies = std::nullopt});
  }
}

void add_sky(Import& import, const std::optional<double>& radiance) {
  if (radiance) {
    import.scene.environment.radiance = {*radiance, *radiance, *radiance};
    return;
  }
  const auto& materials = import.scene.materials;
  const bool shines = std::any_of(materials.begin(), materials.end(), [](const auto& material) {
    return std::holds_alternative<scene::Emission>(material.model);
  });
  if (shines || !import.scene.lights.empty()) return;
  // A white diffuse surface that faces the light shows 0.4 + 1.8 / pi = 0.97.
  constexpr double kSky = 0.4;
  constexpr double kSun = 1.8;
  const auto frame = scene::camera_frame(import.scene.camera);
  const Vec3d along = frame.forward + frame.right * 0.6 - frame.up * 0.8;
  import.scene.environment.radiance = {kSky, kSky, kSky};
  import.scene.lights.push_back({.name = "default",
                                 .shape = scene::DirectionalShape{},
                                 .radiance = {kSun, kSun, kSun},
                                 .matrix = light_matrix({}, along),
                                 .ies = std::nullopt});
  import.report.chosen(
      fmt::format("The file has no light. It gets an even sky of radiance {} and light from "
                  "the camera's upper left of {} W/m2.",
                  kSky, kSun));
}

}  // namespace orbs::importer
