#include "adapters/hydra/lights.h"

#include "adapters/hydra/ies.h"
#include "adapters/hydra/xml.h"
#include "adapters/kind_support.h"
#include "adapters/xml_comment.h"
#include "scene/geometry/generators/round.h"

#include <cmath>
#include <numbers>

namespace orbs::adapters::hydra {

namespace {

constexpr const char* kName = "HydraCore3";

// The halves of a rectangle have each other's names there.
// Of a spot, the full angles of its cones.
struct SizeWriter {
  std::string operator()(const scene::RectShape& rect) const {
    return fmt::format("<size half_length=\"{}\" half_width=\"{}\"/>", rect.half_width_m, rect.half_length_m);
  }
  std::string operator()(const scene::DiskShape& disk) const {
    return fmt::format("<size radius=\"{}\"/>", disk.radius_m);
  }
  std::string operator()(const scene::SphereShape& sphere) const {
    return fmt::format("<size radius=\"{}\"/>", sphere.radius_m);
  }
  std::string operator()(const scene::PointShape&) const { return ""; }
  std::string operator()(const scene::SpotShape& spot) const {
    return value_node("falloff_angle", 2 * spot.outer_deg) + value_node("falloff_angle2", 2 * spot.inner_deg);
  }
  std::string operator()(const scene::DirectionalShape&) const { return ""; }
};

// Of a shape that is an area, its word is enough.
struct TypeWriter {
  std::string operator()(const scene::PointShape&) const {
    return R"(type="point" shape="point" distribution="uniform")";
  }
  std::string operator()(const scene::SpotShape&) const {
    return R"(type="point" shape="point" distribution="spot")";
  }
  std::string operator()(const scene::DirectionalShape&) const { return R"(type="directional")"; }
  template <typename Area>
  std::string operator()(const Area&) const {
    return fmt::format(R"(type="area" shape="{}")", Area::kType);
  }
};

std::string radiance_node(scene::RgbColour radiance, double multiplier) {
  return "<intensity>" + value_node("color", radiance) + value_node("multiplier", multiplier) +
         "</intensity>";
}

// It takes the area as the product of the lengths of two columns, and the third for the direction.
bool is_sheared(const scene::Light& light) {
  if (std::holds_alternative<scene::SphereShape>(light.shape) || !has_area(light.shape)) return false;
  constexpr double kRounding = 1e-6;
  const Vec3d x = transform_direction(light.matrix, {1, 0, 0});
  const Vec3d y = transform_direction(light.matrix, {0, 1, 0});
  const Vec3d z = transform_direction(light.matrix, {0, 0, 1});
  const auto are_oblique = [](Vec3d a, Vec3d b) {
    return std::abs(dot(a, b)) > kRounding * length(a) * length(b);
  };
  return are_oblique(x, y) || are_oblique(y, z) || are_oblique(x, z);
}

struct MeshOfShape {
  scene::Mesh operator()(const scene::WithoutArea auto&) const { return {}; }
  scene::Mesh operator()(const scene::RectShape& rect) const {
    scene::Mesh mesh;
    for (const double z : {-1.0, 1.0})
      for (const double x : {-1.0, 1.0})
        add_vertex(mesh, {x * rect.half_width_m, 0, z * rect.half_length_m}, {0, -1, 0},
                   {0.5 + 0.5 * x, 0.5 + 0.5 * z});
    mesh.triangles = {{0, 1, 3}, {0, 3, 2}};
    return mesh;
  }
  // 256 corners leave out 0.01 % of its area.
  scene::Mesh operator()(const scene::DiskShape& disk) const {
    constexpr std::uint32_t kCorners = 256;
    scene::Mesh mesh;
    for (std::uint32_t i = 0; i < kCorners; ++i) {
      const double angle = 2 * std::numbers::pi * i / kCorners;
      const Vec3d place{std::cos(angle), 0, std::sin(angle)};
      add_vertex(mesh, place * disk.radius_m, {0, -1, 0}, {0.5 + 0.5 * place.x, 0.5 + 0.5 * place.z});
    }
    const std::uint32_t centre = add_vertex(mesh, {}, {0, -1, 0}, {0.5, 0.5});
    for (std::uint32_t i = 0; i < kCorners; ++i) mesh.triangles.push_back({centre, i, (i + 1) % kCorners});
    return mesh;
  }
  scene::Mesh operator()(const scene::SphereShape& sphere) const {
    return scene::make_sphere({.radius_m = sphere.radius_m, .segments = 128});
  }
};

}  // namespace

std::string light_limit(const scene::Light& light, const std::string& display_name) {
  if (auto reason = limit_of_shape<SizeWriter>(light, display_name, kName); !reason.empty()) return reason;
  if (light.reflectance != scene::RgbColour{})
    return display_name + " reflects where it shines: HydraCore3's lights reflect nothing";
  if (is_sheared(light))
    return display_name + " is sheared, and HydraCore3 takes its area for that of a rectangle";
  if (light.ies)
    if (const auto reason = ies_limit(*light.ies, light.matrix); !reason.empty())
      return display_name + " " + reason;
  return "";
}

std::string light_node(const scene::Light& light,
                       int position,
                       const std::string& ies_file,
                       int bright_lights) {
  std::string inner = text_of_shape(light, kName, SizeWriter{});
  // The density of directional light leaves out the choice among lights.
  double multiplier = std::holds_alternative<scene::DirectionalShape>(light.shape) ? bright_lights : 1;
  if (light.ies) {
    multiplier = ies_grid(*light.ies->profile).peak;
    inner += fmt::format("<ies loc=\"{}\" matrix=\"{}\" point_area=\"{}\"/>", ies_file,
                         numbers(ies_matrix(*light.ies, light.matrix)), light.ies->point_area ? 1 : 0);
  }
  return xml_comment(light.name) + fmt::format("<light id=\"{}\" {}>{}{}</light>\n", position,
                                               std::visit(TypeWriter{}, light.shape), inner,
                                               radiance_node(light.radiance, multiplier));
}

std::string sky_node(const Sky& sky, int position) {
  const auto texture = [](int id) {
    return fmt::format(
        "<texture id=\"{}\" type=\"texref\" matrix=\"1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1\" "
        "addressing_mode_u=\"wrap\" addressing_mode_v=\"clamp\" input_gamma=\"1\"/>",
        id);
  };
  const std::string back = sky.back ? fmt::format("<back>{}</back>", texture(*sky.back)) : "";
  const std::string radiance = sky.map
                                   ? fmt::format("<intensity><color val=\"1 1 1\">{}</color>{}</intensity>",
                                                 texture(*sky.map), value_node("multiplier", 1))
                                   : radiance_node(sky.radiance, 1);
  return fmt::format("<light id=\"{}\" type=\"sky\">{}{}</light>\n", position, radiance, back);
}

image::Image sky_image(image::Image image) {
  const image::Image given = image;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      for (std::size_t c = 0; c < image.channels.size(); ++c)
        image.at(x, y, c) = given.at(image.width - 1 - x, y, c);
  return image;
}

scene::Mesh light_mesh(const scene::Light& light) {
  scene::Mesh mesh = std::visit(MeshOfShape{}, light.shape);
  mesh.triangle_materials.assign(mesh.triangles.size(), 0);
  return mesh;
}

}  // namespace orbs::adapters::hydra
