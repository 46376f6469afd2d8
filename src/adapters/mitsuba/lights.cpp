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

struct ShapeWriter {
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
};

}  // namespace

std::string area_emitter(const Colours& colours,
                         scene::RgbColour radiance,
                         const std::optional<scene::SpectrumUse>& spectrum) {
  return fmt::format("<emitter type=\"area\">{}</emitter>", colours.radiance(radiance, spectrum));
}

std::string light_limit(const scene::Light& light, const std::string& display_name) {
  if (auto reason = limit_of_shape<ShapeWriter>(light, display_name, kName); !reason.empty()) return reason;
  return adapters::light_limit(light, display_name, kName,
                               "has no light with a measured intensity distribution");
}

std::string light_text(const Colours& colours, const scene::Light& light) {
  return fmt::format("{}{}<bsdf type=\"diffuse\">{}</bsdf>{}</shape>\n", xml_comment(light.name),
                     text_of_shape(light, kName, ShapeWriter{light}),
                     colours.surface("reflectance", light.reflectance),
                     area_emitter(colours, light.radiance, light.spectrum));
}

}  // namespace orbs::adapters::mitsuba
