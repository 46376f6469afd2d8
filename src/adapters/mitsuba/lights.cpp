#include "adapters/mitsuba/lights.h"

#include "adapters/kind_support.h"
#include "adapters/light_frame.h"
#include "adapters/mitsuba/xml.h"
#include "adapters/xml_comment.h"

namespace orbs::adapters::mitsuba {

namespace {

constexpr const char* kName = "Mitsuba";

// Mitsuba's flat shapes lie in XY, [-1, 1]^2 or the unit disk, and face +Z: X goes to the image of local X, Y
// to that of local Z, Z to where the light shines. The sizes are in the columns; Z's length does not matter.
std::string flat_shape(const scene::Light& light, const char* type, double size_x, double size_z) {
  const LightFrame frame = light_frame(light.matrix);
  return fmt::format("<shape type=\"{}\">{}", type,
                     to_world(flat_light_matrix(frame, frame.u * size_x, frame.v * size_z)));
}

// Of lights without an area the whole emitter.
struct ShapeWriter {
  const Colours& colours;
  const scene::Light& light;

  std::string operator()(const scene::RectShape& rect) const {
    return flat_shape(light, "rectangle", rect.half_width_m, rect.half_length_m);
  }
  std::string operator()(const scene::DiskShape& disk) const {
    return flat_shape(light, "disk", disk.radius_m, disk.radius_m);
  }
  // lower() lets spheres through with a uniform scale only.
  std::string operator()(const scene::SphereShape& sphere) const {
    const double radius_m = sphere.radius_m * length(transform_direction(light.matrix, {1, 0, 0}));
    const Vec3d centre = transform_point(light.matrix, {});
    return fmt::format(
        "<shape type=\"sphere\"><point name=\"center\" x=\"{}\" y=\"{}\" z=\"{}\"/><float "
        "name=\"radius\" value=\"{}\"/>",
        centre.x, centre.y, centre.z, radius_m);
  }
  std::string operator()(const scene::PointShape&) const {
    return fmt::format("<emitter type=\"point\">{}{}</emitter>",
                       vector_element("point", "position", transform_point(light.matrix, {})),
                       colours.emitted("intensity", light.radiance, light.spectrum));
  }
  // Mitsuba's falls linearly with the angle between its two, so that light_limit lets hard edges through
  // only. It shines along +Z.
  std::string operator()(const scene::SpotShape& spot) const {
    const Vec3d axis = shining_direction(light.matrix);
    const Vec3d aside = std::abs(axis.x) < 0.5 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0};
    const Vec3d x = normalised(cross(axis, aside));
    const LightFrame frame{transform_point(light.matrix, {}), {}, {}, axis};
    return fmt::format(
        "<emitter type=\"spot\">{}<float name=\"cutoff_angle\" value=\"{}\"/><float name=\"beam_width\" "
        "value=\"{}\"/>{}</emitter>",
        to_world(flat_light_matrix(frame, x, cross(axis, x))), spot.outer_deg, spot.inner_deg,
        colours.emitted("intensity", light.radiance, light.spectrum));
  }
  std::string operator()(const scene::DirectionalShape&) const {
    return fmt::format("<emitter type=\"directional\">{}{}</emitter>",
                       vector_element("vector", "direction", shining_direction(light.matrix)),
                       colours.emitted("irradiance", light.radiance, light.spectrum));
  }

  static std::string vector_element(const char* type, const char* name, Vec3d v) {
    return fmt::format("<{} name=\"{}\" x=\"{}\" y=\"{}\" z=\"{}\"/>", type, name, v.x, v.y, v.z);
  }
};

}  // namespace

std::string area_emitter(const Colours& colours,
                         scene::RgbColour radiance,
                         const std::optional<scene::SpectrumUse>& spectrum) {
  return fmt::format("<emitter type=\"area\">{}</emitter>", colours.radiance(radiance, spectrum));
}

image::Image rows_on_poles(const image::Image& image) {
  auto out = image::make_image(image.width, 2 * image.height + 1, image.channels);
  for (int y = 0; y < out.height; ++y) {
    const int above = std::max((y - 1) / 2, 0);
    const int below = std::min(y / 2, image.height - 1);
    for (int x = 0; x < image.width; ++x)
      for (std::size_t c = 0; c < image.channels.size(); ++c)
        out.at(x, y, c) = (image.at(x, above, c) + image.at(x, below, c)) / 2;
  }
  return out;
}

std::string environment_map(const std::string& file, const Mat4& matrix) {
  return fmt::format("<emitter type=\"envmap\"><string name=\"filename\" value=\"{}\"/>{}</emitter>\n", file,
                     to_world(matrix * rotation_y(180)));
}

std::string light_limit(const scene::Light& light, const std::string& display_name) {
  if (auto reason = limit_of_shape<ShapeWriter>(light, display_name, kName); !reason.empty()) return reason;
  if (const auto* spot = std::get_if<scene::SpotShape>(&light.shape))
    if (spot->inner_deg < spot->outer_deg)
      return display_name + " has a soft edge: Mitsuba's spots fall linearly with the angle";
  return adapters::light_limit(light, display_name, kName,
                               "has no light with a measured intensity distribution");
}

std::string light_text(const Colours& colours, const scene::Light& light) {
  const std::string shape = text_of_shape(light, kName, ShapeWriter{colours, light});
  if (!has_area(light.shape)) return xml_comment(light.name) + shape + "\n";
  return fmt::format("{}{}<bsdf type=\"diffuse\">{}</bsdf>{}</shape>\n", xml_comment(light.name), shape,
                     colours.surface("reflectance", light.reflectance),
                     area_emitter(colours, light.radiance, light.spectrum));
}

}  // namespace orbs::adapters::mitsuba
