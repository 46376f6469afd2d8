#include "adapters/pbrt/lights.h"

#include "adapters/exporter.h"
#include "adapters/kind_support.h"
#include "adapters/light_frame.h"
#include "adapters/pbrt/directives.h"
#include "adapters/pbrt/profile_image.h"

#include <algorithm>

namespace orbs::adapters::pbrt {

namespace {

constexpr const char* kName = "pbrt";

// Of lights without an area the whole light source.
struct ShapeWriter {
  const Colours& colours;
  const scene::Light& light;
  const std::string& profile;  // name of its image

  // A bilinear patch in world space, corners (0,0), (1,0), (0,1), (1,1). Its normal is dp/du x dp/dv; u x v
  // of the frame is the direction in which the light shines.
  std::string operator()(const scene::RectShape& rect) const {
    const LightFrame frame = light_frame(light.matrix);
    const Vec3d u = frame.u * rect.half_width_m;
    const Vec3d v = frame.v * rect.half_length_m;
    return fmt::format("  Shape \"bilinearmesh\" \"point3 P\" [{}  {}  {}  {}]\n",
                       numbers(frame.centre - u - v), numbers(frame.centre + u - v),
                       numbers(frame.centre - u + v), numbers(frame.centre + u + v));
  }
  // pbrt takes the area of disks and spheres from the radius alone, so that the transformation must not
  // scale. Disks lie in XY and face +Z.
  std::string operator()(const scene::DiskShape& disk) const {
    const LightFrame frame = light_frame(light.matrix);
    const Vec3d x = normalised(frame.u);
    return fmt::format("  {}  Shape \"disk\" \"float radius\" {}\n",
                       transform(flat_light_matrix(frame, x, cross(frame.facing, x))),
                       disk.radius_m * length(frame.u));
  }
  // lower() lets spheres through with a uniform scale only.
  std::string operator()(const scene::SphereShape& sphere) const {
    return fmt::format("  Translate {}\n  Shape \"sphere\" \"float radius\" {}\n",
                       numbers(transform_point(light.matrix, {})),
                       sphere.radius_m * length(transform_direction(light.matrix, {1, 0, 0})));
  }
  // A light with an image has no place but that of its transformation.
  std::string operator()(const scene::PointShape&) const {
    const std::string intensity = colours.emitted("I", light.radiance, light.spectrum);
    if (light.ies)
      return fmt::format("  {}  LightSource \"goniometric\" \"string filename\" \"{}\" {}\n",
                         transform(profile_frame(light)), profile, intensity);
    return fmt::format("  LightSource \"point\" \"point3 from\" [{}] {}\n", numbers(place()), intensity);
  }
  // Its tree of lights never picks a spot whose angles are equal (cosTheta_e of LightBounds is then 1). Two
  // angles about the edge whose cosines of the difference floats tell from 1 keep the flux.
  std::string operator()(const scene::SpotShape& spot) const {
    constexpr double kLeastDelta_deg = 0.04;
    const double widened_deg = std::max(0.0, kLeastDelta_deg - (spot.outer_deg - spot.inner_deg)) / 2;
    return fmt::format(
        "  LightSource \"spot\" \"point3 from\" [{}] \"point3 to\" [{}] \"float coneangle\" {} \"float "
        "conedeltaangle\" {} {}\n",
        numbers(place()), numbers(place() + shining_direction(light.matrix)), spot.outer_deg + widened_deg,
        spot.outer_deg - spot.inner_deg + 2 * widened_deg,
        colours.emitted("I", light.radiance, light.spectrum));
  }
  std::string operator()(const scene::DirectionalShape&) const {
    return fmt::format("  LightSource \"distant\" \"point3 from\" [0 0 0] \"point3 to\" [{}] {}\n",
                       numbers(shining_direction(light.matrix)),
                       colours.emitted("L", light.radiance, light.spectrum));
  }

  Vec3d place() const { return transform_point(light.matrix, {}); }
};

}  // namespace

std::string light_limit(const scene::Light& light, const std::string& display_name) {
  if (auto reason = limit_of_shape<ShapeWriter>(light, display_name, kName); !reason.empty()) return reason;
  if (!has_area(light.shape)) return "";
  return adapters::light_limit(light, display_name, kName, "has them for points without size only");
}

std::string light_text(const Colours& colours, const scene::Light& light, const std::string& profile) {
  const std::string shape = text_of_shape(light, kName, ShapeWriter{colours, light, profile});
  if (!has_area(light.shape))
    return fmt::format("# light {}\nAttributeBegin\n{}AttributeEnd\n", comment_text(light.name), shape);
  return fmt::format(
      "# light {}\n"
      "AttributeBegin\n"
      "  Material \"diffuse\" {}\n"
      "  AreaLightSource \"diffuse\" {}\n"
      "{}AttributeEnd\n",
      comment_text(light.name), rgb("reflectance", {}), colours.radiance(light.radiance, light.spectrum),
      shape);
}

}  // namespace orbs::adapters::pbrt
